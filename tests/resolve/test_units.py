"""Units convert exactly, and only within their dimension."""

import math
from fractions import Fraction
from types import SimpleNamespace

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from stated_units import STATED

from codegen.answers.source import _steps
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.model.units.affine import AffineMap, pi_between
from codegen.model.units.nearest_unit import nearest_unit
from codegen.model.units.unit import Unit, conversion, decimal, map_words, ratio, read_measure, symbols, unit_named
from codegen.model.units.unit_table import SCALED, SHOWN, WORDS

ALL = sorted({*STATED, *symbols(), *SHOWN, *SCALED})
PI_100 = Fraction(
    "3.1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679"
)
"""The first hundred decimals, known since Machin's time."""


@pytest.mark.parametrize(
    ("amount", "unit", "value"),
    [
        ("3.3 V", "mV", 3300),
        ("-0.01 A", "cA", -1),
        ("1 Ah", "mAh", 1000),
        ("1 Wh", "hJ", 36),
        ("45.5 %", "d%", 455),
        ("21.5 degC", "cdegC", 2150),
        ("21.5 degC", "K", Fraction("294.65")),
        ("0 K", "cdegC", -27315),
        ("2 ms", "us", 2000),
        ("1.25 kg", "g", 1250),
        ("90 km/h", "m/s", 25),
        ("1 kn", "km/h", Fraction("1.852")),
        ("9.80665 m/s/s", "mG", 1000),
        ("9.80665 m/s^2", "mG", 1000),
        ("1 KiB", "bytes", 1024),
        ("1 mT", "gauss", 10),
        ("139.69 deg", "degE7", 1396900000),
        ("51 m/s", "m/s*5", 255),
        ("51 m/s", "m/sE3", 51000),
        ("51 m/s", "m/s*1000", 51000),
        ("3 deg/s^2", "degE2/s^2", 300),
        ("3 cm^2", "cm^2E1", 30),
        ("358 deg", "deg/2", 179),
        ("60 rpm", "deg/s", 360),
        ("12 V*A", "W", 12),
        ("6 l/h", "cm^3/min", 100),
        ("5 1/s", "Hz", 5),
        ("2 mOhm", "Ohm", Fraction("0.002")),
        ("18 degC/min", "degC/s", Fraction("0.3")),
        ("18 degC/min", "K/s", Fraction("0.3")),
        ("2 1/degC", "1/K", 2),
        ("2 s*degC", "K*s", 2),
        ("2 degC^2", "K^2", 2),
        ("20 degCE2", "K", Fraction("273.35")),
        ("0 deg", "rad", 0),
        ("1 rev", "deg", 360),
        ("1 m^3", "l", 1000),
        ("1 mm^2", "m^2", Fraction(1, 1000000)),
        ("1 m*m^-3", "1/m^2", 1),
    ],
)
def test_conversion_is_exact(amount, unit, value):
    """Worked by hand from the definitions of the units."""
    assert read_measure(amount).in_unit(unit_named(unit)) == value


@pytest.mark.parametrize(
    ("amount", "unit"),
    [("1 A", "mAh"), ("1 V", "A"), ("1 deg", "rad"), ("1 Hz", "s"), ("1 %", "V"), ("1 rpm", "Hz"), ("1 dBm", "W")],
)
def test_what_is_no_exact_number_of_a_unit(amount, unit):
    """A charge is no current, a turn no count, a logarithm no power, and a degree an irrational number of radians."""
    assert read_measure(amount).in_unit(unit_named(unit)) is None


@given(st.sampled_from(ALL), st.sampled_from(ALL), st.fractions())
def test_there_and_back_is_the_same(first, second, value):
    """No digit is lost on the way to another unit and back, and powers of pi cancel."""
    there, back = (conversion(unit_named(one), unit_named(other)) for one, other in ((first, second), (second, first)))
    assert (there is None) == (back is None)
    if there is not None and back is not None:
        assert there.factor * back.factor == 1
        assert there.pi == -back.pi
        assert (value * there.factor + there.offset) * back.factor + back.offset == value


