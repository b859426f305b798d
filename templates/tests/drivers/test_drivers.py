"""Tests of sensor drivers against the answers of their devices, each script in one run of each interpreter.

A test is named by its script and check.
"""

import pytest
from interpreters import checks_of, files


def _cases():
    for interpreter in ("cpython", "micropython"):
        for path in files("tests/*_driver.py"):
            for name in (check.id for check in checks_of(path.name)):
                case = f"{interpreter}-{path.name.removesuffix('_driver.py')}-{name}"
                yield pytest.param(interpreter, path.name, name, id=case)


@pytest.mark.parametrize(("interpreter", "script", "name"), list(_cases()))
def test_driver(interpreter, script, name, printed):
    """The driver understands what its device says."""
    found = printed(interpreter, script)
    assert "" not in found, found[""]
    assert found[name] is None, found[name]
