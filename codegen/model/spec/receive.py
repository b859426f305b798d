"""``receives/*.yaml``: what a table of a received message states, every record with its places."""

from collections.abc import Mapping
from enum import StrEnum
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.spec.described import described
from codegen.model.spec.population import Rounding
from codegen.source import Written


class Sender(StrEnum):
    """Whose messages are taken."""

    ANY = "any"
    GROUND_STATION = "ground_station"
    OWN_SYSTEM = "own_system"


class Otherwise(StrEnum):
    """The outcome for the quantity of a field that other fields say is no value."""

    UNKNOWN = "unknown"
    UNCHANGED = "unchanged"


Said = str | Fraction | tuple[str | Fraction, ...]
"""The demand on another field: a number, an entry of its enum or ``bit 2``, or a list of these."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ReceivedFieldSpec(Written):
    """The quantity that one field, or one element of it, sets."""

    state: str = described("The quantity of the vehicle state that it sets: component.quantity.")
    min: str | Fraction | None = described(
        "Smallest plausible value, in the quantity's unit or as an amount: one below it is counted, and leaves the "
        "quantity as it was.",
        default=None,
    )
    max: str | Fraction | None = described("Largest plausible value, likewise.", default=None)
    unchanged: tuple[str | Fraction, ...] | None = described(
        "Numbers of the field that leave the quantity as it was, as a dialect says that they are to be ignored: "
        "nothing is set, and a value that grows stale goes on doing so. Numbers on the wire, limits of types such as "
        "UINT16_MAX or UINT16_MAX-1, entries of the field's enum, NaN. Default: those of the dialect's corrections.",
        default=None,
    )
    unknown: tuple[str | Fraction, ...] | None = described(
        "Numbers of the field that say that there is no value, beside the dialect's sentinel, likewise.", default=None
    )
    when: Mapping[str, Said] | None = described(
        "Other fields of the message, and what they have to say for this one to be a value: flags that are all set "
        "(entries of a bitmask, or bit 2), or numbers or entries of which each has one. {} says that it is a value "
        "whatever others say.",
        default=None,
    )
    unless: Mapping[str, Said] | None = described(
        "Other fields, and what they may not say: flags of which none may be set, or numbers or entries that it may "
        "not have.",
        default=None,
    )
    otherwise: Otherwise = described(
        "What becomes of the quantity where when or unless do not hold: unknown, or unchanged, as if nothing came.",
        default=Otherwise.UNKNOWN,
    )
    rounding: Rounding = described("How a value between two stored steps is rounded.", default=Rounding.NEAREST)
    requirement: str | None = described("Criterion that asks for this field, such as FR-1.4.", default=None)
    note: str | None = described("Why the field is taken so, for reviewers.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class ReceiveSpec(Written):
    """``receives/*.yaml``: what a message that arrives sets. Keys of ``fields``: name or name[2]."""

    receive: str = described("Name of the message in the dialect.")
    named: str | None = described(
        "A name for the table, in lower case, where there are several of one message.", "as", default=None
    )
    overlay: str | None = described(
        "Overlay for which the table is written, as codegen.yaml names it; without that overlay it is not used.",
        default=None,
    )
    requirement: str = described("Requirement, or criterion of one, that asks for it.")
    sender: Sender = described(
        "Who may send it: any; ground_station, a system of which a ground station's HEARTBEAT is heard on that link; "
        "own_system, another component of this vehicle.",
        "from",
        default=Sender.ANY,
    )
    where: Mapping[str, str | Fraction] = described(
        "Numbers, or entries of their enums, that fields of whole numbers have to have: a message with others is not "
        "taken.",
        default_factory=dict,
    )
    call: bool = described(
        "Call received_<table>() of the user's vehicle each time that the message was taken.", default=False
    )
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: range, sentinel, stale_after, target, sender.", default_factory=dict
    )
    fields: Mapping[str, ReceivedFieldSpec] = described(
        "The fields that set something; the others are ignored on purpose."
    )

    ASPECTS = ("range", "sentinel", "stale_after", "target", "sender")

    @property
    def name(self) -> str:
        """Return what the table is called: as it says, or else like its message."""
        return self.named or self.receive