@given(st.sampled_from(ALL), st.sampled_from(ALL), st.sampled_from(ALL))
def test_a_way_over_a_third_unit_is_the_same(first, second, third):
    """Units that convert into the same one convert into each other, by the product of the factors."""
    one, two, three = (unit_named(name) for name in (first, second, third))
    way, rest = conversion(one, two), conversion(two, three)
    if way is not None and rest is not None:
        straight = AffineMap(way.factor * rest.factor, way.pi + rest.pi, way.offset * rest.factor + rest.offset)
        assert conversion(one, three) == straight


@given(st.sampled_from(ALL), st.sampled_from(ALL))
def test_a_quotient_is_made_of_its_parts(first, second):
    """Whatever two units are: one divided by the other, times the other, is the one (as a difference)."""
    quotient = Unit.parse(f"{first}/{second}") if second[0].isalpha() and "/" not in second else None
    if quotient is not None and not second[-1].isdigit():
        product = unit_named(f"{first}/{second}*{second}")
        assert ratio(unit_named(f"{first}*1"), product) == 1 or unit_named(first).zero
        assert product.dimension == unit_named(first).dimension


@pytest.mark.parametrize(
    "text", ["", "V", "3,3 V", "3.3", "3.3 Volt", "3.3 V V", "nan V", "1e V", "11/s", "1/s", "2*s"]
)
def test_what_is_no_amount(text):
    """Anything but a number and a known unit is None, not an exception."""
    assert read_measure(text) is None


@pytest.mark.parametrize(
    "text", ["5", "1/5", "1", "*s", "s*", "m//s", "m/0", "deg/0.0", "m^0", "mm^2^2", "5*V", "V A", "m/s/"]
)
def test_what_is_no_unit(text):
    """A number alone, an operator too much, a division by 0."""
    assert Unit.parse(text) is None


@given(st.text("mskgAVdegCE/*^%-.0123456789 ", max_size=80))
@example("m" + "/s" * 1000)
@example("m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9*m^9")
def test_no_text_is_an_exception(text):
    """Any text that somebody wrote for a unit is one or none."""
    unit = Unit.parse(text)
    assert unit is None or (unit.name == text and unit.scale > 0)


@pytest.mark.parametrize(
    ("written", "nearest"),
    [
        ("celsius", "degC"),
        ("Volts", "V"),
        ("HZ", "Hz"),
        ("mAH", "mAh"),
        ("DEGC", "degC"),
        ("km/hr", "km/h"),
        ("m/sec", "m/s"),
        ("mV/second", "mV/s"),
        ("m / s", "m/s"),
        ("m/s2", "m/s^2"),
        ("m/s\u00b2", "m/s^2"),
        ("m**2", "m^2"),
        ("\u00b5s", "us"),
        ("knots", "kn"),
        ("degE77", "degE7"),
        ("millivolts", "mV"),
        ("Kilometers/hour", "km/h"),
        ("grm", "g"),
    ],
)
def test_the_nearest_unit(written, nearest):
    """The dialects' unit for what people write comes first among those named."""
    assert Unit.parse(written) is None
    assert nearest_unit(written).removeprefix("did you mean ").rstrip("?").split(" or ")[0] == nearest


def test_a_hint_names_units_only():
    """Also where nothing is near."""
    assert [name for name in (*WORDS.values(), *SCALED, *SHOWN) if Unit.parse(name) is None] == []
    assert nearest_unit("furlong") == "units are spelled as in the dialects: V, mA, degC, m/s, degE7"


@pytest.mark.parametrize("bits", [8, 64, 300])
def test_pi(bits):
    """Both bounds, against digits from elsewhere."""
    low, high = pi_between(bits)
    assert low < PI_100 < high
    assert high - low <= Fraction(1, 2**bits)


@given(st.fractions())
@example(Fraction(180))
def test_degrees_as_the_nearest_float(value):
    """By a hundred digits of pi, which is more than any float of this size needs."""
    assert conversion(unit_named("deg"), unit_named("rad")).settled(value, float) == float(value * PI_100 / 180)
    assert conversion(unit_named("rad"), unit_named("deg")).settled(value, float) == float(value * 180 / PI_100)


OVER_PI = [("cdeg", "rad"), ("cdeg", "mrad"), ("mrad", "cdeg"), ("deg/2", "mrad"), ("rpm", "rad/s"), ("mrad", "degE7")]


