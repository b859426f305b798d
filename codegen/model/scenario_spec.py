"""Scenarios of the simulation as ``scenarios.yaml`` states them."""

from collections.abc import Mapping
from fractions import Fraction
from typing import ClassVar

from codegen.frozen import dataclass
from codegen.model.described import Amount, described
from codegen.model.scenario import AdcFault
from codegen.source import Written

Points = tuple[tuple[Amount, ...], ...]
"""Pairs of a time and a voltage, or a current."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BatterySpec(Written):
    """The true battery, as a meter at its terminals would show it."""

    voltage: Amount | Points = described(
        "Voltage over time: points [time, voltage] with straight lines between them, the last voltage stays; or one "
        "voltage that stays from the start. 0 V: no battery is connected."
    )
    current: Amount | Points | None = described(
        "Current drawn from it over time, negative while it is charged: points [time, current], or one current.",
        default=None,
    )
    noise: Amount | None = described(
        "Largest deviation of a single reading, such as 10 mV; the same with each run.", default=None
    )
    divider: Fraction | None = described(
        "True ratio of the pack's voltage to that at the ADC pin. Default: that of the multiplier parameter.",
        default=None,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class EventSpec(Written):
    """Something that happens at a time: exactly one of arm, adc, reboot and swap."""

    at_: Amount = described("Time since the start, such as 5 s.", key="at")
    arm: bool | None = described("true arms the vehicle, false disarms it.", default=None)
    adc: AdcFault | None = described(
        "Fault of the ADC: fail (readings fail), absent (not there when the board starts; only at 0 s), slow (readings "
        "take the time that delay gives).",
        default=None,
    )
    reboot: bool | None = described("true restarts the vehicle.", default=None)
    swap: str | None = described(
        "Name of a program under with: its battery is taken out, and a new one with a board of its own is in after the "
        "time that for gives.",
        default=None,
    )
    for_: Amount | None = described(
        "How long the fault lasts, to the end without it; or how long the battery is out.", key="for", default=None
    )
    delay: Amount | None = described("How long one reading takes while it is slow, such as 3 ms.", default=None)
    instance: int | None = described("Number of the battery whose ADC has the fault; 1 without it.", default=None)
    battery: BatterySpec | None = described(
        "Battery of the new board after a swap, its times since the start of the scenario. Without it the course of "
        "the old one goes on.",
        default=None,
    )
    batteries: tuple[BatterySpec, ...] = described("The same, where that program measures several.", default=())

    ONE_OF: ClassVar[tuple[str, ...]] = ("arm", "adc", "reboot", "swap")


@dataclass(frozen=True, slots=True, kw_only=True)
class BesideSpec(Written):
    """What another program of the project finds that runs beside the vehicle's own: its battery, if it measures any."""

    battery: BatterySpec | None = described("Its battery.", default=None)
    batteries: tuple[BatterySpec, ...] = described("Its batteries by instance, where it measures several.", default=())
    parameters: Mapping[str, Fraction] = described(
        "Parameters that were stored on its board before it starts.", default_factory=dict
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenarioSpec(Written):
    """One scenario. A vehicle that measures a battery finds one, or several: battery or batteries."""

    doc: str = described("What the scenario shows, for people.")
    duration: Amount = described("How long it runs, such as 120 s.")
    seed: int = described("Start of the noise.", default=1)
    battery: BatterySpec | None = described("The true battery, the first if there are several.", default=None)
    batteries: tuple[BatterySpec, ...] = described("The true batteries by instance.", default=())
    parameters: Mapping[str, Fraction] = described(
        "Parameters that were stored on the board before it starts.", default_factory=dict
    )
    with_: Mapping[str, BesideSpec] = described(
        "Other programs of the project, by name, that run at the same time.", key="with", default_factory=dict
    )
    events: tuple[EventSpec, ...] = described("What happens, in the order of time.", default=())


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenariosSpec(Written):
    """``scenarios.yaml``: what ``codegen sim`` runs the firmware against."""

    scenarios: Mapping[str, ScenarioSpec] = described("The scenarios by name.")
