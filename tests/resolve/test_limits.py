"""Limits of a live value: whatever the bounds and the sentinel are, a real value never reads as unknown."""

from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from codegen.answers.limits import EMPTY_LIMITS, Bounds, scaling_of
from codegen.answers.live import LiveAnswer
from codegen.diagnostics import Report
from codegen.model.answers.answer import Elements
from codegen.model.answers.scaling import Scaling, rounded
from codegen.model.dialect.dialect import FieldDefinition, WireField
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.model.spec.population import FieldAnswer, Rounding
from codegen.model.units.unit import NUMBER
from codegen.model.vehicle import Citation, Parameter
from codegen.source import Place

PLACE = Place("table.yaml")
INTEGERS = [name for name, wire_type in WIRE_TYPES.items() if wire_type.is_integer]


def field_of(type_name: str) -> WireField:
    definition = FieldDefinition("field", type_name, None, False, PLACE)
    return WireField(definition, WIRE_TYPES[type_name], 0, 1, None)


def limits(type_name, sentinel, low, high, factor=Fraction(1), rounding=Rounding.NEAREST):
    report = Report()
    answer = FieldAnswer(place=PLACE, state="a.b", rounding=rounding)
    bounds = Bounds(Fraction(low), Fraction(high))
    return scaling_of(field_of(type_name), sentinel, bounds, factor, answer, report), report


@given(st.sampled_from(INTEGERS), st.integers(), st.integers(), st.data())
def test_no_stored_value_reaches_the_sentinel_or_wraps(type_name, low, high, data):
    """For any type, bounds, sentinel, factor and rounding: the wire value is in the type and is not the sentinel."""
    wire_type = WIRE_TYPES[type_name]
    sentinel = data.draw(st.integers(wire_type.minimum, wire_type.maximum))
    factor = data.draw(st.fractions(min_value=Fraction(1, 1000), max_value=1000))
    stored = data.draw(st.integers(-(2**30) + 1, 2**30 - 1))
    rounding = data.draw(st.sampled_from(Rounding))
    found, _ = limits(type_name, sentinel, low, high, factor, rounding)
    assume(found is not None)
    covers = Elements(field_of(type_name), 0, 1, FieldAnswer(place=PLACE, parameter="P"), Citation(None, None))
    parameter = Parameter("P", NUMBER, Fraction(1), stored, 0, 0, {}, None, None)
    (value,) = LiveAnswer(covers, parameter, found, sentinel).values({"P": stored}, 0, 0)
    assert wire_type.minimum <= value <= wire_type.maximum
    assert value != sentinel
    assert found.low <= value <= found.high


def test_sentinel_at_an_end_shortens_the_range():
    """UINT16_MAX leaves 0 to 65534, INT16_MAX leaves -32768 to 32766, 0 leaves 1 and more."""
    assert (limits("uint16_t", 65535, -1, 70000)[0].low, limits("uint16_t", 65535, -1, 70000)[0].high) == (0, 65534)
    assert limits("int16_t", 32767, -(10**6), 10**6)[0].high == 32766
    assert limits("int32_t", 0, 0, 100)[0].low == 1


@pytest.mark.parametrize(("sentinel", "beside"), [(-1, -2), (5, 6), (0, 1)])
def test_sentinel_inside_keeps_the_sign(sentinel, beside):
    """-1 moves to -2, since a charging current stays one; a positive sentinel moves up."""
    found, _ = limits("int16_t", sentinel, -100, 100)
    assert (found.hole, found.beside) == (sentinel, beside)


def test_nothing_left_is_reported():
    """Bounds that leave only the sentinel are an error."""
    found, report = limits("int8_t", -1, -1, -1)
    assert found is None
    assert [diagnostic.rule for diagnostic in report] == [EMPTY_LIMITS]


@given(
    st.integers(-50, 50),
    st.integers(0, 50),
    st.fractions(min_value=Fraction(1, 20), max_value=20, max_denominator=40),
    st.sampled_from(Rounding),
)
def test_the_ends_of_what_is_carried(low, more, factor, rounding):
    """The stored values between them are those that are rounded to a number within the limits, and no others."""
    found = Scaling(factor, rounding, Fraction(low), Fraction(low + more))
    within = [each for each in range(-2100, 2101) if low <= rounded(each * factor, rounding) <= low + more]
    smallest, largest = found.carried
    assert within == list(range(smallest, largest + 1))


@given(st.fractions(), st.sampled_from(Rounding))
def test_rounding_is_what_its_name_says(value, rounding):
    """Down is never above, up never below, toward zero never farther from 0, nearest never off by more than a half."""
    result = rounded(value, rounding)
    assert abs(result - value) < 1 or rounding is Rounding.NEAREST
    if rounding is Rounding.NEAREST:
        assert abs(result - value) <= Fraction(1, 2)
        assert abs(result - value) != Fraction(1, 2) or abs(result) > abs(value)
    if rounding is Rounding.DOWN:
        assert result <= value
    if rounding is Rounding.UP:
        assert result >= value
    if rounding is Rounding.TOWARD_ZERO:
        assert abs(result) <= abs(value)
