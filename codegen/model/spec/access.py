"""The access to commands, as vehicle.yaml states it: who may command the vehicle over which link."""

from collections.abc import Mapping
from enum import StrEnum

from codegen.frozen import dataclass
from codegen.model.spec.described import described
from codegen.source import Written

SETUP_SIGNING = "SETUP_SIGNING"
"""The message that brings a new key."""


class Admission(StrEnum):
    """Whose frames count on a link."""

    OPEN = "open"
    SIGNED = "signed"
    LISTED = "listed"


@dataclass(frozen=True, slots=True, kw_only=True)
class AccessSpec(Written):
    """The access to commands: who may command the vehicle over which link. Without it every link is open."""

    links: Mapping[str, Admission] = described(
        "Each link of the board: open to everybody, signed (only frames with the right key count, and all that goes "
        "out is signed), or listed (only frames that say they come from `stations` count: that keeps mistakes away, "
        "not attackers)."
    )
    stations: tuple[int, ...] = described("System ids whose frames count on links that are listed.", default=())
    key: str = described(
        "File on the board with the key, 64 hexadecimal digits; no folder, no module, and no other file's name.",
        default="signing.key",
    )
    setup: tuple[str, ...] = described(
        "Open links over a cable on which SETUP_SIGNING brings a new key. Without it a key comes with the file only.",
        default=(),
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: signed, replay, keyless, setup, listed.", default_factory=dict
    )

    ASPECTS = ("signed", "replay", "keyless", "setup", "listed")
