# Generated from templates/tests/test_behaviour.py: do not edit.
# Inputs: bdef155eca128fc1
"""The checks of behaviour.py, in one run of each interpreter; a test is named by its check and criterion."""

import pytest
from interpreters import checks_of


def _checks():
    """Return criterion and name of each check."""
    for criterion, check in (entry.elts for entry in checks_of("behaviour.py")):
        yield criterion.value, check.id


def _cases():
    for interpreter in ("cpython", "micropython"):
        for criterion, name in _checks():
            shows = [pytest.mark.requirement(criterion)] if criterion else []
            case = f"{interpreter}-{name}" + (f"-{criterion}" if criterion else "")
            yield pytest.param(interpreter, name, id=case, marks=shows)


@pytest.mark.parametrize(("interpreter", "name"), list(_cases()))
def test_behaviour(interpreter, name, printed, request):
    """The board and the state behave as the requirements say, and the steady cycle allocates nothing."""
    found = printed(interpreter, "behaviour.py", item=request.node)
    assert "" not in found, found[""]
    assert found[name] is None, found[name]
