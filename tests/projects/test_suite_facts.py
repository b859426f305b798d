"""Facts that the generated suite compares with: they are those of the specification, and made by no firmware."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.model.code.storage import Storage
from codegen.model.failsafe import Sense
from codegen.model.spec.failsafe import Watching
from codegen.model.system import System
from codegen.model.vehicle import QuantityKind
from codegen.project.systems import read_system
from codegen.targets.suite.expected import nominal, nominal_values
from codegen.targets.suite.facts.components import component_facts
from codegen.targets.suite.facts.failsafes import pairs
from codegen.targets.suite.facts.generations import message_facts
from codegen.targets.suite.facts.readings import reading_facts
from codegen.targets.suite.files import render_suite

ROVER = Path(__file__).resolve().parents[2] / "specs" / "codegen.yaml"
MINIMAL = Path(__file__).parent / "minimal" / "specs" / "codegen.yaml"


@pytest.fixture(scope="module")
def rover() -> System:
    system = read_system(str(ROVER), Report())
    assert system is not None
    return system


def test_another_pack_begins_with_sums_of_nothing_and_the_rest_as_it_starts(rover: System) -> None:
    battery = next(facts for facts in component_facts(rover) if facts.name == "battery")
    assert battery.returns is not None
    anew = dict(battery.returns.restarting)
    assert {name for name, value in anew.items() if value == "0"} == {"consumed_mah", "energy_hj"}
    assert (anew["counted_from_full"], anew["current_ma"]) == ("False", "None")


def test_what_code_sets_is_forgotten_by_readings_of_the_voltage_alone(rover: System) -> None:
    """BATT_MONITOR 4 measures the current, and 3 only the voltage: with 0 nothing is read, and nothing forgotten."""
    battery = next(facts for facts in component_facts(rover) if facts.name == "battery")
    together = battery.set_together
    assert together is not None
    assert together.readings == 50  # 5 s at 10 Hz
    assert (together.alone, together.counted) == (("temperature_cdegc",), ("consumed_mah", "energy_hj"))
    assert (together.on, together.off) == (
        {"batt2_monitor": 0, "batt_monitor": 4},
        {"batt2_monitor": 0, "batt_monitor": 3},
    )


def test_what_is_known_of_the_current(rover: System) -> None:
    """Its settings, the ends of its factors, and what is counted of it: an ampere-hour are 3600 s, read in ms."""
    (current,) = reading_facts(rover)
    second = {"batt2_monitor": 0}
    assert current.on == {**second, "batt_monitor": 4}
    assert current.off == tuple({**second, "batt_monitor": value} for value in (0, 3, 29))
    least, most = current.extremes
    assert [(each["batt_amp_pervlt"], each["batt_amp_offset"]) for each in (least, most)] == [(0, 0), (9900, 3300)]
    assert current.builders == ("sys_status", "battery_status", "battery_status_v2")
    assert (current.own.component, current.own.several, current.full_scale) == ("battery", True, 4095)
    assert len({rover_value(rover, count) for count in current.own.counts}) == 2
    charge, energy = current.sums
    assert (charge.times, charge.is_after, charge.parts) == (None, False, 3_600 * 1_000)
    assert (energy.times, energy.is_after, energy.parts) == ("voltage_mv", True, 10**6 * 100 * 1_000)
    share, left = current.rests
    assert (share.attribute, share.steps, share.share, share.sizes) == ("remaining_pct", 1, 100, (0, 7, 3300))
    assert (left.attribute, left.share, left.after, left.full) == ("left_mah", None, "consumed_mah", "batt_capacity")
    assert current.lasting is not None
    assert (current.lasting.left, current.lasting.factor, current.lasting.readings) == ("left_mah", 3_600, 300)


def rover_value(rover: System, count: int) -> int:
    """The current at a count, with the default factors."""
    conversion = next(each.conversion for each in rover.readings() if each.name == "battery_current")
    return conversion.stored(count, *(factor.default for factor in conversion.factors))


def test_what_is_known_of_messages(rover: System) -> None:
    """Frames without and with the zeros at the end, rates, and where the number of an instance stands."""
    facts = {each.id: each for each in message_facts(rover)}
    heartbeat, status = facts[0], facts[147]
    assert (heartbeat.component, heartbeat.enabled, heartbeat.instances, heartbeat.pages) == (None, None, 1, 1)
    assert (heartbeat.frames, heartbeat.rate, heartbeat.number_at) == (((21, 21),), 1.0, None)
    assert (status.component, status.enabled, status.instances) == ("battery", "monitored", 2)
    assert (status.frames, status.rate, status.number_at) == (((47, 63), (47, 63)), 2.0, 32)
    assert facts[369].frames == ((13, 38), (39, 39))  # the second one's number is not zero, and the last byte
    assert (status.watched, status.on_connection) == (None, False)


def test_which_failsafes_are_pairs(rover: System) -> None:
    """Two latched levels below parameters of what is measured; whatever else it says makes another one of it."""
    assert rover.program is not None
    (battery,) = rover.program.failsafes
    assert pairs(rover, rover.program) == (battery,)
    low, critical = battery.levels
    spec, enabled = battery.spec, next(iter(rover.parameters.values()))
    assert low.conditions[0].limit is not None
    above = replace(low.conditions[0], sense=Sense.ABOVE)
    amount = replace(low.conditions[0], limit=replace(low.conditions[0].limit, parameter=None))
    at_once, unlimited = replace(low.conditions[0], after=None), replace(low.conditions[0], limit=None)
    for other in (
        replace(battery, quantity=None),
        replace(battery, quantity=rover.components["vehicle"].quantities["load"]),
        replace(battery, believed_above=None),
        replace(battery, levels=(low,)),
        replace(battery, levels=(low, critical, critical)),
        replace(battery, spec=replace(spec, latch=False)),
        replace(battery, spec=replace(spec, arming=False)),
        replace(battery, spec=replace(spec, when=Watching.ALWAYS)),
        replace(battery, enabled_by=enabled),
        replace(battery, levels=(replace(low, action=None), critical)),
        replace(battery, levels=(replace(low, text=replace(low.text, written="other")), critical)),
        *(
            replace(battery, levels=(replace(low, conditions=(first, *low.conditions[1:])), critical))
            for first in (above, amount, at_once, unlimited)
        ),
    ):
        assert pairs(rover, replace(rover.program, failsafes=(other,))) == ()


def quantity(kind: QuantityKind, storage: Storage, low: Any, high: Any, initial: Any = None, **spec: Any) -> Any:
    """A quantity as far as its plain value depends on it."""
    return SimpleNamespace(
        kind=kind,
        storage=storage,
        minimum=low,
        maximum=high,
        initial=initial,
        elements=(3, 2),
        spec=SimpleNamespace(**{"min": None, "max": None, **spec}),
    )


NUMBER, SMALL = QuantityKind.NUMBER, Storage.SMALL


@pytest.mark.parametrize(
    ("one", "plain", "listed"),
    [
        (quantity(QuantityKind.BOOLEAN, SMALL, 0, 1), 0, (0, 1)),
        (quantity(QuantityKind.BOOLEAN, SMALL, 0, 1, initial=1), 1, (1, 1)),
        (quantity(QuantityKind.ENUM, SMALL, 0, 9, initial=5), 5, (5, 9)),
        (quantity(NUMBER, SMALL, 0, 100), 50, (50, 57)),
        (quantity(NUMBER, SMALL, 1, 100), 50, (50, 57)),
        (quantity(NUMBER, SMALL, -5000, 5000), 1237, (1237, 1244)),
        (quantity(NUMBER, SMALL, -5000, 5001), 0, (0, 7)),
        (quantity(NUMBER, SMALL, 48, 53), 50, (50, 53)),
        (quantity(NUMBER, Storage.UINT64, 7, 14 + 2**40), 7 + (7 + 2**40) * 5 // 7, None),
        (quantity(NUMBER, Storage.BINARY32, -1e9, 1e9), Fraction(1237, 64), (Fraction(1237, 64), Fraction(1293, 64))),
        (quantity(NUMBER, Storage.BINARY32, 0, 96, min=0, max=96), 64, (64, Fraction(131, 2))),
        (quantity(NUMBER, Storage.BINARY32, 0, 96, max=96), 64, (64, Fraction(519, 8))),
    ],
)
def test_the_plain_value_of_a_quantity(one: Any, plain: Any, listed: Any) -> None:
    """In the middle of its limits, or a small odd number without any; elements differ, and stay within the limits."""
    assert nominal(one) == plain
    if listed is not None:
        assert nominal_values(one, 1) == listed
        assert len(nominal_values(one, 0)) == 3  # type: ignore[arg-type]
    one.elements = None
    assert nominal_values(one, 1) == plain


@pytest.mark.parametrize(("fastest", "looks", "away_us"), [(50, 100, 10_000), (51, 400, 2_500)])
def test_streams_are_looked_at_twice_as_often_as_they_send(fastest: int, looks: int, away_us: int) -> None:
    """For 40 seconds, which are so many passes."""
    system = read_system(str(MINIMAL), Report())
    assert system is not None
    streams = {name: replace(stream, fastest=Fraction(fastest)) for name, stream in system.streams.items()}
    messages = tuple(
        replace(each, stream=streams[each.stream.name] if each.stream else None) for each in system.messages
    )
    text = render_suite(replace(system, streams=streams, messages=messages))["tests/behaviour.py"]
    body = text.partition("def sent_in_40_seconds(")[2].partition("\n\n\n")[0]
    assert f" in which {looks} passes a second" in body
    assert f"range({40 * looks})" in body
    assert f"advance_us({away_us})" in body
