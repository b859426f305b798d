"""Amounts and units as the tables write them, read with a finding where they are wrong."""

from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.unit import NUMBER, UNITS, Unit, read_measure
from codegen.source import Place

UNKNOWN_UNIT = Rule(
    "unknown-unit",
    "A unit is not one that the generator can convert. Units are spelled as in the dialects: V, mV, cA, degC, d%.",
)
UNIT_MISMATCH = Rule(
    "unit-mismatch",
    "A value in one dimension is used where another is needed, such as a current for a charge. "
    "Only units of one dimension convert into each other.",
)
BAD_AMOUNT = Rule("bad-amount", "An amount is a number followed by a unit, such as 3.3 V, 10 Hz or 2 ms.")
BAD_TIME = Rule(
    "bad-time",
    "A rate is above 0 and at most 1000 Hz, and a time is at most a day: the firmware counts whole milliseconds on a "
    "clock that wraps after 12 days.",
)
DAY_S = 86400


def find_unit(name: str | None, place: Place, report: Report) -> Unit | None:
    """The unit called ``name``, or the unit of pure numbers for None."""
    if name is None:
        return NUMBER
    unit = UNITS.get(name)
    if unit is None:
        report.add(UNKNOWN_UNIT, place, f"{name!r} is not a known unit", did_you_mean(name, UNITS))
    return unit


def read_amount(text: str, unit: Unit, place: Place, report: Report) -> Fraction | None:
    """The number of ``text`` (an amount) in ``unit``."""
    measure = read_measure(text)
    if measure is None:
        parts = text.split()
        hint = did_you_mean(parts[1], UNITS) if len(parts) == 2 else f"write a number and a unit, such as 1 {unit.name}"
        report.add(BAD_AMOUNT, place, f"{text!r} is not an amount", hint)
        return None
    value = measure.in_unit(unit)
    if value is None:
        report.add(
            UNIT_MISMATCH,
            place,
            f"{text} is a {measure.unit.dimension}, but a {unit.dimension} is needed",
            f"give it in {unit.name}" if unit.name else "give a number without a unit",
        )
    return value


def read_rate(text: str, place: Place, report: Report) -> Fraction | None:
    """A rate in Hz that the scheduler can keep: once a day to 1000 times a second."""
    rate = read_amount(text, UNITS["Hz"], place, report)
    if rate is not None and not Fraction(1, DAY_S) <= rate <= 1000:
        report.add(BAD_TIME, place, f"{text} is not a rate from once a day to 1000 Hz")
        return None
    return rate


def read_time(text: str, unit: Unit, place: Place, report: Report) -> int | None:
    """A time in whole ``unit`` (ms or us), above 0 and at most a day."""
    time = read_amount(text, unit, place, report)
    if time is None:
        return None
    if not 1 <= time <= DAY_S * unit.factor or time.denominator != 1:
        report.add(BAD_TIME, place, f"{text} is not a time of whole {unit.name}, above 0 and at most a day")
        return None
    return int(time)


def read_number(written: str | Fraction, unit: Unit, place: Place, report: Report) -> Fraction | None:
    """A plain number, taken to be in ``unit``, or an amount converted to it."""
    return written if isinstance(written, Fraction) else read_amount(written, unit, place, report)
