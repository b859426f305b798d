"""Numbers that attributes of a field state, and texts that are none."""

from collections.abc import Callable
from fractions import Fraction

import pytest

XML = '<mavlink><messages><message id="9" name="M"><field type="uint8_t" name="a" {}/></message></messages></mavlink>'


@pytest.mark.parametrize(
    "attribute",
    [
        *('multiplier="0"', 'multiplier="-1"', 'multiplier="x"', 'minValue="low"', 'maxValue="1/0"'),
        *('increment="?"', 'default="none"', 'default="2**65"', 'minValue="300"', 'maxValue="-1"'),
    ],
)
def test_an_attribute_that_is_no_number_is_an_error_at_the_field(attribute: str, read: Callable) -> None:
    """Nothing would be limited or multiplied by it."""
    result = read(XML.format(attribute))
    assert result.found == ["1:45 field-number"]
    assert result.dialect.messages["M"].field("a").multiplier == 1


def test_good_ones_are_not_reported(read: Callable) -> None:
    """Every form that pymavlink's schema has."""
    text = 'multiplier="2E-3" minValue="-1.5" maxValue="1e2" increment=".5" default="0x1F"'
    result = read(XML.format(text))
    assert result.found == []
    assert result.dialect.messages["M"].field("a").multiplier == Fraction(1, 500)
