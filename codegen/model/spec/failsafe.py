"""``failsafes`` in ``vehicle.yaml``: what is watched, from when on it is bad, and what is done then."""

from collections.abc import Mapping
from enum import StrEnum
from typing import ClassVar, Literal

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, Verbatim, described
from codegen.source import Written

GROUND_STATION = "ground_station"
"""The sender that can be silent, beside a quantity that is unknown."""


class Watching(StrEnum):
    """The states of the vehicle in which a failsafe watches."""

    ARMED = "armed"
    ALWAYS = "always"


_BELOW = "Holds below this: a parameter, of which 0 switches it off, or an amount, such as 1.5 m."
_ABOVE = "Holds above this: a parameter, of which 0 switches it off, or an amount, such as 60 degC."
_UNKNOWN = "true: holds while the quantity is unknown, so for one with stale_after once nothing has set it for so long."
_AFTER = "Time that it has to hold without a break: a parameter, of which 0 switches it off, or an amount, such as 2 s."


@dataclass(frozen=True, slots=True, kw_only=True)
class ConditionSpec(Written):
    """A condition on a quantity."""

    ONE_OF: ClassVar[tuple[str, ...]] = ("below", "above", "unknown")

    watches: str | None = described("The quantity, as component.quantity; default: that of the failsafe.", default=None)
    below: Verbatim | None = described(_BELOW, default=None)
    above: Verbatim | None = described(_ABOVE, default=None)
    unknown: Literal[True] | None = described(_UNKNOWN, default=None)
    hysteresis: Verbatim | None = described("Amount by which it has to be better before it is over.", default=None)
    after: Verbatim | None = described(_AFTER + " Default: at once.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class FailsafeLevelSpec(Written):
    """A level of a failsafe; its name is what texts call it."""

    below: Verbatim | None = described(_BELOW, default=None)
    above: Verbatim | None = described(_ABOVE, default=None)
    unknown: Literal[True] | None = described(_UNKNOWN, default=None)
    either: tuple[ConditionSpec, ...] = described(
        "Further conditions that lead to the same level, each by itself, such as one on another quantity.",
        key="or",
        default=(),
    )
    after: Verbatim | None = described(_AFTER + " Default: that of the failsafe.", default=None)
    hysteresis: Verbatim | None = described(
        "Amount by which the quantity has to be better before the level is over. Default: that of the failsafe.",
        default=None,
    )
    action: str | None = described(
        "Parameter with the action, a value of one of the actions, or the call of one of them. Without it only a text "
        "is sent.",
        default=None,
    )
    text: str | None = described("Text when it is reached; default: that of the failsafe.", default=None)
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class FailsafeSpec(Written):
    """A failsafe: an action when a quantity is beyond a threshold or unknown for a while, or nobody is heard."""

    ONE_OF: ClassVar[tuple[str, ...]] = ("watches", "silence")
    INSTEAD: ClassVar[str] = (
        "a failsafe says watches: COMPONENT.QUANTITY and levels: {low: {below: ..., action: ...}, ...}; what was "
        "minimum_to_arm is to_arm: [{below: ...}], and what was used stands in text: (docs/failsafes.md)"
    )

    watches: str | None = described("The quantity that is compared, as component.quantity.", default=None)
    silence: str | None = described(
        "ground_station: how long no HEARTBEAT of a ground station arrived on any link, once one did. A message or a "
        "sensor that stops is watched by unknown: true, on a quantity with stale_after.",
        default=None,
    )
    title: str | None = described(
        "What texts call it; {number} is the number of the instance, from 1. Default: the name of the failsafe, with "
        "the number where the component has several instances.",
        default=None,
    )
    levels: Mapping[str, FailsafeLevelSpec] = described("Levels by name, the mildest first.")
    after: Verbatim | None = described(_AFTER + " Default: at once.", default=None)
    hysteresis: Verbatim | None = described(
        "Amount by which the quantity has to be better before a level is over; with latch: false.", default=None
    )
    believed_above: Verbatim | None = described(
        "Amount; a value that is not above it counts as unknown for the levels: it neither restarts a time nor lets it "
        "go on.",
        default=None,
    )
    when: Watching = described(
        "armed: it rests while the vehicle is disarmed. always: it never does, which what cannot be armed asks for.",
        default=Watching.ARMED,
    )
    latch: bool = described(
        "true: a level stays until the next start, and only rises. false: it is over once nothing of it holds any "
        "longer.",
        default=True,
    )
    text: str | None = described(
        "Text when a level is reached, of {name}, {level}, {value} and {QUANTITY} of the component, as {value:.1} with "
        "so many decimals, or {QUANTITY or 0} with what stands for unknown. What is in brackets is left out while a "
        "quantity in it is unknown, as in [ used {QUANTITY} mAh]. Default: {name} is {level}, and the value.",
        default=None,
    )
    over: str | None = described(
        "Text when it is over, with latch: false. Default: {name} is good again.", default=None
    )
    arming: bool = described(
        "True: arming is refused while the quantity is unknown or beyond a threshold, or a level is reached.",
        default=True,
    )
    to_arm: tuple[ConditionSpec, ...] = described(
        "Further conditions while which the vehicle is not armed.", default=()
    )
    enabled_by: str | None = described("Parameter that switches the whole failsafe off with 0.", default=None)
    health: str | None = described(
        "Quantity of the component that is 0 while nothing holds, or the number of the level whose condition holds, "
        "whatever its time; the last one also while the watched quantity is unknown.",
        default=None,
    )
    level: str | None = described(
        "Quantity of the component that holds the number of the level that was reached, from 1, or 0; with silence "
        "as component.quantity.",
        default=None,
    )
    health_every: Amount | None = described(
        "Shortest time between two texts about the health, such as 10 s; without it each change is told.", default=None
    )
    requirement: str = described("Requirement, or criterion of one, that asks for it.")
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: timer, off, disarmed, latch, recovery, unknown, text, action, status, health, "
        "health_text.",
        default_factory=dict,
    )

    ASPECTS = (
        *("timer", "off", "disarmed", "latch", "recovery", "unknown", "text", "action", "status", "health"),
        "health_text",
    )
