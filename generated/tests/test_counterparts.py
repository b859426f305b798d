# Generated from templates/tests/test_counterparts.py: do not edit.
# Inputs: 998be2be2e78ee3c
"""Machine code and its counterpart in plain Python leave the same, whatever happens: MicroPython and CPython agree."""

import pytest

PARTS = ("steps", "ages", "due", "watched", "frames")


@pytest.mark.parametrize("part", PARTS)
def test_counterparts(part, printed):
    """All that is drawn by lot has the same end on both interpreters; steps are counted from 0."""
    found = [printed(interpreter, "counterparts_run.py") for interpreter in ("cpython", "micropython")]
    assert [each.get("") for each in found] == [None, None]
    plain, machine = (each[part] for each in found)
    assert len(plain) == len(machine) > 0
    assert [step for step, each in enumerate(plain) if each != machine[step]] == []
