"""Factors and ranges in the description of a field, as a comparison reads and shows them."""

from fractions import Fraction

import pytest

from codegen.diff.dialect.meaning import _is_in_text, _range
from codegen.model.dialect.dialect import FieldDefinition
from codegen.source import Place

FIELD = FieldDefinition("angle", "uint8_t", None, False, Place("/d.xml"))


@pytest.mark.parametrize(
    ("factor", "text", "is_told"),
    [
        (Fraction(1, 100), "Temperature * 100.", True),
        (Fraction(1, 10), "Speed x10", True),
        (Fraction(1, 100), "Temperature * 10.", False),
        (Fraction(360, 255), "Heading, 0: 0 deg, 255: 360 deg.", True),
        (Fraction(24, 17), "Heading, 0: 0 deg, 34: 48 deg.", True),
        (Fraction(360, 255), "Heading, 0: 0 deg, 254: 360 deg.", False),
    ],
)
def test_a_description_may_tell_of_a_factor(factor: Fraction, text: str, is_told: bool) -> None:
    """By a sign, or by two numbers that have it between them, however far both are multiplied."""
    assert _is_in_text(factor, text) is is_told


@pytest.mark.parametrize(
    ("ends", "shown"),
    [(("0", "5"), "0..5"), ((None, "5"), "..5"), (("-1", None), "-1.."), ((None, None), None)],
)
def test_a_range_is_shown_with_the_ends_that_it_has(ends: tuple[str | None, str | None], shown: str | None) -> None:
    minimum, maximum = ends
    assert _range(FIELD._replace(minimum=minimum, maximum=maximum)) == shown
