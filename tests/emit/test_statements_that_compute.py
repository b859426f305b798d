"""Statements that the firmware computes with, run as they are: products that are taken apart, and who is chosen."""

import math
from fractions import Fraction
from itertools import product
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.model.code.payload_code import UNKNOWN
from codegen.targets.firmware.messages.choice import choosing
from codegen.targets.firmware.readings.reading import _difference, _product
from codegen.targets.firmware.readings.sources import _scaled

LEAST = -(1 << 30)
FACTORS = [(1, 1), (3, 1), (1, 2), (1, 7), (5, 7), (5, 8), (330, 4095), (33, 1000)]


def run(lines: list[str], **names: Any) -> dict[str, Any]:
    """The names after some statements."""
    exec("\n".join(lines), {UNKNOWN: LEAST}, names)  # noqa: S102
    return names


def nearest(value: Fraction) -> int:
    """The nearest whole number, of two the upper one."""
    return math.floor(value + Fraction(1, 2))


@pytest.mark.parametrize(("numerator", "denominator"), FACTORS)
def test_a_product_is_rounded_to_nearest(numerator: int, denominator: int) -> None:
    text = _product(numerator, denominator)
    for value in (0, 1, 2, 3, 4, 6, 7, 8, 500, 2047, 4095, 10**6 + 1):
        assert eval(text, {"value": value}) == nearest(Fraction(value * numerator, denominator)), value  # noqa: S307


@pytest.mark.parametrize(("of_count", "of_away", "denominator"), [(2, 3, 1), (1, 1, 2), (5, 3, 7), (33, 40, 4095)])
@pytest.mark.parametrize("away", ["50 * 7", "offset * 7", "0 * 7", "-3 * 7"])
def test_a_difference_of_products_is_rounded_to_nearest(
    of_count: int, of_away: int, denominator: int, away: str
) -> None:
    """Where the second product is a number, it is worked out beforehand."""
    lines = _difference(("count * 3", away), (of_count, of_away), denominator)
    assert ("away" in "".join(lines)) is (denominator > 1 and "offset" in away)
    for count, offset in product((0, 1, 5, 1000, 4095), (-2, 0, 9)):
        lost = eval(away, {"offset": offset})  # noqa: S307
        found = run(lines, count=count, offset=offset)["value"]
        assert found == nearest(Fraction(count * 3 * of_count - lost * of_away, denominator)), (count, offset)


@pytest.mark.parametrize(("numerator", "denominator"), FACTORS)
@pytest.mark.parametrize("low", [0, -5000])
@pytest.mark.parametrize("count", [None, object()])
def test_what_a_sensor_gives_is_rounded_away_from_zero(numerator: int, denominator: int, low: int, count: Any) -> None:
    """Into its word, or into the value that is counted on."""
    given: Any = SimpleNamespace(factor=Fraction(numerator, denominator), word=1, count=count)
    lines = list(_scaled(given, SimpleNamespace(low=low)))  # type: ignore[arg-type]
    assert ("if value < 0:" in lines) is (low < 0 and denominator > 1)
    for value in (value for value in (-4999, -8, -7, -4, -1, 0, 1, 4, 7, 8, 4999) if value >= low):
        names = run(lines, value=value, words=[None, None])
        found = names["words"][1] if count is None else names["value"]
        exact = Fraction(value * numerator, denominator)
        assert found == (nearest(exact) if value >= 0 else -nearest(-exact)), value


class Code:
    """Spells what is looked at as plain lists, by instance."""

    def parameter(self, _parameter: Any) -> str:
        return "number"

    def reach(self, _component: str, place: str) -> str:
        return f"at = {place}"

    def is_set(self, _quantity: Any) -> str:
        return "enabled[at]"

    def read(self, _quantity: Any) -> str:
        return "levels[at]"


def chosen(number: int | None, levels: list[int], enabled: list[int] | None) -> int:
    """The place that the statements end at: by a parameter, or else by the lowest level."""
    component = SimpleNamespace(name="pack", instances=len(levels), enabled=enabled, readings=())
    choice: Any = SimpleNamespace(
        component=component,
        parameter=None if number is None else SimpleNamespace(name="CHOSEN"),
        quantity=SimpleNamespace(name="level", ages=False),
    )
    code: Any = Code()
    names = run(choosing(choice, code), number=number, levels=levels, enabled=enabled)
    assert names["at"] == names["place"]
    return int(names["place"])


@pytest.mark.parametrize(
    ("number", "levels", "enabled", "place"),
    [
        (1, [0, 0, 0], None, 0),
        (3, [0, 0, 0], None, 2),
        (0, [0, 0, 0], None, 0),
        (4, [0, 0, 0], None, 0),
        (3, [0, 0, 0], [1, 1, 1], 2),
        (3, [0, 0, 0], [0, 1, 0], 1),
        (2, [0, 0, 0], [0, 0, 1], 2),
        (4, [0, 0, 0], [0, 1, 1], 1),
        (2, [0, 0, 0], [0, 0, 0], 0),
        (None, [5, 3, 4], None, 1),
        (None, [3, 3, 4], None, 0),
        (None, [5, LEAST, 4], None, 2),
        (None, [LEAST, LEAST, LEAST], None, 0),
        (None, [5, 3, 4], [1, 0, 1], 2),
        (None, [5, 3, 4], [0, 0, 1], 2),
        (None, [LEAST, LEAST, LEAST], [0, 1, 1], 1),
        (None, [5, 3, 4], [0, 0, 0], 0),
    ],
)
def test_which_instance_a_message_is_about(number: Any, levels: Any, enabled: Any, place: int) -> None:
    """That of the parameter, or with the lowest level that is known; else the first that is enabled, or of all."""
    assert chosen(number, levels, enabled) == place
