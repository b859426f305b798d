"""Records of a program at a time: happenings, readings that were reported, its state, its traffic."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.precision import Precision

SEVERITIES = ("emergency", "alert", "critical", "error", "warning", "notice", "info", "debug")
"""Names of MAV_SEVERITY, by number."""
STATES = ("uninit", "boot", "calibrating", "standby", "active", "critical", "emergency", "poweroff", "terminating")
"""Names of MAV_STATE, by number."""


class Kind(StrEnum):
    """The kind of a happening."""

    TEXT = "text"
    FAILSAFE = "failsafe"
    ACTION = "action"
    MODE = "mode"
    ARMED = "armed"
    DISARMED = "disarmed"
    REFUSED = "refused"
    FAULT = "fault"
    FAILED = "failed"
    SENT = "sent"
    SWAP = "swap"
    REBOOT = "reboot"
    STOPPED = "stopped"
    CONSOLE = "console"


@dataclass(frozen=True, slots=True)
class Happening:
    """Something that happened at a time of the scenario in ms; ``severity`` is a number of MAV_SEVERITY, or None.

    ``program`` is the name of the program, where several run; ``of`` the label of the quantity that it is about, if it
    is about one alone. Of a failsafe ``word`` says which level it has reached.
    """

    at_ms: int
    kind: Kind
    text: str
    severity: int | None = None
    program: str = ""
    of: str = ""
    word: str = ""


@dataclass(frozen=True, slots=True)
class Reading:
    """The reported value of a quantity at a time in ms, in its unit: None for unknown, and where the line breaks.

    ``exact`` is the same before it became a float, and ``precision`` that of the field and of what is kept.
    """

    at_ms: int
    value: float | None
    exact: Fraction | None = None
    precision: Precision = Precision()


@dataclass(frozen=True, slots=True)
class Sample:
    """The latest counters since the board's start; whether it is armed, and its MAV_STATE."""

    at_ms: int = 0
    is_armed: bool = False
    state: int | None = None
    frames: int = 0
    size: int = 0
    overruns: int = 0

    @property
    def state_name(self) -> str:
        """MAV_STATE in words; "starting" before it is known."""
        if self.state is None:
            return "starting"
        return STATES[self.state] if self.state < len(STATES) else str(self.state)


@dataclass(frozen=True, slots=True)
class Burst:
    """The frames and bytes that went out within ``length_ms``."""

    frames: int = 0
    size: int = 0
    length_ms: int = 1000


@dataclass(frozen=True, slots=True)
class Traffic:
    """Frames and bytes that went out by the name of the message, and what the links count."""

    frames: Mapping[str, int] = field(default_factory=dict)
    sizes: Mapping[str, int] = field(default_factory=dict)
    dropped: int = 0
    received: int = 0
    crc_errors: int = 0
    gaps: int = 0

    def plus(self, other: "Traffic") -> "Traffic":
        """Return the sum of both."""
        return Traffic(
            frames=Counter(self.frames) + Counter(other.frames),
            sizes=Counter(self.sizes) + Counter(other.sizes),
            dropped=self.dropped + other.dropped,
            received=self.received + other.received,
            crc_errors=self.crc_errors + other.crc_errors,
            gaps=self.gaps + other.gaps,
        )


def state_words(sample: Sample) -> str:
    """``disarmed, standby``."""
    return f"{'armed' if sample.is_armed else 'disarmed'}, {sample.state_name}"
