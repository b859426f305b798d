# ruff: noqa: S603, T201  it runs an interpreter, and prints what that says
"""Lets the rover's program run for simulated days with stations that come, go, move and ask, and with hostile bytes.

`make soak` takes a week in MicroPython, some half an hour, and beside it a day in the MicroPython whose words have 32
bits. Both clocks wrap meanwhile. Every pass of the main loop is done: it is the firmware of generated/, with the bench
of its generated suite. In each hour each stream has to have its rate, each question its answer, the numbers of the
frames no gap, and the heap has to stay as it is.
"""

import argparse
import json
import os
import subprocess
import sys
import threading
import time
from pathlib import Path

import measure
from whole_program import module_folders

SCRIPT = measure.HERE / "micropython" / "soak_stations.py"
SETTLED_HOURS = 2
"""The heap of the first hours is not compared: what is used the first time is loaded then."""


def main() -> int:
    """Run the interpreters beside each other; 1 where one of them found a fault."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--hours", type=int, default=168, help="simulated ones")
    parser.add_argument("--hours32", type=int, default=24, help="simulated ones with words of 32 bits; 0 for none")
    parser.add_argument("--seed", type=int, default=1, help="of the hostile bytes")
    parser.add_argument("--hour", type=int, default=3600, metavar="SECONDS", help="after which all is compared")
    parser.add_argument("--firmware", type=Path, default=measure.ROOT / "generated", help="the folder of a build")
    arguments = parser.parse_args()
    given = {"micropython": arguments.hours, "micropython32": arguments.hours32}
    outcomes = dict.fromkeys(name for name, hours in given.items() if hours)

    def take(name: str) -> None:
        outcomes[name] = soaked(name, given[name], arguments)

    threads = [threading.Thread(target=take, args=(name,)) for name in outcomes]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return 0 if all(outcomes.values()) else 1


def soaked(interpreter: str, hours: int, arguments: argparse.Namespace) -> bool:
    """Run so many hours, tell about each day, and return whether nothing was wrong."""
    folders = map(str, module_folders(arguments.firmware, "tests", "firmware", "mocks"))
    environment = {**os.environ, "MICROPYPATH": os.pathsep.join((*folders, ".frozen"))}
    command = [measure.tool(interpreter), "-X", "heapsize=16m", str(SCRIPT)]
    command += [str(number) for number in (hours, SETTLED_HOURS, arguments.seed, arguments.hour)]
    started = time.monotonic()
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment) as run:
        last = ""
        for line in run.stdout or ():
            last = line
            found = _read(line)
            if found and "hour" in found and found["hour"] % 24 == 0:
                print(f"{interpreter}: day {found['hour'] // 24}, {found['heap']} bytes in use", flush=True)
    found = _read(last)
    if run.returncode or found is None:
        print(f"{interpreter}: ended before its time: {last.strip()}")
        return False
    minutes = (time.monotonic() - started) / 60
    print(f"{interpreter}: {hours} simulated hours in {minutes:.1f} minutes, {len(found['faults'])} faults")
    for fault in found["faults"]:
        print(f"  {fault}")
    return not found["faults"]


def _read(line: str) -> dict[str, object] | None:
    try:
        found = json.loads(line)
    except ValueError:
        return None
    return found if isinstance(found, dict) else None


if __name__ == "__main__":
    sys.exit(main())
