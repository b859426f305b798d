"""Scenarios of the simulation, resolved to plain numbers."""

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from typing import Any

from codegen.frozen import dataclass


class AdcFault(StrEnum):
    """What may be wrong with the ADC inputs: readings fail, the part is absent, or readings take long."""

    FAIL = "fail"
    ABSENT = "absent"
    SLOW = "slow"


@dataclass(frozen=True, slots=True)
class Point:
    """A value at a time: milliseconds since the start, and millivolts (``value`` of a voltage) or milliamperes."""

    at_ms: int
    value: int


@dataclass(frozen=True, slots=True)
class Battery:
    """The true battery of one instance: its voltage in mV and its current in mA over time, ascending in time.

    ``divider_millionths`` is the pack's voltage over that at the ADC pin; no ``currents``: none is stated.
    """

    points: tuple[Point, ...]
    noise_mv: int
    divider_millionths: int
    currents: tuple[Point, ...] = ()

    def millivolts(self, at_ms: float) -> float:
        """The voltage of the pack in mV at a time in ms."""
        return value_at(self.points, at_ms)

    def milliamperes(self, at_ms: float) -> float | None:
        """The current drawn from the pack in mA at a time in ms; None where the scenario states none."""
        return value_at(self.currents, at_ms) if self.currents else None


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
    """A fault of the ADC from ``at_ms`` to ``until_ms`` (None: to the end); ``delay_us`` is that of slow readings.

    ``instance`` is the battery whose input has it, from 0.
    """

    at_ms: int
    adc: AdcFault
    until_ms: int | None
    delay_us: int
    instance: int = 0


@dataclass(frozen=True, slots=True)
class Swap:
    """A smart battery is taken out, and another one, with its own board, is in its place from ``until_ms`` on.

    ``batteries`` are those of the new board; None: their course is that of the old ones.
    """

    at_ms: int
    program: str
    until_ms: int
    batteries: tuple[Battery, ...] | None = None


Event = Arming | Reboot | Fault | Swap


@dataclass(frozen=True, slots=True)
class Stretch:
    """A time in which one board runs a program: to ``end_ms``, or to the end. ``number`` counts the boards from 1."""

    number: int
    start_ms: int
    end_ms: int | None
    batteries: tuple[Battery, ...]


@dataclass(frozen=True, slots=True)
class Beside:
    """Another program of the project that runs at the same time, and what it finds."""

    program: str
    batteries: tuple[Battery, ...]
    parameters: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Scenario:
    """One scenario in plain numbers. ``batteries`` are by instance, ``parameters`` are stored before the first start.

    ``beside`` are the other programs that run.
    """

    name: str
    doc: str
    duration_ms: int
    seed: int
    batteries: tuple[Battery, ...]
    events: tuple[Event, ...] = ()
    parameters: Mapping[str, float] = field(default_factory=dict)
    beside: tuple[Beside, ...] = ()

    def stretches(self, program: str | None = None) -> tuple[Stretch, ...]:
        """The boards that run a program, one after the other; None is the vehicle's own, which is never swapped."""
        found = next((beside for beside in self.beside if beside.program == program), None)
        batteries = self.batteries if found is None else found.batteries
        swaps = [event for event in self.events if isinstance(event, Swap) and event.program == program]
        stretches: list[Stretch] = []
        start_ms = 0
        for number, swap in enumerate(swaps, 1):
            stretches.append(Stretch(number, start_ms, swap.at_ms, batteries))
            batteries = batteries if swap.batteries is None else swap.batteries
            start_ms = swap.until_ms
        return (*stretches, Stretch(len(stretches) + 1, start_ms, None, batteries))


def value_at(points: tuple[Point, ...], at_ms: float) -> float:
    """The value at a time in ms: straight lines between the points, which stay before the first and after the last."""
    before = points[0]
    for point in points:
        if point.at_ms > at_ms:
            if point is before or at_ms <= before.at_ms:
                return before.value
            share = (at_ms - before.at_ms) / (point.at_ms - before.at_ms)
            return before.value + share * (point.value - before.value)
        before = point
    return before.value


def battery_data(battery: Battery, seed: int) -> dict[str, Any]:
    """A battery as the mocks have it: times in ms, voltages in mV, currents in mA; ``seed`` starts its noise."""
    return {
        "seed": seed,
        "points": [[point.at_ms, point.value] for point in battery.points],
        "noise_mv": battery.noise_mv,
        "divider_millionths": battery.divider_millionths,
        "currents": [[point.at_ms, point.value] for point in battery.currents],
    }


def event_data(event: Event) -> dict[str, Any] | None:
    """An event as the mocks have it: times in ms, delays in us; None for what does not happen on the board itself."""
    match event:
        case Arming():
            return {"at_ms": event.at_ms, "arm": event.is_armed}
        case Reboot():
            return {"at_ms": event.at_ms, "reboot": True}
        case Fault():
            data = {"at_ms": event.at_ms, "adc": str(event.adc), "until_ms": event.until_ms, "instance": event.instance}
            return data | ({"delay_us": event.delay_us} if event.adc is AdcFault.SLOW else {})
        case Swap():
            return None
