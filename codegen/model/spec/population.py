"""``messages/*.yaml``: what a population table states, every record with its places."""

from collections.abc import Mapping
from enum import StrEnum
from fractions import Fraction
from typing import Any, ClassVar, Literal

from codegen.frozen import dataclass
from codegen.model.spec.described import described
from codegen.source import Written


class Rounding(StrEnum):
    """The rounding of a value between two wire steps; a half goes away from zero with ``nearest``."""

    NEAREST = "nearest"
    DOWN = "down"
    UP = "up"
    TOWARD_ZERO = "toward_zero"


class Others(StrEnum):
    """The answer for the fields that a table does not list."""

    UNKNOWN = "unknown"


class Send(StrEnum):
    """The condition under which a due message goes out."""

    ALWAYS = "always"
    WHILE_KNOWN = "while_known"


class Clock(StrEnum):
    """The start of a clock's count: the start of the firmware, or 1970."""

    BOOT = "boot"
    UNIX = "unix"


@dataclass(frozen=True, slots=True, kw_only=True)
class FieldAnswer(Written):
    """The source of the value of one field, or of some elements of it: exactly one of the first eleven keys.

    ``state`` beside ``each`` is what goes out while one of the values is unknown.
    The short form ``field: unknown`` stands for ``field: {unknown: true}``.
    """

    state: str | None = described("A quantity of the vehicle state: component.quantity.", default=None)
    each: str | None = described(
        "A quantity with elements, component.quantity: one value for each element of the field. Beside it, state with "
        "split is sent instead while one of the values is unknown.",
        default=None,
    )
    page: Literal[True] | None = described(
        "The number of the first value on the page, in a message that has pages.", default=None
    )
    parameter: str | None = described("A parameter.", default=None)
    clock: Clock | None = described(
        "The time in the field's unit, which wraps as the field does: since the start (boot), or since 1970 (unix), "
        "which is unknown until code sets it.",
        default=None,
    )
    board: str | None = described("A fact of the board: component.fact.", default=None)
    enum: str | None = described("An entry of the field's enum.", default=None)
    flags: tuple[str, ...] | None = described(
        "Entries of the field's bitmask; 'ENTRY if component.quantity' sets one only while the quantity is true.",
        default=None,
    )
    one_of: tuple[str, ...] | None = described(
        "Entries of the field's enum, each but the last as 'ENTRY if component.quantity': the first one whose quantity "
        "is true goes out, else the last.",
        default=None,
    )
    constant: str | Fraction | None = described(
        "A number, an amount with its unit, or text for a char field.", default=None
    )
    dialect: str | None = described("A fact of the dialect: version.", default=None)
    unknown: Literal[True] | None = described("The dialect's sentinel.", default=None)
    first: int = described("For each: the value that the first element takes, from 0.", "from", default=0)
    per: str | None = described(
        "For board: another fact, which counts something, such as cells: the one that is sent is that of one of them, "
        "and the number of each instance multiplies it.",
        default=None,
    )
    split: bool = described("Spill a value that one element cannot hold over the following ones.", default=False)
    min: str | Fraction | None = described("Smallest value sent, in the source's unit or as an amount.", default=None)
    max: str | Fraction | None = described("Largest value sent, in the source's unit or as an amount.", default=None)
    rounding: Rounding = described("How a value between two wire steps is rounded.", default=Rounding.NEAREST)
    requirement: str | None = described("Criterion that asks for this field, such as FR-00068.3.", default=None)
    note: str | None = described("Why the field is answered so, for reviewers.", default=None)

    SOURCES = (
        "state",
        "each",
        "page",
        "parameter",
        "clock",
        "board",
        "enum",
        "flags",
        "one_of",
        "constant",
        "dialect",
        "unknown",
    )
    ONE_OF: ClassVar[tuple[str, ...]] = SOURCES
    BESIDE: ClassVar[Mapping[str, str]] = {"each": "state"}
    SHORT_FORMS: ClassVar[Mapping[str, Mapping[str, Any]]] = {"unknown": {"unknown": True}}


@dataclass(frozen=True, slots=True, kw_only=True)
class RepresentationSpec(Written):
    """The choice of the instance that a single message reports: exactly one of the keys."""

    first: Literal[True] | None = described("The first one.", default=None)
    parameter: str | None = described(
        "The one whose number, from 1, this parameter has; the first enabled one where that one is not enabled.",
        default=None,
    )
    lowest: str | None = described(
        "Of those that are enabled the one whose quantity of this name is lowest; the first where none is known.",
        default=None,
    )

    ONE_OF: ClassVar[tuple[str, ...]] = ("first", "parameter", "lowest")


@dataclass(frozen=True, slots=True, kw_only=True)
class PopulationSpec(Written):
    """``messages/*.yaml``: how one message is populated. Keys of ``fields``: name, name[2] or name[1..9]."""

    message: str = described("Name of the message in the dialect.")
    named: str | None = described(
        "A name for the table, in lower case, where there are several of one message, or to call its builder "
        "build_<name>: it stands for the message wherever the project names one.",
        "as",
        default=None,
    )
    overlay: str | None = described(
        "Overlay for which the table is written, as codegen.yaml names it; without that overlay it is not used.",
        default=None,
    )
    requirement: str = described("Requirement, or criterion of one, that asks for the message.")
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: connection, change, besides, request.", default_factory=dict
    )
    for_each: str | None = described("Component of which each instance has a message of its own.", default=None)
    stream: str | None = described(
        "Stream that the message belongs to; without one it is sent when a ground station asks for it.", default=None
    )
    send: Send = described(
        "while_known: the message is withheld while a quantity is unknown whose field cannot say so.",
        default=Send.ALWAYS,
    )
    on_connection: bool = described(
        "Send it at once when a link starts, and when a component is heard for the first time or after a silence.",
        default=False,
    )
    on_change: str | None = described(
        "Quantity, component.quantity, whose change sends the message: that of the instance that changed. It is looked "
        "at every 100 ms: a change that is taken back until then is told by no message, and of several the last is.",
        default=None,
    )
    pages: str | None = described(
        "A quantity with elements, component.quantity: the message is sent once for as many of them as it holds.",
        default=None,
    )
    represents: Mapping[str, RepresentationSpec] = described(
        "For components of several instances, by name: which of them a single message reports.", default_factory=dict
    )
    others: Others | None = described(
        "unknown: every field and element that is not listed goes out as the dialect's sentinel.", default=None
    )
    fields: Mapping[str, FieldAnswer] = described("An answer for every field and element, or with others for some.")

    ASPECTS = ("connection", "change", "besides", "request")

    @property
    def name(self) -> str:
        """Return what the table is called: as it says, or else like its message."""
        return self.named or self.message
