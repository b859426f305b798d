# Generated from templates/tests/program/test_program.py: do not edit.
# Inputs: eb99a64611f6bf7b
"""The checks of the program, each script in one run of each interpreter; a test is named by its check and criterion."""

import ast
import json
import os
import socket
import subprocess
import time
from functools import cache

import pytest
from interpreters import HERE, PATHS, micropython, run_under
from program_facts import REQUIREMENTS

HEAP = "128wk"  # what the program has to do with, in words of the board (w), which are half of a host's; FR-00071.4
LONG = ("day", "heap")  # simulated days: they take longer than all others together
ONLY_MICROPYTHON = ("heap", "steady")  # what they measure, CPython does not have


def _checks(script):
    """Return criterion and name of each check of a script, without running it."""
    module = ast.parse((HERE / f"{script}_checks.py").read_text())
    for statement in module.body:
        if isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == "CHECKS":
            for topic, number, check in (entry.elts for entry in statement.value.elts):
                document = REQUIREMENTS.get(topic.value, "")
                yield f"{document}.{number.value}" if document else topic.value, check.id


def _cases():
    scripts = sorted(path.name.removesuffix("_checks.py") for path in HERE.glob("*_checks.py"))
    for script in sorted(scripts, key=lambda name: name in LONG):
        for interpreter in ("cpython", "micropython"):
            if interpreter == "micropython" or script not in ONLY_MICROPYTHON:
                for criterion, name in _checks(script):
                    case = f"{interpreter}-{script}-{name}-{criterion}"
                    yield pytest.param(interpreter, script, name, id=case)


@pytest.fixture(scope="session")
def outcomes(request, tmp_path_factory):
    """What came of the checks of a script, which runs once, however many processes pytest-xdist lets ask."""
    base = tmp_path_factory.getbasetemp()
    shared = base.parent if hasattr(request.config, "workerinput") else base  # of all workers of this run

    @cache
    def of(interpreter, script):
        path = shared / f"{interpreter}-{script}.json"
        try:
            os.close(os.open(path.with_suffix(".started"), os.O_CREAT | os.O_EXCL))
        except FileExistsError:
            return _awaited(path)
        with socket.socket(type=socket.SOCK_DGRAM) as free:
            free.bind(("127.0.0.1", 0))
            number = free.getsockname()[1]  # of a UDP port that nobody has
        try:
            text = run_under(interpreter, f"{script}_checks.py", str(number))
        except AssertionError as error:  # who waits for it is told, too
            text = json.dumps({"": str(error)})
        path.with_suffix(".part").write_text(text)
        path.with_suffix(".part").replace(path)
        return json.loads(text)

    return of


def _awaited(path):
    end = time.monotonic() + 200
    while not path.exists():
        assert time.monotonic() < end, f"{path} does not come"
        time.sleep(0.05)
    return json.loads(path.read_text())


@pytest.mark.parametrize(("interpreter", "script", "name"), list(_cases()))
def test_program(interpreter, script, name, outcomes):
    """The vehicle does what the criterion says."""
    found = outcomes(interpreter, script)
    assert "" not in found, found[""]
    outcome = found[name]
    if outcome is not None and outcome.startswith("left out: "):
        pytest.skip(outcome)
    assert outcome is None, outcome


def test_small_heap(tmp_path):
    """The program starts and runs in the heap that it has to do with, FR-00071.4."""
    environment = {**os.environ, "MICROPYPATH": os.pathsep.join([*PATHS, ".frozen"])}
    command = [micropython(), "-X", f"heapsize={HEAP}", str(HERE / "small_heap.py")]
    done = subprocess.run(
        command,
        capture_output=True,
        text=True,
        errors="replace",
        env=environment,
        cwd=tmp_path,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    assert "ran" in done.stdout, done.stdout
