"""The parameter of a command takes the numbers of its enum: its entries, and of a bitmask any sum of them."""

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.model.dialect.dialect import EnumDefinition, EnumEntry
from codegen.resolve.commands.params import _has_value, has_entry
from codegen.source import Place

HERE = Place("/test.xml")


def enum_of(*values: int, is_bitmask: bool) -> EnumDefinition:
    entries = tuple(EnumEntry(f"E_{value}", value, "", HERE) for value in values)
    return EnumDefinition("E", entries, is_bitmask, "", HERE)


@pytest.mark.parametrize(("value", "is_there"), [(0, False), (1, True), (2, False), (3, False), (4, True), (-1, False)])
def test_an_enum_has_its_entries(value: int, is_there: bool) -> None:
    assert has_entry(enum_of(1, 4, is_bitmask=False), value) is is_there


@pytest.mark.parametrize(
    ("value", "is_there"), [(0, True), (1, True), (2, False), (4, True), (5, True), (7, False), (8, False), (-1, False)]
)
def test_a_bitmask_has_sums_of_its_flags_and_none(value: int, is_there: bool) -> None:
    assert has_entry(enum_of(1, 4, is_bitmask=True), value) is is_there


@pytest.mark.parametrize(
    ("low", "high", "has_value"),
    [(4, 9, True), (0, 1, True), (1, 1, True), (None, 1, True), (4, None, True), (2, 3, False), (5, None, False)],
)
def test_limits_leave_the_entries_at_their_ends(low: int | None, high: int | None, has_value: bool) -> None:
    scale: Any = SimpleNamespace(ratio=0)
    ends = [None if end is None else Fraction(end) for end in (low, high)]
    param: Any = SimpleNamespace(minimum=ends[0], maximum=ends[1], scale=scale, enum=enum_of(1, 4, is_bitmask=False))
    assert _has_value(param) is has_value
