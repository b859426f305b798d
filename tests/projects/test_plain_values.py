"""The plain value that the suite sends to a receiver is a number well within the accepted ones, never unknown."""

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.targets.suite.cases.receptions import _plain


def taken(type_name: str, low: int, high: int, special: tuple[int, ...] = ()) -> Any:
    field = SimpleNamespace(type=WIRE_TYPES[type_name], count=1)
    return SimpleNamespace(is_text=False, field=field, low=Fraction(low), high=Fraction(high), special=special)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        (taken("float", 0, 70), 30.0),
        (taken("float", -(10**9), 10**9), -1000 + 2000 * 3 / 7),
        (taken("float", 2000, 2700), 2300.0),
        (taken("uint8_t", 0, 70), 30),
        (taken("uint8_t", 0, 70, special=(30,)), 31),
        (taken("uint8_t", 0, 70, special=(30, 32, 31)), 33),
        (taken("uint8_t", 30, 30, special=(30,)), 29),
    ],
)
def test_it_lies_within(field: Any, value: float) -> None:
    found = _plain(field)
    assert found is not None
    assert found == pytest.approx(value, rel=1e-6)
