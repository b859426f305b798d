"""Marks say which blocks of a module a run reaches, and change nothing else about it."""

import sys
from collections.abc import Callable
from types import ModuleType

import pytest
from marks import MODULE, Marker, module

TEXT = '''\
"""A docstring."""
from __future__ import annotations

LIMIT = 3


class Level:
    """A docstring."""

    low: int = 1

    def of(self, value, most=LIMIT):
        """A docstring."""
        if value < self.low:
            return None
        elif value > most:
            found = most
        else:
            found = value
        for each in range(found):
            if each == 2:
                break
        match found:
            case 3:
                return "most"
            case _:
                pass
        try:
            return [each for each in range(
                found)]
        except ValueError:
            return 0
'''


def reached_by(monkeypatch: pytest.MonkeyPatch, *values: int) -> tuple[list[object], set[int]]:
    """Return what the method of the text gives, and the lines that are marked meanwhile."""
    marker = Marker()
    text = marker.marked("level.py", TEXT)
    marks = bytearray(len(marker.blocks))
    monkeypatch.setitem(sys.modules, MODULE, ModuleType(MODULE))
    monkeypatch.setattr(sys.modules[MODULE], "marks", marks, raising=False)
    names: dict[str, type] = {"__name__": "level"}
    exec(compile(text, "level.py", "exec"), names)  # noqa: S102  what a marked module does
    assert names["__doc__"] == names["Level"].__doc__ == names["Level"].of.__doc__ == "A docstring."
    found = [names["Level"]().of(value) for value in values]
    return found, {line for (_, lines), mark in zip(marker.blocks, marks, strict=True) if mark for line in lines}


IMPORTED = {1, 2, 4, 7, 8, 10, 12}


@pytest.mark.parametrize(
    ("values", "found", "lines"),
    [
        ((), [], set()),
        ((0,), [None], {14, 15}),
        ((1,), [[0]], {14, 16, 19, 20, 21, 23, 24, 27, 28, 29, 30}),
        ((7,), ["most"], {14, 16, 17, 20, 21, 22, 23, 24, 25}),
    ],
)
def test_what_is_reached_is_marked_and_nothing_else(
    monkeypatch: pytest.MonkeyPatch, values: tuple[int, ...], found: list[object], lines: set[int]
) -> None:
    assert reached_by(monkeypatch, *values) == (found, IMPORTED | lines)


def test_programs_without_the_variable_mark_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Some tests start programs in an environment of their own."""
    monkeypatch.delenv("CODEGEN_MARKS", raising=False)
    names: dict[str, object] = {}
    exec(module(3), names)  # noqa: S102  the module that marked ones import
    assert names["marks"] == bytearray(3)


def test_a_name_of_a_module_is_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    """A module of codegen may call anything marks: what sets the bytes has a name that none of them has."""
    marker = Marker()
    text = marker.marked("own.py", "def _marks():\n    return 3\n\n\ndef marks():\n    return _marks()\n")
    monkeypatch.setitem(sys.modules, MODULE, ModuleType(MODULE))
    monkeypatch.setattr(sys.modules[MODULE], "marks", bytearray(len(marker.blocks)), raising=False)
    names: dict[str, Callable[[], int]] = {}
    exec(compile(text, "own.py", "exec"), names)  # noqa: S102  what a marked module does
    assert names["marks"]() == 3
