"""Scenarios of the simulation, resolved to plain numbers."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any


class AdcFault(StrEnum):
    """What may be wrong with the ADC inputs: readings fail, the part is absent, or readings take long."""

    FAIL = "fail"
    ABSENT = "absent"
    SLOW = "slow"


@dataclass(frozen=True, slots=True)
class Point:
    """The voltage of the pack at a time: milliseconds since the start, and millivolts."""

    at_ms: int
    millivolts: int


@dataclass(frozen=True, slots=True)
class Arming:
    """The vehicle is armed, or disarmed."""

    at_ms: int
    is_armed: bool


@dataclass(frozen=True, slots=True)
class Reboot:
    """The vehicle is restarted."""

    at_ms: int


@dataclass(frozen=True, slots=True)
class Fault:
    """A fault of the ADC from ``at_ms`` to ``until_ms`` (None: to the end); ``delay_us`` is that of slow readings."""

    at_ms: int
    adc: AdcFault
    until_ms: int | None
    delay_us: int


Event = Arming | Reboot | Fault


@dataclass(frozen=True, slots=True)
class Scenario:
    """One scenario in plain numbers: times in ms, voltages in mV, ``divider`` in millionths. Points ascend in time."""

    name: str
    doc: str
    duration_ms: int
    seed: int
    points: tuple[Point, ...]
    noise_mv: int
    divider_millionths: int
    events: tuple[Event, ...]

    def millivolts(self, at_ms: float) -> float:
        """The voltage of the pack in mV at a time in ms."""
        before = self.points[0]
        for point in self.points:
            if point.at_ms > at_ms:
                if point is before or at_ms <= before.at_ms:
                    return before.millivolts
                share = (at_ms - before.at_ms) / (point.at_ms - before.at_ms)
                return before.millivolts + share * (point.millivolts - before.millivolts)
            before = point
        return before.millivolts


def scenario_data(scenarios: Mapping[str, Scenario]) -> dict[str, Any]:
    """The scenarios by name as JSON, and the mocks, have them: times in ms (delays in us), voltages in mV."""
    return {name: _data(scenario) for name, scenario in scenarios.items()}


def _data(scenario: Scenario) -> dict[str, Any]:
    return {
        "doc": scenario.doc,
        "duration_ms": scenario.duration_ms,
        "seed": scenario.seed,
        "points": [[point.at_ms, point.millivolts] for point in scenario.points],
        "noise_mv": scenario.noise_mv,
        "divider_millionths": scenario.divider_millionths,
        "events": [_event_data(event) for event in scenario.events],
    }


def _event_data(event: Event) -> dict[str, Any]:
    match event:
        case Arming():
            return {"at_ms": event.at_ms, "arm": event.is_armed}
        case Reboot():
            return {"at_ms": event.at_ms, "reboot": True}
        case Fault():
            data = {"at_ms": event.at_ms, "adc": str(event.adc), "until_ms": event.until_ms}
            return data | ({"delay_us": event.delay_us} if event.adc is AdcFault.SLOW else {})
