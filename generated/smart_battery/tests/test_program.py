# Generated from templates/tests/program/test_program.py: do not edit.
# Inputs: 68089a2cde6a1188
"""The checks of the program, each script in one run of each interpreter; a test is named by its check and criteria."""

import socket

import pytest
from interpreters import HERE, checks_of
from program_facts import CRITERIA

LONG = ("day", "heap")  # simulated days: they take longer than all others together
ONLY_MICROPYTHON = ("heap", "steady")  # what they measure, CPython does not have


def _checks(script):
    """Return the name of each check of a script, and the criteria that it shows."""
    for check, *aspects in (entry.elts for entry in checks_of(f"{script}_checks.py")):
        criteria = [each for aspect in aspects for each in CRITERIA.get(aspect.value, ())]
        yield check.id, list(dict.fromkeys(criteria))


def _cases():
    scripts = sorted(path.name.removesuffix("_checks.py") for path in HERE.glob("*_checks.py"))
    for script in sorted(scripts, key=lambda name: name in LONG):
        for interpreter in ("cpython", "micropython"):
            if interpreter == "micropython" or script not in ONLY_MICROPYTHON:
                for name, criteria in _checks(script):
                    marks = [pytest.mark.requirement(*criteria)] if criteria else []
                    marks += [pytest.mark.days] if script in LONG else []
                    case = "-".join((interpreter, script, name, *criteria))
                    yield pytest.param(interpreter, script, name, id=case, marks=marks)


def _free_port():
    """Return the number of a UDP port that nobody has."""
    with socket.socket(type=socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        return (str(free.getsockname()[1]),)


@pytest.mark.parametrize(("interpreter", "script", "name"), list(_cases()))
def test_program(interpreter, script, name, printed, request):
    """The vehicle does what the criterion says."""
    found = printed(interpreter, f"{script}_checks.py", _free_port, request.node)
    assert "" not in found, found[""]
    outcome = found[name]
    if outcome is not None and outcome.startswith("left out: "):
        pytest.skip(outcome)
    assert outcome is None, outcome
