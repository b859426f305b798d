# Generated from templates/tests/program/test_program.py: do not edit.
# Inputs: d540e760f06caccd
"""The checks of the program, in one run of each interpreter; a test is named by its check and criteria.

Those that a script lists as LONG simulate minutes or days: `-m "not days"` leaves them out, and they have another run.
"""

import pytest
from grouped import outcomes
from interpreters import checks_of, files
from program_facts import CRITERIA, MESSAGES, PARAMETERS
from selection import selected

ONLY_MICROPYTHON = ("heap", "steady")  # what they measure, CPython does not have
LIMIT_S = 60 + len(MESSAGES) + len(PARAMETERS)
"""For each check: many go through all messages or parameters. On an idle computer all take seconds."""
LONG_LIMIT_S = 2 * LIMIT_S
"""For each that is long."""


def _checks():
    """Return script and name of each check, the criteria that it shows, and whether it is long."""
    for script in (path.name.removesuffix("_checks.py") for path in files("tests/*_checks.py")):
        long = {check.id for check in checks_of(f"{script}_checks.py", "LONG")}
        for check, *aspects in (entry.elts for entry in checks_of(f"{script}_checks.py")):
            criteria = [each for aspect in aspects for each in CRITERIA.get(aspect.value, ())]
            yield script, check.id, list(dict.fromkeys(criteria)), check.id in long


def _cases():
    checks = sorted(_checks(), key=lambda check: check[-1])
    for interpreter in ("cpython", "micropython"):
        for script, name, criteria, is_long in checks:
            if interpreter == "micropython" or script not in ONLY_MICROPYTHON:
                marks = [pytest.mark.requirement(*criteria)] if criteria else []
                marks += [pytest.mark.days] if is_long else []
                case = "-".join((interpreter, script, name, *criteria))
                yield pytest.param((interpreter, is_long, script, name), id=case, marks=marks)


@pytest.fixture(scope="session")
def checked(once):
    """Return a call for the finding of a check, in the run of all those that are selected and like it."""

    def by(check):
        *kind, script, name = check
        interpreter, is_long = kind

        def run():
            asked = [(script, name) for *one, script, name in selected("test_program") if one == kind]
            return outcomes(interpreter, asked, LONG_LIMIT_S if is_long else LIMIT_S)

        found = once(f"{interpreter}-{'long' if is_long else 'program'}", run)
        assert "" not in found, found[""]
        return found[f"{script} {name}"]

    return by


@pytest.mark.parametrize("check", list(_cases()))
def test_program(check, checked):
    """The vehicle does what the criterion says."""
    outcome = checked(check)
    if outcome is not None and outcome.startswith("left out: "):
        pytest.skip(outcome)
    assert outcome is None, outcome
