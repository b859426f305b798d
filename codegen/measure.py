"""Amounts and units as the tables write them, read with a finding where they are wrong."""

import math
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Report, Rule
from codegen.model.dialect.dialect import WireField
from codegen.model.units.affine import AffineMap
from codegen.model.units.finer_unit import as_fine_as
from codegen.model.units.nearest_unit import nearest_unit
from codegen.model.units.unit import NUMBER, Measure, Unit, conversion, decimal, map_words, read_measure, unit_named
from codegen.source import Place

UNKNOWN_UNIT = Rule(
    "unknown-unit",
    "A unit is not one that the generator can convert. Units are spelled as in the dialects: V, mV, cA, degC, d%, and "
    "what is made of them: m/s/s, cm^3/min. docs/units.md lists them.",
)
UNIT_MISMATCH = Rule(
    "unit-mismatch",
    "A value in one dimension is used where another is needed, such as a current for a charge. "
    "Only units of one dimension convert into each other.",
    remedy="write a unit of the same kind, or name something that has one",
)
UNCARRIED_CONVERSION = Rule(
    "uncarried-conversion",
    "Two units measure the same, but from one to the other leads an offset (degC and K), or pi (deg and rad) where a "
    "quantity is kept in another unit than its own, or where the numbers get too small. The firmware multiplies and "
    "divides whole numbers: a value would be wrong. Keep the quantity in the unit of the field, or in one that only a "
    "factor leads to. Nor is an amount in deg an exact number of rad.",
    remedy="keep the quantity in the field's unit, or in one that only a factor leads to",
)
BAD_AMOUNT = Rule("bad-amount", "An amount is a number followed by a unit, such as 3.3 V, 10 Hz or 2 ms.")
BAD_TIME = Rule(
    "bad-time",
    "A rate is above 0 and at most 1000 Hz, and a time is at most a day: the firmware counts whole milliseconds on a "
    "clock that wraps after 12 days. Readings of a component are whole milliseconds apart, so that of what is counted "
    "in readings everybody knows the time.",
)
DAY_S = 86400
_WHOLE_MS = sorted(
    2**twos * 5**fives for twos in range(27) for fives in range(12) if 2**twos * 5**fives <= DAY_S * 1000
)
"""The ms between readings of which the rate in Hz is a decimal number."""


def find_unit(name: str | None, place: Place, report: Report) -> Unit | None:
    """The unit called ``name``, or the unit of pure numbers for None."""
    if name is None:
        return NUMBER
    unit = Unit.parse(name)
    if unit is None:
        report.add(UNKNOWN_UNIT, place, f"{name!r} is not a known unit", nearest_unit(name))
    return unit


def unknown_field_unit(field: WireField) -> Diagnostic:
    """Return the finding, at a field, that the unit in the dialect is not known; the same for all who ask."""
    units = field.definition.units or ""
    hint = f"{nearest_unit(units)}; corrections.yaml can set its units"
    return Diagnostic(field.definition.place, UNKNOWN_UNIT, f"{field.name} is in {units!r}, no known unit", hint)


def obstacle(unit: Unit, other: Unit) -> str | None:
    """Return what lies between two units of one dimension beside a factor, in words; None where nothing else does."""
    found = conversion(unit, other)
    if found is None or found.ratio is not None:
        return None
    return f"the firmware's whole numbers do not carry out {unit.name} {map_words(found)} = {other.name}"


def other_steps(unit: Unit, stored: Unit) -> str:
    """Return the hint for a ``stored`` to which no factor leads from ``unit``: one that is as fine."""
    found = as_fine_as(unit, stored)
    if unit.dimension != stored.dimension or found == unit:
        return f"write a unit to which a factor leads from {unit.name or 'a number'}"
    return f"stored: {found.name}, to which a factor leads from {unit.name}"


