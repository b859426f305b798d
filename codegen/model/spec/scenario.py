"""Scenarios of the simulation as ``scenarios.yaml`` states them."""

from collections.abc import Mapping
from fractions import Fraction
from typing import ClassVar

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, Verbatim, described
from codegen.source import Written

Points = tuple[tuple[Verbatim, ...], ...]
"""Pairs of a time and a value."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CourseSpec(Written):
    """The true values of a quantity over time, whatever the firmware makes of them: exactly one of value and points."""

    value: Verbatim | None = described(
        "The value that it has all the time, with its unit: 12 V; an entry of its enum, true or false, a text; or "
        "unknown.",
        default=None,
    )
    points: Points = described(
        "Points [time, value]: straight lines between two numbers, the last value stays. unknown: there is nothing to "
        "be measured or set from then on.",
        default=(),
    )
    noise: Amount | Fraction | None = described(
        "Largest deviation of a single value, such as 10 mV; the same with each run.", default=None
    )
    rate: Amount | None = described(
        "How often code of the vehicle sets it, where code does. Default: 10 Hz.", default=None
    )
    wired: Mapping[str, Fraction] = described(
        "What the wiring truly is, by the parameter that should say so: {BATT_VOLT_MULT: 4.01}. Default: what the "
        "parameters say.",
        default_factory=dict,
    )

    ONE_OF: ClassVar[tuple[str, ...]] = ("value", "points")


@dataclass(frozen=True, slots=True, kw_only=True)
class EventSpec(Written):
    """Something that happens at a time: exactly one of arm, fault, reboot, swap and send."""

    at_: Amount = described("Time since the start, such as 5 s.", key="at")
    arm: bool | None = described("true arms the vehicle, false disarms it.", default=None)
    fault: str | None = described(
        "Fault of what a quantity is measured with, or of the code that sets it: fail (no readings), absent (not there "
        "when the board starts; only at 0 s), slow (readings take the time that delay gives), stuck (the value that it "
        "had stays); what else a kind of sensor can have, such as garbled lines.",
        default=None,
    )
    of: str | None = described("The quantity, one of courses: battery.voltage, battery[1].voltage.", default=None)
    reboot: bool | None = described("true restarts the vehicle.", default=None)
    swap: str | None = described(
        "Name of a program under with: its board is taken out, and a new one is in after the time that for gives.",
        default=None,
    )
    send: str | None = described(
        "Name of a message of the dialect that a ground station sends, such as RC_CHANNELS_OVERRIDE.", default=None
    )
    fields: Mapping[str, Verbatim] = described(
        "What its fields carry: numbers, amounts, entries of enums, texts; field[1] is an element. Others are 0, and "
        "the target is the vehicle.",
        default_factory=dict,
    )
    every: Amount | None = described("How often it is sent again, such as 100 ms. Default: never.", default=None)
    for_: Amount | None = described(
        "How long the fault lasts, or the message is sent again, to the end without it; or how long the board is out.",
        key="for",
        default=None,
    )
    delay: Amount | None = described("How long one reading takes while it is slow, such as 3 ms.", default=None)
    courses: Mapping[str, CourseSpec] = described(
        "What is true of the quantities of the new board after a swap, its times since the start of the scenario. "
        "Without it the courses of the old one go on.",
        default_factory=dict,
    )

    ONE_OF: ClassVar[tuple[str, ...]] = ("arm", "fault", "reboot", "swap", "send")
    INSTEAD: ClassVar[str] = "a fault is written {at: 20 s, fault: fail, of: component.quantity, for: 15 s}"


@dataclass(frozen=True, slots=True, kw_only=True)
class BesideSpec(Written):
    """Another program of the project that runs beside the vehicle's own, and what is true of its quantities."""

    courses: Mapping[str, CourseSpec] = described(
        "What is true of its quantities, by component.quantity.", default_factory=dict
    )
    parameters: Mapping[str, Fraction] = described(
        "Parameters that were stored on its board before it starts.", default_factory=dict
    )

    INSTEAD: ClassVar[str] = (
        "what is true of a quantity is written courses: {component.quantity: {points: [[0 s, 12.3 V]], noise: 10 mV}}"
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ExpectSpec(Written):
    """An expectation: exactly one of state, told, text and no_text. If it fails, ``codegen sim`` exits with code 1."""

    at_: Amount | None = described("When, such as 40 s. Default: at the end.", key="at", default=None)
    state: str | None = described("A quantity as the firmware has it: battery.failsafe.", default=None)
    told: str | None = described("A quantity as a message told it last: gps.lat.", default=None)
    text: str | None = described("What some text of the firmware contains that was said by then.", default=None)
    no_text: str | None = described("What no text of the firmware contains that was said by then.", default=None)
    is_: Verbatim | None = described("What the quantity is; unknown, if it is not known.", key="is", default=None)
    between: tuple[Verbatim, ...] = described("The least and the largest that it may be, with its unit.", default=())

    ONE_OF: ClassVar[tuple[str, ...]] = ("state", "told", "text", "no_text")


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenarioSpec(Written):
    """One scenario."""

    doc: str = described("What the scenario shows, for people.")
    duration: Amount = described("How long it runs, such as 120 s.")
    seed: int = described("Start of the noise.", default=1)
    courses: Mapping[str, CourseSpec] = described(
        "What is true of quantities, by component.quantity, or component[1].quantity for the second instance. It "
        "reaches the firmware as on the board: through the ADC where one measures it, or set in the state.",
        default_factory=dict,
    )
    parameters: Mapping[str, Fraction] = described(
        "Parameters that were stored on the board before it starts.", default_factory=dict
    )
    code: bool = described(
        "false runs the generated vehicle without your code: where courses say what your code would set.", default=True
    )
    with_: Mapping[str, BesideSpec] = described(
        "Other programs of the project, by name, that run at the same time.", key="with", default_factory=dict
    )
    events: tuple[EventSpec, ...] = described("What happens, in the order of time.", default=())
    expect: tuple[ExpectSpec, ...] = described("What must hold.", default=())

    INSTEAD: ClassVar[str] = BesideSpec.INSTEAD


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenariosSpec(Written):
    """``scenarios.yaml``: what ``codegen sim`` runs the firmware against."""

    scenarios: Mapping[str, ScenarioSpec] = described("The scenarios by name.")
