# Generated from templates/tests/conftest.py: do not edit.
# Inputs: 38eee584095399b8
"""Runs the cases and checks of this suite, once for each interpreter, and marks the tests for their results.

A test is marked with the criteria that it shows. Results in JUnit's format (pytest --junit-xml) have them as properties
called requirement, and in codegen-inputs the hash of the specification that the tests were made of.
"""

import gc
import json
import os
import re
import threading
import time

import pytest
from interpreters import CASES, HERE, LARGE_HEAP, files, path_of, told_by
from selection import note

GOES_ON_S = 2  # who makes a result says so as often
GONE_S = 60  # who has not said so for so long makes none

_process = {"is_worker": False}  # of pytest-xdist; a fixture that asked for it would be asked with each test


def pytest_configure(config):
    """Make the markers known, and cycles be looked for rarely: what tests are made of stays."""
    gc.set_threshold(200_000, 20, 20)
    _process["is_worker"] = hasattr(config, "workerinput")
    config.addinivalue_line("markers", "requirement(*criteria): the criteria that a test shows, such as FR-00068.3")
    config.addinivalue_line(
        "markers", "days: goes through minutes or days of simulated time, which takes longer than all other tests"
    )


def pytest_collection_modifyitems(items):
    """Note for the results what each test of this suite shows."""
    inputs = ("codegen-inputs", json.loads(CASES.read_text(encoding="utf-8"))["generated"]["inputs"])
    for item in items:
        if item.path.parent == HERE:
            shown = [name for mark in item.iter_markers("requirement") for name in mark.args]
            noted = [*(("requirement", name) for name in dict.fromkeys(shown)), inputs]
            item.user_properties += [found for found in noted if found not in item.user_properties]


def pytest_collection_finish(session):
    """Note which checks are selected."""
    note(session.items)


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def results(request):
    """Return what the firmware made of all cases, in one run of each interpreter."""
    return told_by(request.param, "runner.py", str(CASES), heap=LARGE_HEAP)


@pytest.fixture(scope="session")
def modules():
    """pymavlink's dialects, MAVLink 2 and 1, with what the firmware sends and receives, and what it knows places of."""
    from oracle import dialects  # noqa: PLC0415  most tests need none of it, and it takes a while

    cases = json.loads(CASES.read_text(encoding="utf-8"))
    classes = path_of("firmware", "messages.py").read_text(encoding="utf-8")
    names = {case["message"] for case in cases["messages"]} | set(re.findall(r'^    NAME = "(\w+)"$', classes, re.M))
    places = [
        name for path in files("firmware/*.py") for name in re.findall(r"^_(\w+)_AT = ", path.read_text("utf-8"), re.M)
    ]
    ends = [(name, end.start()) for name in places for end in re.finditer("_", name)]
    kinds = [path.read_text("utf-8") for path in files("firmware/absences.py")]
    absent = [name for text in kinds for name in re.findall(r"\),  # (\w+)$", text, re.M)]
    return dialects(cases["dialect"], names, HERE, [*absent, *(name[:end] for name, end in ends)])


@pytest.fixture(scope="session")
def once(tmp_path_factory):
    """Return a call that keeps results, JSON, by name: each is made once, however many processes pytest-xdist has.

    So is one that cannot be made: the result is what went wrong, by the name "", and all that ask for it fail at once.
    """
    base = tmp_path_factory.getbasetemp()
    shared = base.parent if _process["is_worker"] else base  # of all workers of this run
    known = {}

    def by(name, make):
        if name not in known:
            known[name] = {"": f"{name} was broken off"}  # where it is, whoever asks next does not wait for it
            known[name] = _shared(shared / f"{name}.json", make)
        return known[name]

    return by


@pytest.fixture(scope="session")
def printed(once):
    """Return a call for what a script prints, as JSON, in one run of it.

    A script that is given the names of checks runs these alone: `names` is a call for them.
    """

    def by(interpreter, script, names=tuple):
        return once(f"{interpreter}-{script}", lambda: told_by(interpreter, script, *names()))

    return by


def _shared(path, make):
    """Return the result in a file: that of the process which came first, and makes it."""
    begun = path.with_suffix(".started")
    try:
        os.close(os.open(begun, os.O_CREAT | os.O_EXCL))
    except FileExistsError:
        return _awaited(path, begun)
    made = {"": f"{path.stem} was broken off"}
    over = threading.Event()
    threading.Thread(target=_go_on, args=(begun, over), daemon=True).start()
    try:
        made = make()
    except Exception as error:
        made = {"": str(error) if isinstance(error, AssertionError) else f"{type(error).__name__}: {error}"}
    finally:  # processes that wait for the result get the error, too
        over.set()
        path.with_suffix(".part").write_text(json.dumps(made))
        path.with_suffix(".part").replace(path)
    return made


def _go_on(begun, over):
    """Show those who wait that the process that makes a result is there."""
    while not over.wait(GOES_ON_S):
        begun.touch()


def _awaited(path, begun):
    while not path.exists():
        if time.time() - begun.stat().st_mtime > GONE_S:
            return {"": f"{path} does not come: the process that makes it has ended"}
        time.sleep(0.05)
    return json.loads(path.read_text())
