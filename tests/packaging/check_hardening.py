#!/usr/bin/env python3
"""Reads from the built files that the options of cmake/SkysealHardening.cmake have taken effect.

check_hardening.py [--debug] --programs FILE … --libraries FILE … --commands compile_commands.json

Programs are read with readelf: position-independent, read-only relocations, all symbols bound at start, no executable stack and
no segment that is writable and executable, stack protector, fortified calls. The static libraries, which hold all code of ours
but main(), show whether each object has marks for indirect branches; a program has that mark only if the C library's start files
have it too. Stack clash protection leaves no mark, so that the commands of the compiler are read. Each check is also shown to fail
on the same text without its evidence.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

SOURCES = pathlib.Path(__file__).resolve().parents[2]
ARCHITECTURE_MARKS = {"X86-64": "IBT, SHSTK", "AArch64": "BTI, PAC"}


def readelf(*arguments):
    return subprocess.run(["readelf", *arguments], check=True, capture_output=True, text=True,
                          env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"}).stdout


def checks_of_programs(debug):
    """Name of a protection, and the evidence for it in the output of readelf: a pattern that must be found."""
    checks = {
        "PIE": r"^ *Type: +DYN \(Position-Independent",
        "RELRO": r"^ *GNU_RELRO ",
        "all symbols bound at start": r"\(FLAGS\) +BIND_NOW|\(FLAGS_1\) +Flags: NOW",
        "no executable stack": r"^ *GNU_STACK .* RW +0",
        "stack protector": r"__stack_chk_fail",
    }
    if not debug:
        checks["fortified calls"] = r"__(mem|str|stp|v?s?n?f?printf|read|recv|poll|fd)\w*_chk"
    return checks


def missing_in_program(text, checks):
    missing = [name for name, evidence in checks.items() if not re.search(evidence, text, re.M)]
    if re.search(r"^ *LOAD .* RWE +0x", text, re.M):
        missing.append("no writable and executable segment")
    return missing


def check_program(path, debug):
    text = readelf("-hldW", "--dyn-syms", str(path))
    checks = checks_of_programs(debug)
    problems = [f"{path.name}: missing: {name}" for name in missing_in_program(text, checks)]
    for name, evidence in checks.items():
        if name not in missing_in_program(re.sub(evidence, "", text, flags=re.M), checks):
            problems.append(f"{path.name}: the check for {name} cannot fail")
    if "no writable and executable segment" not in missing_in_program(re.sub(r"(LOAD .*) R E ", r"\1 RWE ", text), checks):
        problems.append(f"{path.name}: the check for writable and executable segments cannot fail")
    return problems


def unmarked_objects(text, mark):
    """Objects of a library whose notes lack the mark, by their names."""
    objects = re.split(r"^File: .*\((.*)\)$", text, flags=re.M)[1:]
    return [name for name, notes in zip(objects[::2], objects[1::2]) if mark not in notes]


def check_library(path):
    machine = re.search(r"Machine: .*(X86-64|AArch64)", readelf("-h", str(path)))
    if not machine:
        return []
    mark = ARCHITECTURE_MARKS[machine[1]]
    text = readelf("-nW", str(path))
    problems = [f"{path.name}({name}): indirect branches are not marked" for name in unmarked_objects(text, mark)]
    if not unmarked_objects(text.replace(mark, "", 1), mark):
        problems.append(f"{path.name}: the check for marks of indirect branches cannot fail")
    return problems


def check_commands(path):
    """The sources of core, app and ui, alone or several as one; the generator of the MAVLink tables runs during the build only."""
    seen, without = 0, []
    for entry in json.loads(path.read_text()):
        source = pathlib.Path(entry["file"])
        top = path.resolve().parent if "Unity" in source.parts else SOURCES
        if not source.is_relative_to(top) or source.relative_to(top).parts[0] not in ("core", "app", "ui"):
            continue
        if "generator" in source.parts:
            continue
        seen += 1
        if "-fstack-clash-protection" not in entry["command"]:
            without.append(f"{source.relative_to(top)}: compiled without stack clash protection")
    return without if seen > 50 else [f"{path}: only {seen} sources were found"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--debug", action="store_true")
    parser.add_argument("--programs", nargs="+", type=pathlib.Path, required=True)
    parser.add_argument("--libraries", nargs="+", type=pathlib.Path, required=True)
    parser.add_argument("--commands", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    problems = check_commands(arguments.commands)
    for program in arguments.programs:
        problems += check_program(program, arguments.debug)
    for library in arguments.libraries:
        problems += check_library(library)
    for problem in problems:
        print(f"FAIL!  : {problem}")
    print(f"{len(arguments.programs)} programs and {len(arguments.libraries)} libraries: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
