#!/usr/bin/env python3
"""What the services may do, as systemd-analyze judges it: an exposure of at most 2.0, the agent's also with serial ports.

check_unit.py FOLDER, that of the units. Skipped where systemd-analyze is not installed. A unit without its protections
is shown to exceed the limit.
"""

import configparser
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

LIMIT = 2.0
SKIPPED = 77  # the exit status that ctest takes for a skip
AGENT, GATEWAY, DROP_IN = "skyseal-air.service", "skyseal-gateway.service", "skyseal-air-serial.conf"


def exposure(name, unit, drop_in=None):
    """The overall exposure level of a unit's text, from 0 to 10."""
    with tempfile.TemporaryDirectory() as root:
        folder = pathlib.Path(root, "etc/systemd/system")
        (folder / f"{name}.d").mkdir(parents=True)
        (folder / name).write_text(unit)
        if drop_in:
            (folder / f"{name}.d" / DROP_IN).write_text(drop_in)
        report = subprocess.run(["systemd-analyze", "security", "--no-pager", "--offline=yes", f"--root={root}", name],
                                capture_output=True, text=True)
    level = re.search(r"Overall exposure level for \S+: ([\d.]+)", report.stdout)
    if not level:
        raise SystemExit(f"systemd-analyze security: {report.stdout}{report.stderr}")
    return float(level[1])


def settings(text):
    """The last value of each setting of the section [Service]."""
    parser = configparser.ConfigParser(strict=False, interpolation=None, delimiters="=")
    parser.optionxform = str
    parser.read_string(text)
    return parser["Service"]


def uncounted(service, user):
    """What is wrong with the settings that the exposure does not count."""
    wanted = {"User": user, "LimitCORE": "0", "CapabilityBoundingSet": "", "DevicePolicy": "closed"}
    out = [f"{name}={service.get(name)}, where {name}={value} is expected"
           for name, value in wanted.items() if service.get(name) != value]
    if "LimitMEMLOCK" not in service:
        out.append("LimitMEMLOCK is missing: keys might be written to the swap space")
    return out


def main():
    if not shutil.which("systemd-analyze"):
        print("systemd-analyze is not installed: the exposure of the service is not judged")
        return SKIPPED
    folder = pathlib.Path(sys.argv[1])
    drop_in = (folder / DROP_IN).read_text()
    user = re.search(r"^u (\S+) ", (folder / "sysusers.conf").read_text(), re.M)[1]
    failures = []
    for name in (AGENT, GATEWAY):
        unit = (folder / name).read_text()
        levels = {"as installed": exposure(name, unit), "bare": exposure(name, unit[:unit.index("# A fixed user")])}
        if name == AGENT:
            levels["with serial ports"] = exposure(name, unit, drop_in)
        print(name, ", ".join(f"{case}: {level}" for case, level in levels.items()))
        failures += [f"{name} {case}: exposure {level}, more than {LIMIT}" for case, level in levels.items()
                     if case != "bare" and level > LIMIT]
        if levels["bare"] <= LIMIT:
            failures.append(f"{name}: a unit without protections passes as well")
        failures += [f"{name}: {problem}" for problem in uncounted(settings(unit), user)]
    devices = re.findall(r"^DeviceAllow=(\S+)", drop_in, re.M)
    if not devices or not all(device.startswith("char-tty") for device in devices):
        failures.append(f"the drop-in for serial ports admits {devices}")
    for failure in failures:
        print(f"FAIL!  : {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
