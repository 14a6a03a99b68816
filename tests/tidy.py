#!/usr/bin/env python3
"""tidy.py BUILD [FOLDER…]: runs clang-tidy over the sources that BUILD/compile_commands.json lists, in core, ui and app or in
the given folders.

Most of clang-tidy's time goes into the headers, so sources with the same compiler options are checked together, as one file
that includes them. Sources that do not compile together, because they define the same local name, are divided and checked
again. Prints only findings; the exit status is 1 if there are any.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

BATCH = 16
ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(sys.argv[1]).resolve()
FOLDERS = [ROOT / folder for folder in sys.argv[2:] or ("core", "ui", "app")]
TOGETHER = BUILD / "tidy"  # the files that include the sources, and the empty output of moc


def options(entry):
    """The compiler options of a source without compiler cache, compiler, input and output."""
    words = shlex.split(entry["command"])
    words = words[next(i for i, word in enumerate(words) if "clang++" in word) + 1:]
    words = words[:words.index("-c")]
    at = words.index("-o")
    return tuple(words[:at] + words[at + 2:])


def batches():
    sources = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["file"])
        if any(source.is_relative_to(folder) for folder in FOLDERS):
            sources.setdefault(options(entry), []).append(source)
    for flags, group in sources.items():
        for start in range(0, len(group), BATCH):
            yield flags, group[start:start + BATCH]


def check(flags, sources):
    """The findings in these sources, as text."""
    # No check needs the output of moc, which the sources of classes with a Q_OBJECT include.
    for source in sources:
        for moc in re.findall(r'^#include "(\w+\.moc|moc_\w+\.cpp)"', source.read_text(), re.M):
            (TOGETHER / moc).touch()
    name = "_".join(sources[0].relative_to(ROOT).parts)
    together = TOGETHER / f"{len(sources)}_{name}"
    together.write_text("".join(f'#include "{source}"\n' for source in sources))
    done = subprocess.run(["clang-tidy-14", "--quiet", "--config-file", ROOT / ".clang-tidy", together, "--", *flags,
                           f"-I{TOGETHER}"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if "clang-diagnostic-error" in done.stdout and len(sources) > 1:
        middle = len(sources) // 2
        return check(flags, sources[:middle]) + check(flags, sources[middle:])
    if done.returncode != 0 and not done.stdout:
        return done.stderr
    return done.stdout


TOGETHER.mkdir(exist_ok=True)
failed = False
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for found in pool.map(lambda batch: check(*batch), batches()):
        failed = failed or bool(found)
        print(found, end="", flush=True)
sys.exit(failed)
