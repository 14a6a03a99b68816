#!/usr/bin/env python3
"""A build with SKYSEAL_RESEARCH=OFF: the self-test passes, nothing that exists for comparison only is offered or accepted, and its
programs fly with those of a build that has it.

check_flight.py FLIGHT-PROGRAMS RESEARCH-PROGRAMS, two folders.
"""

import contextlib
import json
import pathlib
import re
import socket
import subprocess
import sys
import tempfile

RESEARCH_OPTIONS = ["--allow-research", "--allow-plain", "--allow-inline"]
RESEARCH_WORDS = r"rc4|inline|mavsec|allow-(research|plain|inline)|--secure|\bnone\b"


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=60)
    return done.returncode, done.stdout + done.stderr


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def make_keys(cli, folder):
    for name in ("air", "ground"):
        run(cli, "keys", "new", "--out", folder / f"{name}.key")
    for own, other in (("air", "ground"), ("ground", "air")):
        status, text = run(cli, "keys", "show", folder / f"{other}.key")
        public = re.search(r"skyseal:\S+", text)
        status, text = run(cli, "keys", "peers", "add", "--peers", folder / f"{own}.peers", "--name", other, public[0])
        if status != 0:
            raise SystemExit(f"keys peers add: {text}")


def fly(air, station, air_options, station_options, monitor_options=()):
    """Runs simulator, agent and monitor of these folders for some seconds. Returns the events of the monitor."""
    with tempfile.TemporaryDirectory() as name, contextlib.ExitStack() as stack:
        folder, vehicle, ground = pathlib.Path(name), free_port(), free_port()
        make_keys(station / "skyseal-cli", folder)
        for command in (
                [air / "skyseal-sim", "--link", f"udpout:127.0.0.1:{vehicle}"],
                [air / "skyseal-air", "--vehicle", f"udpin:{vehicle}", "--ground", f"udpout:127.0.0.1:{ground}",
                 "--identity", folder / "air.key", "--peers", folder / "air.peers", *air_options]):
            process = stack.enter_context(subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
            stack.callback(process.terminate)
        monitor = subprocess.run(
            [station / "skyseal-cli", "monitor", "--link", f"udpin:127.0.0.1:{ground}", "--identity", folder / "ground.key",
             "--peers", folder / "ground.peers", "--no-record", "--json", "--duration", "6", *station_options,
             *monitor_options], capture_output=True, text=True, timeout=60)
        return [json.loads(line) for line in monitor.stdout.splitlines() if line.startswith("{")]


def check_help(flight, research):
    """The help of each command names no part of research in the flight build, and does in the other."""
    found = 0
    for command in (["skyseal-air"], ["skyseal-sim"], ["skyseal-cli", "monitor"], ["skyseal-cli", "sweep"], ["skyseal-cli", "decode"]):
        for folder, wanted in ((flight, False), (research, True)):
            status, text = run(folder / command[0], *command[1:], "--help")
            if status != 0:
                yield f"{command}: --help ends with {status}"
            words = sorted({word[0].lower() for word in re.finditer(RESEARCH_WORDS, text, re.I)})
            if words and not wanted:
                yield f"{' '.join(command)} --help names {', '.join(words)}"
            found += bool(words) and wanted
    if found < 3:
        yield "the words of research are not found where they are: the check is blind"


def check_refusals(flight):
    for option in RESEARCH_OPTIONS:
        status, text = run(flight / "skyseal-air", option)
        if status != 2 or "nknown option" not in text:
            yield f"skyseal-air {option}: status {status}, {text}"
    status, text = run(flight / "skyseal-cli", "monitor", "--link", "udpin:127.0.0.1:0")
    if status != 2 or "--identity" not in text:
        yield f"a monitor without keys, which shows plain MAVLink: status {status}, {text}"
    status, text = run(flight / "skyseal-cli", "sweep", "--suites", "rc4,none", "--out", "/nonexistent")
    if status != 2:
        yield f"a sweep of rc4 and none: status {status}, {text}"


def check_flights(flight, research):
    consent = ["--allow-research", "--allow-inline"]
    for name, air, station, air_options, station_options in (
            ("both without research", flight, flight, [], []),
            ("the agent without research", flight, research, [], ["--allow-research", "--framing", "inline"]),
            ("the station without research", research, flight, [*consent, "--allow-plain"], [])):
        events = fly(air, station, air_options, station_options)
        sessions = [event for event in events if event["event"] == "session"]
        if not any(event.get("state", "up") == "up" for event in sessions):
            yield f"{name}: no session among {len(events)} events"
        text = json.dumps(sessions)
        for word in ("rc4", '"inline"', '"none"'):
            if word in text:
                yield f"{name}: a session with {word}: {text}"


def main():
    flight, research = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
    problems = list(check_help(flight, research)) + list(check_refusals(flight))
    status, text = run(flight / "skyseal-cli", "selftest")
    if status != 0:
        problems.append(f"selftest: {text}")
    for folder, wanted in ((flight, False), (research, True)):
        if bool(re.search(rb"(?<![A-Za-z0-9_])rc4(?![A-Za-z0-9_])", (folder / "skyseal-air").read_bytes())) != wanted:
            problems.append(f"{folder}/skyseal-air {'lacks' if wanted else 'contains'} the name rc4")
    problems += check_flights(flight, research)
    for problem in problems:
        print(f"FAIL!  : {problem}")
    print(f"the build without research: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
