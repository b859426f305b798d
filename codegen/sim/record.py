"""The record of a simulation: what the firmware sent, said and did."""

import re
from collections import deque
from collections.abc import Mapping, Sequence
from typing import Any

from codegen.model.scenario import AdcFault, Battery, Fault, Scenario
from codegen.model.wiring import FIRST_PREFIX
from codegen.sim.sample import Happening, Kind, Reading, Sample, Traffic

_MOST_POINTS = 20_000
_MOST_LINES = 500
_MOST_TEXTS = 5_000


FAILSAFE_TEXT = re.compile(r"([A-Z][\w ]* (\d+)) is (low|critical) -?\d+\.\d")
"""How a text of a failsafe begins: its groups are what has failed, the number of the battery, and the level."""


class Recording:
    """Collects the records of one program of a simulation, over all its boards and their restarts.

    ``name`` is that of the program where several run, else nothing; ``key`` its name in the scenario, None for the
    vehicle's own, ``beside`` the recordings of the other programs, ``prefixes`` begin the names of the parameters of
    each battery.
    """

    def __init__(
        self,
        scenario: Scenario,
        name: str = "",
        key: str | None = None,
        prefixes: Sequence[str] = (FIRST_PREFIX,),
        beside: Sequence["Recording"] = (),
    ) -> None:
        """Begin with the faults that the scenario has."""
        self.scenario = scenario
        self.name = name
        self.prefixes = tuple(prefixes)
        self.beside = tuple(beside)
        self.key = key
        self.stretches = scenario.stretches(key)
        self.runtime = ""
        self.readings_of: dict[int, list[Reading]] = {0: []}
        self.parameters: Mapping[str, float] = {}
        self.sample = Sample()
        self.at_ms = 0
        self.starts = 0
        self.boards = 1
        self.is_out = False
        self.reason = ""
        self.traceback: list[str] = []
        self.problem: str | None = None
        self.was_interrupted = False
        self.texts_left_out = 0
        self._happenings: list[Happening] = []
        self._console: deque[Happening] = deque(maxlen=_MOST_LINES)
        self._texts = 0
        self._spacing_ms: dict[int, int] = {}
        self._ended = Traffic()
        self._current = Traffic()
        self._ended_overruns = 0
        self._peak_load = 0

    @property
    def all(self) -> tuple["Recording", ...]:
        """This one and those beside it."""
        return (self, *self.beside)

    @property
    def is_main(self) -> bool:
        """Whether it is that of the vehicle's own program."""
        return self.key is None

    @property
    def readings(self) -> list[Reading]:
        """What was reported of the first battery."""
        return self.readings_of[0]

    @property
    def happenings(self) -> list[Happening]:
        """What happened, in the order of time, faults of the scenario included; of the console the last lines.

        It is what happened in all programs, where there are others beside this one.
        """
        faults = [
            Happening(event.at_ms, Kind.FAULT, fault_text(event, len(self.scenario.batteries)), program=self.name)
            for event in self.scenario.events
            if self.is_main and isinstance(event, Fault) and event.at_ms <= self.at_ms
        ]
        found = [*faults, *self._happenings, *self._console]
        for other in self.beside:
            found += other.happenings
        return sorted(found, key=lambda happening: happening.at_ms)

    @property
    def traffic(self) -> Traffic:
        """What went out, over all restarts."""
        return self._ended.plus(self._current)

    @property
    def overruns(self) -> int:
        """Control slots that were missed, over all restarts."""
        return self._ended_overruns + self.sample.overruns

    @property
    def restarts(self) -> int:
        """How often a board was restarted; one that takes the place of another was not."""
        return max(0, self.starts - self.boards)

    @property
    def peak_load(self) -> int:
        """The largest load in d%."""
        return self._peak_load

    def battery(self, instance: int, at_ms: float) -> Battery | None:
        """The true battery of an instance at a time in ms; None while its board is out, or where there is none."""
        for stretch in self.stretches:
            if stretch.start_ms <= at_ms and (stretch.end_ms is None or at_ms <= stretch.end_ms):
                return stretch.batteries[instance] if instance < len(stretch.batteries) else None
        return None

    @property
    def instances(self) -> range:
        """The batteries that the scenario states or that were reported, from 0."""
        stated = max(len(stretch.batteries) for stretch in self.stretches)
        reported = max((instance + 1 for instance, readings in self.readings_of.items() if readings), default=0)
        return range(max(stated, reported))

    def add(self, kind: Kind, text: str, severity: int | None = None, at_ms: int | None = None) -> Happening:
        """Note that something happened (now, if no time is given), and return it."""
        happening = Happening(self.at_ms if at_ms is None else at_ms, kind, text, severity, self.name)
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
                reading = Reading(record["at"], record["millivolts"], record.get("milliamperes"))
                self._take_reading(record.get("instance", 0), reading)
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

    def take_board_out(self, at_ms: int) -> Happening:
        """Note that the board was taken out, with its battery."""
        self.is_out = True
        self._break_lines(at_ms)
        return self.add(Kind.SWAP, "The battery was taken out", at_ms=at_ms)

    def take_new_board(self, at_ms: int) -> Happening:
        """Note that another board is in its place."""
        self.is_out = False
        self.boards += 1
        self.at_ms = max(self.at_ms, at_ms)
        return self.add(Kind.SWAP, "Another battery was put in", at_ms=at_ms)

    def largest_difference(self, instance: int = 0) -> tuple[int, int] | None:
        """The largest difference of a reported voltage from the true one in mV, and its time in ms."""
        found = [
            (abs(round(reading.millivolts - battery.millivolts(reading.at_ms))), reading.at_ms)
            for reading in self.readings_of.get(instance, ())
            if reading.millivolts is not None
            if (battery := self.battery(instance, reading.at_ms)) is not None
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
            self._break_lines(self.at_ms)

    def _break_lines(self, at_ms: int) -> None:
        for readings in self.readings_of.values():
            readings.append(Reading(at_ms, None))

    def _take_sample(self, record: Mapping[str, Any]) -> None:
        self.sample = Sample(
            at_ms=record["at"],
            true_mv=tuple(record["true"]),
            reported_mv=tuple(record["reported"]),
            is_armed=record["armed"],
            state=record["state"],
            frames=record["frames"],
            size=record["bytes"],
            overruns=record["overruns"],
            load=record["load"],
        )
        self._peak_load = max(self._peak_load, self.sample.load)

    def _take_reading(self, instance: int, reading: Reading) -> None:
        readings = self.readings_of.setdefault(instance, [])
        spacing_ms = self._spacing_ms.get(instance, 0)
        last = readings[-1] if readings else None
        is_known = reading.millivolts is not None
        if last and is_known == (last.millivolts is not None) and reading.at_ms - last.at_ms < spacing_ms:
            return
        readings.append(reading)
        if len(readings) > _MOST_POINTS:  # a run without end: keep every second one
            self.readings_of[instance] = readings[::2]
            self._spacing_ms[instance] = max(1, 2 * spacing_ms, 2 * self.at_ms // _MOST_POINTS)

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


def fault_text(fault: Fault, batteries: int = 1) -> str:
    """A fault of the scenario in words; with several batteries it says of which."""
    what = {
        AdcFault.FAIL: "ADC readings fail",
        AdcFault.ABSENT: "ADC absent",
        AdcFault.SLOW: f"ADC readings take {fault.delay_us / 1000:g} ms",
    }[fault.adc]
    whose = f"Battery {fault.instance + 1}: " if batteries > 1 else ""
    return (
        whose
        + what
        + (" to the end" if fault.until_ms is None else f" for {(fault.until_ms - fault.at_ms) / 1000:g} s")
    )


def _is_failsafe(text: str) -> bool:
    """Whether a text says that the failsafe fired, as ``Battery 1 is low 10.45V used 0 mAh``."""
    return FAILSAFE_TEXT.match(text) is not None
