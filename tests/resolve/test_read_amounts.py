"""Amounts of the tables in the unit that is needed: exact, or the nearest float for a float field; else a finding."""

import math
from fractions import Fraction

import pytest

from codegen.diagnostics import Report
from codegen.measure import obstacle, read_amount, read_real, read_time
from codegen.model.units.unit import unit_named
from codegen.source import Place

HERE = Place("table.yaml", 3, 7)


def findings(report: Report) -> list[tuple[str, str]]:
    return [(found.rule.id, found.message) for found in report]


def test_an_offset_is_part_of_an_amount():
    """degC where K is needed, and back."""
    report = Report()
    assert read_amount("21.5 degC", unit_named("K"), HERE, report) == Fraction("294.65")
    assert read_amount("0 K", unit_named("cdegC"), HERE, report) == -27315
    assert read_real("-273.15 degC", unit_named("K"), HERE, report) == 0.0
    assert findings(report) == []


@pytest.mark.parametrize(
    ("amount", "unit", "value"),
    [
        ("180 deg", "rad", math.pi),
        ("-90 deg", "rad", -math.pi / 2),
        ("60 rpm", "rad/s", math.tau),
        ("1 rad", "deg", 180 / math.pi),
    ],
)
def test_an_angle_is_the_nearest_float(amount, unit, value):
    """As math has it; an amount that has to be exact is refused, with what lies between."""
    report = Report()
    assert read_real(amount, unit_named(unit), HERE, report) == value
    assert findings(report) == []
    assert read_amount(amount, unit_named(unit), HERE, report) is None
    assert [rule for rule, _ in findings(report)] == ["uncarried-conversion"]


def test_what_the_firmware_does_not_carry_out_is_told():
    """Only what lies between units of one dimension, beside a factor."""
    said = obstacle(unit_named("deg"), unit_named("rad"))
    assert said == "the firmware's whole numbers do not carry out deg * 1/180 * pi = rad"
    assert obstacle(unit_named("deg"), unit_named("degE7")) is None
    assert obstacle(unit_named("deg"), unit_named("V")) is None


@pytest.mark.parametrize(
    ("amount", "hint"),
    [
        ("1e300 m", "write a number and a unit, such as 1 V; a number has up to 20 digits"),
        ("3 volts", "did you mean V"),
        ("much", "write a number and a unit, such as 1 V; a number has up to 20 digits"),
    ],
)
def test_the_hint_is_about_what_is_wrong(amount, hint):
    """A unit that is known needs no other one."""
    report = Report()
    assert read_amount(amount, unit_named("V"), HERE, report) is None
    (finding,) = report
    assert finding.hint.startswith(hint)


def test_times_up_to_a_day():
    """In whole steps of the unit."""
    report = Report()
    assert read_time("1 h", unit_named("ms"), HERE, report) == 3_600_000
    assert read_time("86400 s", unit_named("us"), HERE, report) == 86_400_000_000
    assert findings(report) == []
    assert read_time("86401 s", unit_named("us"), HERE, report) is None
    assert read_time("0.5 ms", unit_named("ms"), HERE, report) is None
    assert [rule for rule, _ in findings(report)] == ["bad-time", "bad-time"]
