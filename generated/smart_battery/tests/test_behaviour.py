# Generated from templates/tests/test_behaviour.py: do not edit.
# Inputs: d1c1dc50003b07f3
"""The checks of behaviour.py, in one run of each interpreter; a test is named by its check and criterion."""

import pytest
from interpreters import checks_of
from selection import selected


def _checks():
    """Return criterion and name of each check."""
    for criterion, check in (entry.elts for entry in checks_of("behaviour.py")):
        yield criterion.value, check.id


def _cases():
    for interpreter in ("cpython", "micropython"):
        for criterion, name in _checks():
            shows = [pytest.mark.requirement(criterion)] if criterion else []
            case = f"{interpreter}-{name}" + (f"-{criterion}" if criterion else "")
            yield pytest.param((interpreter, name), id=case, marks=shows)


def _selected(interpreter):
    return [name for by, name in selected("test_behaviour") if by == interpreter]


@pytest.mark.parametrize("check", list(_cases()))
def test_behaviour(check, printed):
    """The board and the state behave as the requirements say, and the steady cycle allocates nothing."""
    interpreter, name = check
    found = printed(interpreter, "behaviour.py", lambda: _selected(interpreter))
    assert "" not in found, found[""]
    assert found[name] is None, found[name]
