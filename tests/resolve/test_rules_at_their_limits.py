"""Rules that compare with a number speak from that number on, and not before."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.model.quantities.reach import reaches
from codegen.model.system import System
from codegen.project.systems import read_system
from codegen.rules import live_float, reading_beyond, stream_rate
from codegen.source import Place

ROVER = Path(__file__).resolve().parents[2] / "specs" / "codegen.yaml"
RADIO_ROVER = Path(__file__).resolve().parents[1] / "projects" / "radio_rover" / "specs" / "codegen.yaml"
PLACE = Place("table.yaml")


@pytest.fixture(scope="module")
def rover() -> System:
    system = read_system(str(ROVER), Report())
    assert system is not None
    return system


@pytest.mark.parametrize(("times", "count"), [("1", 0), ("1.0005", 1), ("2", 1)])
def test_a_stream_may_be_as_fast_as_the_values_are_updated(rover: System, times: str, count: int) -> None:
    """Half a part in a thousand more is more: some values go out twice."""
    message = next(each for each in rover.messages if each.name == "BATTERY_STATUS")
    period = rover.components["battery"].period_ms
    assert period is not None
    stream: Any = SimpleNamespace(default_rate=Fraction(1000, period) * Fraction(times))
    found = list(stream_rate.check(replace(rover, messages=(replace(message, stream=stream),))))
    assert [finding.rule.id for finding in found] == ["rate-above-update"] * count


@pytest.mark.parametrize(("limits", "count"), [((0, 100), 0), ((0, 99), 1), ((1, 100), 1)])
def test_an_estimate_lies_between_the_ends_of_its_curve(
    monkeypatch: pytest.MonkeyPatch, limits: tuple[int, int], count: int
) -> None:
    """Whatever a voltage can be, a curve from 0 to 100 % gives nothing beyond."""
    system = read_system(str(RADIO_ROVER), Report())
    assert system is not None
    monkeypatch.setattr(reading_beyond, "reaches", lambda system: {**reaches(system), "pack.charge": limits})
    found = [finding.message for finding in reading_beyond.check(system)]
    assert found == ["pack.charge is 0 to 100 %"] * count


def scaled(factor: Fraction, size: int) -> Any:
    """A system with one float field of so many bytes, which takes a whole number times a factor."""
    kind = SimpleNamespace(is_integer=False, size=size, name="float")
    field = SimpleNamespace(type=kind, unit_text="", definition=SimpleNamespace(place=PLACE))
    covers = SimpleNamespace(field=field, written=SimpleNamespace(place=PLACE), label="a")
    answer = SimpleNamespace(covers=covers, scalings=[SimpleNamespace(factor=factor)])
    return SimpleNamespace(messages=[SimpleNamespace(name="M", answers=[answer])])


@pytest.mark.parametrize(
    ("factor", "size", "count"),
    [
        (Fraction(1, 2**126), 4, 0),
        (Fraction(3, 2**127), 4, 0),
        (Fraction(1, 2**127), 4, 1),
        (Fraction(1, 2**127), 8, 0),
        (Fraction(live_float.NUMERATOR_MAX), 4, 0),
        (Fraction(live_float.NUMERATOR_MAX + 2), 4, 1),
        (Fraction(1, live_float.DIVISOR_MAX), 8, 0),
        (Fraction(1, live_float.DIVISOR_MAX + 2), 8, 1),
    ],
)
def test_the_smallest_step_and_the_largest_factor_of_a_float(factor: Fraction, size: int, count: int) -> None:
    assert len(list(live_float.check(scaled(factor, size)))) == count
