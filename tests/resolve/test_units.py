"""Units convert exactly, and only within their dimension."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from codegen.model.unit import UNITS, decimal, read_measure


@pytest.mark.parametrize(
    ("amount", "unit", "value"),
    [
        ("3.3 V", "mV", 3300),
        ("-0.01 A", "cA", -1),
        ("1 Ah", "mAh", 1000),
        ("1 Wh", "hJ", 36),
        ("45.5 %", "d%", 455),
        ("21.5 degC", "cdegC", 2150),
        ("2 ms", "us", 2000),
        ("1.25 kg", "g", 1250),
        ("90 km/h", "m/s", 25),
        ("9.80665 m/s/s", "mG", 1000),
        ("1 KiB", "bytes", 1024),
    ],
)
def test_conversion_is_exact(amount, unit, value):
    """Worked by hand from the definitions of the units."""
    assert read_measure(amount).in_unit(UNITS[unit]) == value


@pytest.mark.parametrize(
    ("amount", "unit"), [("1 A", "mAh"), ("1 V", "A"), ("1 deg", "rad"), ("1 Hz", "s"), ("1 %", "V")]
)
def test_dimensions_do_not_mix(amount, unit):
    """A charge is no current, and degrees have no exact factor to radians."""
    assert read_measure(amount).in_unit(UNITS[unit]) is None


@given(st.sampled_from(sorted(UNITS)), st.sampled_from(sorted(UNITS)), st.fractions())
def test_there_and_back_is_the_same(first, second, value):
    """No digit is lost on the way to another unit and back."""
    factor = UNITS[first].to(UNITS[second])
    if factor is not None:
        assert value * factor * UNITS[second].to(UNITS[first]) == value


@pytest.mark.parametrize("text", ["", "V", "3,3 V", "3.3", "3.3 Volt", "3.3 V V", "nan V", "1e V"])
def test_what_is_no_amount(text):
    """Anything but a number and a known unit is None, not an exception."""
    assert read_measure(text) is None


@pytest.mark.parametrize(
    ("value", "text"), [("79/20", "3.95"), ("1/10000", "0.0001"), ("2", "2"), ("1/3", "1/3"), ("-1/2", "-0.5")]
)
def test_decimals_are_exact(value, text):
    """A decimal where one exists, else the fraction."""
    assert decimal(Fraction(value)) == text
