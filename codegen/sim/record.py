"""The record of a simulation: what the firmware sent, said and did."""

import re
from collections import Counter, deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from codegen.model.scenario import AdcFault, Fault, Scenario

SEVERITIES = ("emergency", "alert", "critical", "error", "warning", "notice", "info", "debug")
"""Names of MAV_SEVERITY, by number."""
STATES = ("uninit", "boot", "calibrating", "standby", "active", "critical", "emergency", "poweroff", "terminating")
"""Names of MAV_STATE, by number."""
_MOST_POINTS = 20_000
_MOST_LINES = 500
_MOST_TEXTS = 5_000


FAILSAFE_TEXT = re.compile(r"[A-Z][\w ]* 1 is (low|critical) -?\d+\.\d")
"""How a text of a failsafe begins; its group is the level."""


class Kind(StrEnum):
    """What a happening is."""

    TEXT = "text"
    FAILSAFE = "failsafe"
    ARMED = "armed"
    DISARMED = "disarmed"
    REFUSED = "refused"
    FAULT = "fault"
    REBOOT = "reboot"
    STOPPED = "stopped"
    CONSOLE = "console"


@dataclass(frozen=True, slots=True)
class Happening:
    """Something that happened at a time of the scenario in ms; ``severity`` is a number of MAV_SEVERITY, or None."""

    at_ms: int
    kind: Kind
    text: str
    severity: int | None = None


@dataclass(frozen=True, slots=True)
class Reading:
    """The voltage in mV that a BATTERY_STATUS reported at a time in ms; None for unknown, and where the line breaks."""

    at_ms: int
    millivolts: int | None


@dataclass(frozen=True, slots=True)
class Sample:
    """The latest state: voltages in mV, None for unknown; counters since the board's start; load in d%."""

    at_ms: int = 0
    true_mv: int | None = None
    reported_mv: int | None = None
    is_armed: bool = False
    state: int | None = None
    frames: int = 0
    size: int = 0
    overruns: int = 0
    load: int = 0

    @property
    def state_name(self) -> str:
        """MAV_STATE in words; "silent" before the first HEARTBEAT."""
        if self.state is None:
            return "silent"
        return STATES[self.state] if self.state < len(STATES) else str(self.state)


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
        """Both together."""
        return Traffic(
            frames=Counter(self.frames) + Counter(other.frames),
            sizes=Counter(self.sizes) + Counter(other.sizes),
            dropped=self.dropped + other.dropped,
            received=self.received + other.received,
            crc_errors=self.crc_errors + other.crc_errors,
            gaps=self.gaps + other.gaps,
        )


