"""Scenarios of the simulation as ``scenarios.yaml`` states them."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from codegen.model.described import Amount, described
from codegen.model.scenario import AdcFault
from codegen.source import Written

Points = tuple[tuple[Amount, ...], ...]
"""Pairs of a time and a voltage."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EventSpec(Written):
    """Something that happens at a time: exactly one of arm, adc and reboot."""

    at_: Amount = described("Time since the start, such as 5 s.", key="at")
    arm: bool | None = described("true arms the vehicle, false disarms it.", default=None)
    adc: AdcFault | None = described(
        "Fault of the ADC: fail (readings fail), absent (not there when the board starts; only at 0 s), slow (readings "
        "take the time that delay gives).",
        default=None,
    )
    reboot: bool | None = described("true restarts the vehicle.", default=None)
    for_: Amount | None = described("How long the fault lasts; to the end without it.", key="for", default=None)
    delay: Amount | None = described("How long one reading takes while it is slow, such as 3 ms.", default=None)

    ONE_OF: ClassVar[tuple[str, ...]] = ("arm", "adc", "reboot")


@dataclass(frozen=True, slots=True, kw_only=True)
class BatterySpec(Written):
    """The true battery, as a meter at its terminals would show it."""

    voltage: Amount | Points = described(
        "Voltage over time: points [time, voltage] with straight lines between them, the last voltage stays; or one "
        "voltage that stays from the start."
    )
    noise: Amount | None = described(
        "Largest deviation of a single reading, such as 10 mV; the same with each run.", default=None
    )
    divider: Fraction | None = described(
        "True ratio of the pack's voltage to that at the ADC pin. Default: that of the multiplier parameter.",
        default=None,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenarioSpec(Written):
    """One scenario."""

    doc: str = described("What the scenario shows, for people.")
    duration: Amount = described("How long it runs, such as 120 s.")
    seed: int = described("Start of the noise.", default=1)
    battery: BatterySpec = described("The true battery.")
    events: tuple[EventSpec, ...] = described("What happens, in the order of time.", default=())


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenariosSpec(Written):
    """``scenarios.yaml``: what ``codegen sim`` runs the firmware against."""

    scenarios: Mapping[str, ScenarioSpec] = described("The scenarios by name.")
