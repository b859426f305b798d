"""The cases of amounts.json, in one run of each interpreter; a test is named by what it is about."""

import json

import pytest
from interpreters import path_of, run_under

FILE = path_of("tests", "amounts.json")


def _cases():
    for interpreter in ("cpython", "micropython"):
        for case in json.loads(FILE.read_text(encoding="utf-8"))["cases"]:
            shows = [pytest.mark.requirement(case["criterion"])] if case["criterion"] else []
            yield pytest.param(interpreter, case["name"], id=f"{interpreter}-{case['name']}", marks=shows)


@pytest.mark.parametrize(("interpreter", "name"), list(_cases()))
def test_amount(interpreter, name, once):
    """A sensor, a curve, a sum, a trend or a limit tells what the tables and the data sheet say, exactly."""
    found = once(f"{interpreter}-amounts", lambda: json.loads(run_under(interpreter, "amounts_run.py", str(FILE))))
    assert "" not in found, found[""]
    assert found[name] is None, found[name]
