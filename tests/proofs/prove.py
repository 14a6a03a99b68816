#!/usr/bin/env python3
"""Runs the models of core/channel/proofs and checks that each property holds, or is violated, as the model's head says.

    prove.py [--cpu-seconds N] MODEL [DEFINITION…]    all runs of MODEL, or only those with these definitions

With --cpu-seconds, all runs together may take so much processor time, which does not depend on what else the machine does.

A head has one line for each run: "run DEFINITIONS holds" or "run DEFINITIONS violates PROPERTIES", then a remark after two or
more spaces. PROPERTIES are names, or "all", or "all but" names. Models end in .pml (Spin, compiled by gcc) or .pv (ProVerif:
the program PROVERIF or `proverif`). Without its program a model is skipped.
"""

import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

RUN = re.compile(r"^ *run\b *(?P<definitions>[A-Z0-9_= ]*?) *(?P<verdict>holds|violates)"
                 r"(?: +(?P<all>all(?: but)?\b)?(?P<names> *\w+(?:, \w+)*)?)?(?: *$|  )", re.M)
LONGEST = 120  # seconds for one run
SKIPPED = 77   # the exit status that ctest takes for a skip


class Failure(Exception):
    pass


@dataclass
class Run:
    definitions: list
    violates: set  # names of properties
    but: bool      # all, except for those

    def __str__(self):
        return " ".join(self.definitions) or "(the protocol)"

    def violated_of(self, names):
        return set(names) - self.violates if self.but else self.violates


def runs_of(text):
    return [Run(run["definitions"].split(), set(re.findall(r"\w+", run["names"] or "")), bool(run["all"]))
            for run in RUN.finditer(text)]


def command(*words, folder=None):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=LONGEST)
    return done.returncode, done.stdout + done.stderr


def check_spin(model, run, folder):
    """Explores the whole state space. A mutant has the checks of its property alone, so that no other fails first."""
    definitions = ["-D" + definition for definition in run.definitions]
    for violated in run.violates:
        definitions.append("-DCHECKED=" + violated)
    status, output = command("spin", "-a", *definitions, str(model), folder=folder)
    if status != 0 or "rror" in output:
        raise Failure(output)
    status, output = command("gcc", "-O0" if run.violates else "-O2", "-w", "-DSAFETY", "-DNOREDUCE", "-o", "pan", "pan.c",
                             folder=folder)
    if status != 0:
        raise Failure(output)
    _, output = command("./pan", "-m100000", "-w22", "-n", "-E", folder=folder)
    errors = re.search(r"errors: (\d+)", output)
    states = re.search(r"(\S+) states, stored", output)
    if not errors or not states or "depth too small" in output or (not run.violates and "not completed" in output):
        raise Failure(output)
    violation = re.search(r"assertion violated (.*)", output)
    if run.violates and not violation:
        raise Failure("no violation of " + ", ".join(run.violates) + " was found\n" + output)
    if not run.violates and errors[1] != "0":
        raise Failure(output)
    return " ".join(["violates", *run.violates]) + f", {float(states[1]):,.0f} states" if run.violates \
        else f"holds, {float(states[1]):,.0f} states"


def check_proverif(model, run, folder):
    """Each query of the model has its name in a comment before it: (* name: … *)."""
    definitions = ["-D" + definition for definition in run.definitions]
    _, text = command("gcc", "-E", "-P", "-C", "-w", "-x", "c", *definitions, str(model))
    names = re.findall(r"^\(\* (\w+):", text, re.M)
    source = Path(folder, "model.pv")
    source.write_text(re.sub(r"/\*.*?\*/", "", text, flags=re.S))
    _, output = command(proverif(), str(source))
    output = output.partition("Verification summary:")[2] or output[-2000:]
    results = re.findall(r"(is true|is false|cannot be proved)\.$", output, re.M)
    if len(results) != len(names) or not names:
        raise Failure(f"{len(names)} queries, {len(results)} results\n{output}")
    verdicts = dict(zip(names, results))
    if violated := {name for name in names if verdicts[name] != "is true"} ^ run.violated_of(names):
        raise Failure("\n".join(f"{name} {verdicts.get(name, 'is not asked')}" for name in sorted(violated)) + "\n" + output)
    unproved = [name for name in names if verdicts[name] == "cannot be proved"]
    if unproved and not re.search(r"choice\[|weaksecret", text):  # ProVerif need not find how two processes differ
        raise Failure("cannot be proved: " + ", ".join(unproved) + "\n" + output)
    false = len(run.violated_of(names))
    return f"{len(names) - false} queries true, {false} false"


def proverif():
    return os.environ.get("PROVERIF") or shutil.which("proverif")


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main(model, wanted, most_seconds):
    check = check_spin if model.suffix == ".pml" else check_proverif
    if not (shutil.which("spin") if check is check_spin else proverif()):
        print(f"what checks {model.name} is not installed")
        return SKIPPED
    runs = [run for run in runs_of(model.read_text()) if not wanted or run.definitions == wanted]
    if not runs:
        raise SystemExit(f"{model} describes no such run")
    failed = 0
    for run in runs:
        began = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            try:
                outcome = check(model, run, folder)
            except (Failure, subprocess.TimeoutExpired) as failure:
                failed += 1
                outcome = f"NOT AS EXPECTED\n{failure}"
        print(f"{time.monotonic() - began:6.1f} s  {run}: {outcome}", flush=True)
    print(f"{processor_seconds():.1f} s of processor time in all" + (f", of {most_seconds}" if most_seconds else ""))
    return 1 if failed or (most_seconds and processor_seconds() > most_seconds) else 0


if __name__ == "__main__":
    arguments = sys.argv[1:]
    most = int(arguments[1]) if arguments[0] == "--cpu-seconds" else None
    arguments = arguments[2:] if most else arguments
    sys.exit(main(Path(arguments[0]).resolve(), arguments[1:], most))
