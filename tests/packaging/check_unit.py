#!/usr/bin/env python3
"""What the service of the agent may do, as systemd-analyze judges it: an exposure of at most 2.0, also with serial ports.

check_unit.py FOLDER, that of skyseal-air.service. Skipped where systemd-analyze is not installed. A unit without its protections
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
UNIT, DROP_IN = "skyseal-air.service", "skyseal-air-serial.conf"


def exposure(unit, drop_in=None):
    """The overall exposure level of a unit's text, from 0 to 10."""
    with tempfile.TemporaryDirectory() as root:
        folder = pathlib.Path(root, "etc/systemd/system")
        (folder / f"{UNIT}.d").mkdir(parents=True)
        (folder / UNIT).write_text(unit)
        if drop_in:
            (folder / f"{UNIT}.d" / DROP_IN).write_text(drop_in)
        report = subprocess.run(["systemd-analyze", "security", "--no-pager", "--offline=yes", f"--root={root}", UNIT],
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


def main():
    if not shutil.which("systemd-analyze"):
        print("SKIP   : Unit::exposure() systemd-analyze is not installed: the exposure of the service is not judged")
        return SKIPPED
    folder = pathlib.Path(sys.argv[1])
    unit, drop_in = (folder / UNIT).read_text(), (folder / DROP_IN).read_text()
    user = re.search(r"^u (\S+) ", (folder / "sysusers.conf").read_text(), re.M)[1]
    bare = unit[:unit.index("# A fixed user")]

    levels = {"as installed": exposure(unit), "with serial ports": exposure(unit, drop_in), "bare": exposure(bare)}
    print(", ".join(f"{name}: {level}" for name, level in levels.items()))
    failures = [f"{name}: exposure {level}, more than {LIMIT}" for name, level in levels.items()
                if name != "bare" and level > LIMIT]
    if levels["bare"] <= LIMIT:
        failures.append("a unit without protections passes as well")
    service = settings(unit)
    # Settings that the exposure does not count.
    for name, wanted in {"User": user, "LimitCORE": "0", "CapabilityBoundingSet": "", "DevicePolicy": "closed"}.items():
        if service.get(name) != wanted:
            failures.append(f"{name}={service.get(name)}, where {name}={wanted} is expected")
    if "LimitMEMLOCK" not in service:
        failures.append("LimitMEMLOCK is missing: keys might be written to the swap space")
    devices = re.findall(r"^DeviceAllow=(\S+)", drop_in, re.M)
    if not devices or not all(device.startswith("char-tty") for device in devices):
        failures.append(f"the drop-in for serial ports admits {devices}")
    for failure in failures:
        print(f"FAIL!  : {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