class Recording:
    """Collects the records of one simulation, over all restarts of the board."""

    def __init__(self, scenario: Scenario) -> None:
        """Begin with the faults that the scenario has."""
        self.scenario = scenario
        self.runtime = ""
        self.readings: list[Reading] = []
        self.parameters: Mapping[str, float] = {}
        self.sample = Sample()
        self.at_ms = 0
        self.starts = 0
        self.reason = ""
        self.traceback: list[str] = []
        self.problem: str | None = None
        self.was_interrupted = False
        self.texts_left_out = 0
        self._happenings: list[Happening] = []
        self._console: deque[Happening] = deque(maxlen=_MOST_LINES)
        self._texts = 0
        self._spacing_ms = 0
        self._ended = Traffic()
        self._current = Traffic()
        self._ended_overruns = 0
        self._peak_load = 0

    @property
    def happenings(self) -> list[Happening]:
        """What happened, in the order of time, faults of the scenario included; of the console the last lines."""
        faults = [
            Happening(event.at_ms, Kind.FAULT, fault_text(event))
            for event in self.scenario.events
            if isinstance(event, Fault) and event.at_ms <= self.at_ms
        ]
        return sorted([*faults, *self._happenings, *self._console], key=lambda happening: happening.at_ms)

    @property
    def traffic(self) -> Traffic:
        """What went out, over all restarts."""
        return self._ended.plus(self._current)

    @property
    def overruns(self) -> int:
        """Control slots that were missed, over all restarts."""
        return self._ended_overruns + self.sample.overruns

    @property
    def peak_load(self) -> int:
        """The largest load in d%."""
        return self._peak_load

    def add(self, kind: Kind, text: str, severity: int | None = None, at_ms: int | None = None) -> Happening:
        """Note that something happened (now, if no time is given), and return it."""
        happening = Happening(self.at_ms if at_ms is None else at_ms, kind, text, severity)
        if kind is Kind.CONSOLE:
            self._console.append(happening)
        elif kind is Kind.TEXT and self._texts == _MOST_TEXTS:
            self.texts_left_out += 1
        else:
            self._texts += kind is Kind.TEXT
            self._happenings.append(happening)
        return happening

    def take(self, record: Mapping[str, Any]) -> Happening | None:
        """Take in one record of the running firmware; what it says has happened, if anything."""
        self.at_ms = max(self.at_ms, record["at"])
        match record["kind"]:
            case "start":
                self._start(record["runtime"])
            case "sample":
                self._take_sample(record)
            case "battery":
                self._take_reading(Reading(record["at"], record["millivolts"]))
            case "text":
                kind = Kind.FAILSAFE if _is_failsafe(record["text"]) else Kind.TEXT
                return self.add(kind, record["text"], record["severity"])
            case "event":
                return self.add(Kind(record["name"]), record["text"])
            case "messages":
                self._take_messages(record)
            case "failed":
                self.traceback = record["traceback"].splitlines()
            case "end":
                self.reason = record["reason"]
        return None

    def largest_difference(self) -> tuple[int, int] | None:
        """The largest difference of a reported voltage from the true one in mV, and its time in ms."""
        found = [
            (abs(round(reading.millivolts - self.scenario.millivolts(reading.at_ms))), reading.at_ms)
            for reading in self.readings
            if reading.millivolts is not None
        ]
        return max(found, key=lambda pair: (pair[0], -pair[1])) if found else None

    def _start(self, runtime: str) -> None:
        self.runtime = runtime
        self.starts += 1
        self._ended = self.traffic
        self._current = Traffic()
        self._ended_overruns = self.overruns
        self.sample = Sample(at_ms=self.at_ms)
        if self.starts > 1:
            self.readings.append(Reading(self.at_ms, None))

    def _take_sample(self, record: Mapping[str, Any]) -> None:
        self.sample = Sample(
            at_ms=record["at"],
            true_mv=record["true"],
            reported_mv=record["reported"],
            is_armed=record["armed"],
            state=record["state"],
            frames=record["frames"],
            size=record["bytes"],
            overruns=record["overruns"],
            load=record["load"],
        )
        self._peak_load = max(self._peak_load, self.sample.load)

    def _take_reading(self, reading: Reading) -> None:
        last = self.readings[-1] if self.readings else None
        is_known = reading.millivolts is not None
        if last and is_known == (last.millivolts is not None) and reading.at_ms - last.at_ms < self._spacing_ms:
            return
        self.readings.append(reading)
        if len(self.readings) > _MOST_POINTS:  # a run without end: keep every second one
            self.readings = self.readings[::2]
            self._spacing_ms = max(1, 2 * self._spacing_ms, 2 * self.at_ms // _MOST_POINTS)

    def _take_messages(self, record: Mapping[str, Any]) -> None:
        counts = record["counts"]
        self._current = Traffic(
            frames={name: count for name, (count, _) in counts.items()},
            sizes={name: size for name, (_, size) in counts.items()},
            dropped=record["dropped"],
            received=record["received"],
            crc_errors=record["crc_errors"],
            gaps=record["gaps"],
        )
        self.parameters = record["parameters"] or self.parameters


def fault_text(fault: Fault) -> str:
    """A fault of the scenario in words."""
    what = {
        AdcFault.FAIL: "ADC readings fail",
        AdcFault.ABSENT: "ADC absent",
        AdcFault.SLOW: f"ADC readings take {fault.delay_us / 1000:g} ms",
    }[fault.adc]
    return what + (" to the end" if fault.until_ms is None else f" for {(fault.until_ms - fault.at_ms) / 1000:g} s")


def _is_failsafe(text: str) -> bool:
    """Whether a text says that the failsafe fired, as ``Battery 1 is low 10.45V used 0 mAh``."""
    return FAILSAFE_TEXT.match(text) is not None
