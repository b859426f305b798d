"""Machine code and its counterpart in plain Python leave the same, whatever happens: MicroPython and CPython agree."""

import re

import pytest
from interpreters import files, path_of

PARTS = ("steps", "ages", "zeros", "short", "due", "watched", "frames")


@pytest.mark.parametrize("part", PARTS)
def test_counterparts(part, printed):
    """All that is drawn by lot has the same end on both interpreters; steps are counted from 0."""
    found = [printed(interpreter, "counterparts_run.py") for interpreter in ("cpython", "micropython")]
    assert [each.get("") for each in found] == [None, None]
    plain, machine = (each[part] for each in found)
    assert len(plain) == len(machine) > 0
    assert [step for step, each in enumerate(plain) if each != machine[step]] == []


def test_places():
    """A module that names a place of the state has the number that the state has for it.

    It is that within the component, or where the words of all are at hand that within these.
    """
    place = re.compile(r"^(_[A-Z]\w*) = const\((\d+)\)", re.MULTILINE)
    places = {name: int(number) for name, number in place.findall(path_of("firmware", "state.py").read_text("utf-8"))}
    begins = {name + "_": places[name] for name in places if name + "_SIZE" in places}
    wrong = []
    for path in files("firmware/*.py"):
        for name, number in place.findall(path.read_text("utf-8")):
            allowed = [
                begin + places[name] for prefix, begin in begins.items() if name in places and name.startswith(prefix)
            ]
            if allowed and int(number) not in (places[name], *allowed):
                wrong.append((path.name, name, number))
    assert wrong == []