@given(st.sampled_from(OVER_PI), st.integers(1, 3000))
@example(("mrad", "cdeg"), 6283)  # whose first good approximation moves 2938 onto a half
@example(("cdeg", "mrad"), 36000)
def test_a_fraction_in_place_of_pi_rounds_each_whole_number_alike(units, largest):
    """Down, up and to the nearest: no product passes, or lies on, a multiple of a half that pi does not bring it to."""
    way = conversion(*map(unit_named, units))
    factor = way.whole_factor(largest)
    for number in range(1, largest + 1):
        product = 2 * number * factor
        assert math.floor(product) == way.settled(Fraction(2 * number), math.floor)
        assert product.denominator != 1, number


def test_no_fraction_is_longer_than_it_has_to_be():
    """What comes before it among the best approximations moves a number: the firmware counts in small integers."""
    way = conversion(unit_named("mrad"), unit_named("cdeg"))
    assert way.whole_factor(6283) == Fraction(132634, 23149)
    assert way.whole_factor(100) == Fraction(2034, 355)
    assert conversion(unit_named("cdeg"), unit_named("deg")).whole_factor(10) == Fraction(1, 100)


@given(st.sampled_from(OVER_PI), st.sampled_from([2**20, 2**28 - 1, 2**29 - 1]), st.booleans())
def test_a_close_fraction_is_close_and_of_small_numbers(units, largest, times_twos):
    """Relatively; without powers of 2 there is none where the factor is nearly as small as the numbers allow."""
    way = conversion(*map(unit_named, units))
    found = way.close_factor(largest, times_twos=times_twos)
    exact = way.factor * PI_100**way.pi
    if found is None:
        return
    assert abs(found / exact - 1) < Fraction(1, 2**40)
    odd = [number // (number & -number) for number in (found.numerator, found.denominator)]
    assert max(odd if times_twos else (found.numerator, found.denominator)) <= largest


def test_a_factor_that_small_numbers_do_not_come_close_to():
    """A step of degE7 is 1.7e-9 rad: only with a power of 2 is there a fraction for it."""
    way = conversion(unit_named("degE7"), unit_named("rad"))
    assert way.close_factor(2**28) is None
    assert way.close_factor(2**28, times_twos=True) is not None


def test_a_field_bounds_the_numbers_that_a_fraction_has_to_round_alike():
    """A byte in steps of two degrees has no use for more than 8901 mrad, though the quantity goes on to 2 ** 30."""
    units = unit_named("mrad"), Fraction(1), unit_named("deg/2")
    source = SimpleNamespace(minimum=-(2**30), maximum=2**30)
    factor = _steps(*units, source, SimpleNamespace(type=WIRE_TYPES["uint8_t"]))
    assert 8904 * factor.numerator + factor.denominator < 2**30
    assert round(8901 * factor) == 255
    with_sign = _steps(*units, source, SimpleNamespace(type=WIRE_TYPES["int16_t"]))
    assert with_sign.denominator > 2 * 32768 / factor


def test_half_a_turn_is_pi():
    """As the standard library has it."""
    assert conversion(unit_named("rev"), unit_named("rad")).settled(Fraction(1, 2), float) == math.pi


def test_as_many_digits_as_it_takes():
    """Ninety decimals are more than it begins with."""
    half = conversion(unit_named("rev"), unit_named("rad")).settled(Fraction(1, 2), lambda exact: int(exact * 10**90))
    assert half == int(PI_100 * 10**90)


@pytest.mark.parametrize(
    ("unit", "other", "words"),
    [
        ("deg", "rad", "* 1/180 * pi"),
        ("rad", "deg", "* 180 / pi"),
        ("degC", "K", "+ 273.15"),
        ("K", "cdegC", "* 100 - 27315"),
        ("V", "V", "* 1"),
    ],
)
def test_words_for_a_conversion(unit, other, words):
    """As documents would write it."""
    assert map_words(conversion(unit_named(unit), unit_named(other))) == words


@pytest.mark.parametrize(
    ("value", "text"), [("79/20", "3.95"), ("1/10000", "0.0001"), ("2", "2"), ("1/3", "1/3"), ("-1/2", "-0.5")]
)
def test_decimals_are_exact(value, text):
    """A decimal where one exists, else the fraction."""
    assert decimal(Fraction(value)) == text
