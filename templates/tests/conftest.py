"""What the firmware does in the cases and checks of this suite, once for each interpreter."""

import json

import pytest
from interpreters import CASES, run_under


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def results(request):
    """What the firmware made of all cases, in one run of each interpreter."""
    return json.loads(run_under(request.param, "runner.py", str(CASES), heap="64m"))


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def behaviour(request):
    """Run the functions of a behaviour script under an interpreter; their names with None or what went wrong."""

    def run(script):
        return json.loads(run_under(request.param, script))

    return run