def read_amount(text: str, unit: Unit, place: Place, report: Report, *, is_difference: bool = False) -> Fraction | None:
    """The number of ``text`` (an amount) in ``unit``, exactly; of a difference, 5 degC are 5 K, wherever 0 is."""
    found = _converted(text, unit, place, report)
    if found is None:
        return None
    measure, way = found
    if is_difference:
        way = AffineMap(way.factor, way.pi)
    value = way.exact(measure.value)
    if value is None:
        message = f"{text} is no exact number of {unit.name}: {measure.unit.name} is {map_words(way)}"
        report.add(UNCARRIED_CONVERSION, place, message, f"give it in {unit.name}")
    return value


def read_real(text: str, unit: Unit, place: Place, report: Report) -> float | None:
    """The number of ``text`` (an amount) in ``unit``, as the nearest float: 180 deg are a number of rad, too."""
    found = _converted(text, unit, place, report)
    return None if found is None else found[1].settled(found[0].value, nearest_float)


def nearest_float(value: Fraction) -> float:
    """Return the nearest float; of what lies beyond the largest one an infinite one."""
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def read_exactly(text: str, unit: Unit, place: Place, report: Report) -> Fraction | None:
    """The same as a fraction: that number itself, where it is one."""
    found = _converted(text, unit, place, report)
    if found is None:
        return None
    measure, way = found
    exact = way.exact(measure.value)
    return Fraction(way.settled(measure.value, float)) if exact is None else exact


def _converted(text: str, unit: Unit, place: Place, report: Report) -> tuple[Measure, AffineMap] | None:
    """An amount, and what turns it into ``unit``; None after a finding."""
    measure = read_measure(text)
    if measure is None:
        parts = text.split()
        wanted = f"a number and a unit, such as 1 {unit.name}" if unit.name else "a number"
        is_misspelt = len(parts) == 2 and Unit.parse(parts[1]) is None
        hint = nearest_unit(parts[1]) if is_misspelt else f"write {wanted}; a number has up to 20 digits"
        report.add(BAD_AMOUNT, place, f"{text!r} is not an amount", hint)
        return None
    way = conversion(measure.unit, unit)
    if way is None:
        report.add(
            UNIT_MISMATCH,
            place,
            f"{text} is {measure.unit.a_kind}, but {unit.a_kind} is needed",
            f"give it in {unit.name}" if unit.name else "give a number without a unit",
        )
        return None
    return measure, way


def read_rate(text: str, place: Place, report: Report) -> Fraction | None:
    """A rate in Hz that the scheduler can keep: once a day to 1000 times a second."""
    rate = read_amount(text, unit_named("Hz"), place, report)
    if rate is not None and not Fraction(1, DAY_S) <= rate <= 1000:
        report.add(BAD_TIME, place, f"{text} is not a rate from once a day to 1000 Hz", "such as 10 Hz")
        return None
    return rate


def read_period_ms(text: str, place: Place, report: Report) -> int | None:
    """The whole ms between two readings at a rate in Hz; None after a finding for which nobody knows them."""
    rate = read_rate(text, place, report)
    if rate is None:
        return None
    period = 1000 / rate
    nearest = round(period)
    if period != nearest:
        whole = min(_WHOLE_MS, key=lambda each: abs(each - nearest))
        hint = f"{decimal(Fraction(1000, whole))} Hz is once in {whole} ms"
        report.add(BAD_TIME, place, f"{text} is once in {float(period):.5g} ms, and readings are whole ms apart", hint)
    return nearest


def read_time(text: str, unit: Unit, place: Place, report: Report) -> int | None:
    """A time in whole ``unit`` (ms or us), above 0 and at most a day."""
    time = read_amount(text, unit, place, report)
    if time is None:
        return None
    day = Measure(Fraction(DAY_S), unit_named("s")).in_unit(unit)
    assert day is not None
    if not 1 <= time <= day or time.denominator != 1:
        report.add(
            BAD_TIME,
            place,
            f"{text} is not a time of whole {unit.name}, above 0 and at most a day",
            f"such as 500 {unit.name}",
        )
        return None
    return int(time)


def read_number(written: str | Fraction, unit: Unit, place: Place, report: Report) -> Fraction | None:
    """A plain number, taken to be in ``unit``, or an amount converted to it."""
    return written if isinstance(written, Fraction) else read_amount(written, unit, place, report)
