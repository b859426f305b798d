"""Rules that compare with a number speak from that number on, and not before."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.model.quantities.reach import reaches
from codegen.model.quantities.summed import Lasting, Sum
from codegen.model.system import System
from codegen.project.systems import read_system
from codegen.rules import live_float, reading_beyond, small_int, stream_rate
from codegen.source import Place

ROVER = Path(__file__).resolve().parents[2] / "specs" / "codegen.yaml"
PROJECTS = Path(__file__).resolve().parents[1] / "projects"
RADIO_ROVER = PROJECTS / "radio_rover" / "specs" / "codegen.yaml"
MONITOR = PROJECTS / "power_monitor" / "specs" / "codegen.yaml"
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


# The largest intermediate result of each, by hand: counts and steps at the ends of their ranges.
REACHED = {
    "battery.voltage": 4095 * 100_000,
    "battery.current": 4095 * 9_900,
    "battery.consumed": 326_700 * 1_000 + 3_600_000,
    "battery.energy": 1_000 * 33_000 + 1_000**3,
    "battery.remaining": 1_000_000 * (100 + 1),
    "battery.left": 1_000_000 * (1 + 1),
    "battery.time_left": 1_000_000 * 900,
    "current_battery": 327_680 + 2 + 10,
    "pack.voltage": 4095 * 10_000,
    "pack.current": 273_000 * 220 + 273_000 * 273 + 273_000 // 2,
    "pack.consumed": 16_500 * 500 + 360_000,
    "pack.energy": 1_000 * 33_000 + 1_000**3,
    "pack.left": 100_000 * (1 + 1),
    "pack.remaining": 100_000 * (100 + 1),
    "pack.time_left": 100_000 * 360,
    "tank.level": 273 * 22 + 273 * 5_460 + 273 // 2,
}


def test_how_far_the_arithmetic_of_the_steady_path_reaches(rover: System, monkeypatch: pytest.MonkeyPatch) -> None:
    """A bound that is too small allocates on a board; one that is too large refuses a specification that works."""
    monitor = read_system(str(MONITOR), Report())
    assert monitor is not None
    monkeypatch.setattr(small_int, "SMALL_INT_MAX", 0)
    told = [finding.message for system in (rover, monitor) for finding in small_int.check(system)]
    assert {text.partition(":")[0]: int(text.rpartition(" ")[2]) for text in told} == REACHED


def converted(numerator: int, denominator: int, low: int, high: int, away: int = 0, offset_numerator: int = 0) -> Any:
    """A system with a reading of 12 bits by a multiplier, ``low`` to ``high``, and an offset of -``away`` to 1."""
    conversion = SimpleNamespace(
        channel=SimpleNamespace(full_scale=4095),
        multiplier=SimpleNamespace(name="MULT", minimum=low, maximum=high),
        numerator=numerator,
        denominator=denominator,
        offset=SimpleNamespace(minimum=-away, maximum=1) if away else None,
        offset_numerator=offset_numerator,
    )
    quantity = SimpleNamespace(path="volts", spec=SimpleNamespace(at=lambda _: PLACE))
    reading = SimpleNamespace(quantity=quantity, conversion=conversion)
    return SimpleNamespace(readings=lambda: (reading,), components={}, messages=())


@pytest.mark.parametrize(
    ("system", "most"),
    [
        (converted(1, 2, 0, 7), 4095 * 7),
        (converted(1, 2, -9, 7), 4095 * 9),
        (converted(1, 3, 0, 7, away=5_000, offset_numerator=1), 5_000 * 7),
        (converted(2, 1_000_000, 0, 7), (4095 * 7 + 1) * 2 + 500_000),
        (converted(30, 20_000, 0, 7), 20_000 * 30 + 10_000),
        (converted(30, 40_000, -1, 7), 40_000 * 30 + 20_000),
        (converted(30, 40_000, 0, 7, away=1, offset_numerator=3), 40_000 * 33 + 20_000),
        (converted(9, 4, 0, 7, away=8, offset_numerator=5), (4095 * 7 // 4 + 1) * 9 + (8 * 7 // 4 + 1) * 5),
    ],
)
def test_how_far_a_conversion_reaches(system: Any, most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """A product, what is left of it, or what comes out: whichever is largest may be a small integer, and no more."""
    told = []
    for limit in (most, most - 1):
        monkeypatch.setattr(small_int, "_sums", lambda *_: ())  # which has its own test
        monkeypatch.setattr(small_int, "SMALL_INT_MAX", limit)
        told += [finding.message for finding in small_int.check(system)]
    assert told == [f"volts: the conversion from counts reaches {most}"]


def counted(most: int, stale_ms: int | None, **derivations: Any) -> Any:
    """A system that counts of what a sensor gives, -``most`` to 1, and has other quantities with their derivations."""
    nothing = {"sums": None, "remains": None, "lasts": None, "conversion": None, "gives": ()}
    output = SimpleNamespace(low=-most, high=1)
    measured = {"gives": (("", output, Fraction(1)),)}
    quantities = {
        name: SimpleNamespace(
            name=name,
            component="pack",
            path=name,
            spec=SimpleNamespace(place=PLACE),
            trust=SimpleNamespace(stale_after_ms=stale_ms),
            derivation=SimpleNamespace(**{**nothing, **derivation}),
        )
        for name, derivation in {"of": measured, **derivations}.items()
    }
    component = SimpleNamespace(quantities=quantities, instances=1)
    given = tuple(quantities.values())
    component.counted_on = [SimpleNamespace(component=component, quantity=quantities["of"], given=given)]
    return SimpleNamespace(components={"pack": component}, messages=(), readings=lambda: ())


def high(most: int) -> dict[str, Any]:
    """How a quantity that a sensor gives as well comes about."""
    return {"gives": (("", SimpleNamespace(low=0, high=most), Fraction(1)),)}


CAPACITY = SimpleNamespace(maximum=500)
LEFT = SimpleNamespace(full=CAPACITY, after="sum", steps=3, share=None)


@pytest.mark.parametrize(
    ("system", "path", "most"),
    [
        (counted(40, 700, sum={"sums": Sum("of", None, 3_600)}), "sum", 40 * 700 + 3_600),
        (counted(40, None, sum={"sums": Sum("of", None, 3_600)}), "sum", 3_600),
        (
            counted(10**6, 90_000, other=high(11), sum={"sums": Sum("of", "other", 7 * 10**6)}),
            "sum",
            10**6 * 90_000 + 7,
        ),
        (
            counted(10**6, 3_000, other=high(10**7), sum={"sums": Sum("of", "other", 7_000)}),
            "sum",
            (3_000 + 2) * 10**7 + 7,
        ),
        (counted(40, 700, sum={"sums": Sum("of", "gone", 7 * 10**6)}), "sum", 40 * 700 + 7),
        (counted(40, 700, left={"remains": LEFT}), "left", 500 * 3 * 2),
        (
            counted(9_000, 1, left={"remains": LEFT}, time={"lasts": Lasting("left", "of", 10, 6)}),
            "time",
            9_000 * 121,
        ),
        (counted(5, 1, left={"remains": LEFT}, time={"lasts": Lasting("left", "of", 10, 36)}), "time", 1_500 * 36),
        (counted(5, 1, time={"lasts": Lasting("gone", "of", 10, 360)}), "time", 5 * 121),
    ],
)
def test_how_far_counting_reaches(system: Any, path: str, most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each product that can be the largest one; it may be as large as a small integer, and no larger."""
    for limit, count in ((most, 0), (most - 1, 1)):
        monkeypatch.setattr(small_int, "SMALL_INT_MAX", limit)
        found = [finding.message for finding in small_int.check(system) if finding.message.startswith(f"{path}:")]
        assert found == [f"{path}: counting it reaches {most}"] * count
