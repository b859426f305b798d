"""``commands.yaml``: what the vehicle does at a command, beside what every program answers."""

from collections.abc import Mapping
from enum import StrEnum
from fractions import Fraction
from typing import ClassVar

from codegen.frozen import dataclass
from codegen.model.spec.described import Nothing, described
from codegen.source import Written


class Allowed(StrEnum):
    """The state of the vehicle in which a command is allowed."""

    ALWAYS = "always"
    DISARMED = "disarmed"
    ARMED = "armed"


class Sender(StrEnum):
    """The senders from which a command is accepted."""

    ANY = "any"
    GROUND_STATION = "ground_station"


@dataclass(frozen=True, slots=True, kw_only=True)
class CommandParamSpec(Written):
    """One of the seven parameters of a command. Parameters that no entry names are ignored, whatever they are."""

    name: str = described("Name of the argument that the method is given.")
    doc: str | None = described("What it is for, for people.", default=None)
    unit: str | None = described(
        "Unit of the argument, converted from the dialect's; without it the dialect's own.", default=None
    )
    min: Fraction | None = described("Smallest value that is accepted, in unit.", default=None)
    max: Fraction | None = described("Largest value that is accepted, in unit.", default=None)
    whole: bool | None = described(
        "True: only whole numbers are accepted. Default: where the dialect's increment is whole and unit converts "
        "nothing, and for enums.",
        default=None,
    )
    enum: str | None = described(
        "Enum of the dialect, of which the value has to be an entry, or flags; default: the one that the dialect says.",
        default=None,
    )
    scaled: Fraction | None = described(
        "By what COMMAND_INT multiplies parameter 5 or 6, which are whole numbers there: 1e7 for global positions, 1e4 "
        "for local ones in m, or what the dialect's words say; 1 where it has whole numbers of the value. Default: 1e7 "
        "of what the dialect calls a latitude or a longitude.",
        default=None,
    )
    default: Fraction | Nothing | None = described(
        "What the method is given for NaN, in unit, or null: the method is given None. Without it NaN is denied.",
        default=None,
    )
    unchanged: tuple[str | Fraction, ...] | None = described(
        "Numbers on the wire, in the dialect's unit, with which the dialect says that nothing is to change, such as "
        "-1: the method is given None, whatever min and max are. Numbers, limits of types, NaN. An empty list says "
        "that the numbers which the dialect describes so are values here.",
        default=None,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class CommandSpec(Written):
    """One command, by the name of its entry of MAV_CMD."""

    doc: str = described("What the command does, for people.")
    method: str = described(
        "Method of the vehicle that does it, which code overrides: None or True accepts, False or a text refuses."
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: params (ends, beyond them, NaN), refusal (False, a text, an exception), allowed, "
        "from, progress, cancel.",
        default_factory=dict,
    )
    allowed: Allowed = described("When it is done; at other times it is rejected for now.", default=Allowed.ALWAYS)
    sender: Sender = described(
        "Who may ask: any system, or only a ground station whose HEARTBEAT is heard on that link.",
        key="from",
        default=Sender.ANY,
    )
    frames: tuple[str, ...] = described(
        "Entries of MAV_FRAME in which COMMAND_INT may state it, each with or without _INT. Default: the global ones "
        "for a position, any for others. A command with an altitude (parameter 7) has to say which one: frames count "
        "altitudes from different levels, and COMMAND_LONG is taken to be in it.",
        default=(),
    )
    params: Mapping[str, CommandParamSpec] = described(
        "Its parameters by their numbers, 1 to 7, in the order of the method's arguments.", default_factory=dict
    )
    long: bool = described(
        "True: it takes long. The method begins it, METHOD_progress() tells how far it is, METHOD_cancel() ends it.",
        default=False,
    )

    ASPECTS: ClassVar[tuple[str, ...]] = ("params", "refusal", "allowed", "from", "progress", "cancel")


@dataclass(frozen=True, slots=True, kw_only=True)
class CommandsSpec(Written):
    """``commands.yaml``: the commands of this vehicle."""

    commands: Mapping[str, CommandSpec] = described("The commands by their entries of MAV_CMD.", default_factory=dict)
