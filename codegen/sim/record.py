"""The record of a simulation: what the firmware sent, said and did."""

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isclose
from typing import Any

from codegen.model.scenario import Course, Event, Fault, Scenario, Sending, is_number
from codegen.sim.line import Line
from codegen.sim.program import SimulatedProgram
from codegen.sim.sample import Burst, Happening, Kind, Reading, Sample, Traffic
from codegen.sim.told import Told

_MOST_POINTS = 20_000
_MOST_LINES = 500
_MOST_TEXTS = 5_000
_SECOND_MS = 1000
_NOISE = 1e-13  # of a number
_ARMED, _STATUS, _MODE = "vehicle.armed", "vehicle.status", "vehicle.mode"


class Recording:
    """Collects the records of one program of a simulation, over all its boards and their restarts.

    ``name`` is that of the program where several run, else nothing; ``beside`` the recordings of the other programs.
    ``readings_of`` has what was told by the label of the quantity, ``states_of`` what changed in the state; ``busiest``
    is the second in which most bytes went out.
    """

    def __init__(
        self, scenario: Scenario, program: SimulatedProgram, name: str = "", beside: Sequence["Recording"] = ()
    ) -> None:
        """Begin with the faults that the scenario has."""
        self.scenario = scenario
        self.name = name
        self.beside = tuple(beside)
        self.program = program
        self.key = program.key
        self.stretches = program.stretches
        self.runtime = ""
        self.readings_of: dict[str, list[Reading]] = {}
        self.states_of: dict[str, list[tuple[int, Any]]] = {}
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
        self._spacing_ms: dict[str, int] = {}
        self._at_start: Mapping[str, float] | None = None
        self._ended = Traffic()
        self._current = Traffic()
        self._ended_overruns = 0
        self.busiest = Burst()
        self._samples: deque[Sample] = deque()

    @property
    def all(self) -> tuple["Recording", ...]:
        """Return this recording and those of the programs that run beside it."""
        return (self, *self.beside)

    @property
    def is_main(self) -> bool:
        """Return whether it is that of the vehicle's own program."""
        return self.key is None

    @property
    def happenings(self) -> list[Happening]:
        """Return what happened, in the order of time, with faults and what was sent; of the console the last lines.

        It is what happened in all programs, where there are others beside this one.
        """
        stated = [
            happening
            for event in self.scenario.events
            if self.is_main and event.at_ms <= self.at_ms and (happening := _stated(event, self.name)) is not None
        ]
        found = [*stated, *self._happenings, *self._console]
        for other in self.beside:
            found += other.happenings
        return sorted(found, key=lambda happening: happening.at_ms)

    @property
    def traffic(self) -> Traffic:
        """Return what went out, over all restarts."""
        return self._ended.plus(self._current)

    @property
    def overruns(self) -> int:
        """Control slots that were missed, over all restarts."""
        return self._ended_overruns + self.sample.overruns

    @property
    def restarts(self) -> int:
        """Return how often a board was restarted; one that takes the place of another was not."""
        return max(0, self.starts - self.boards)

    def course(self, label: str, at_ms: float) -> Course | None:
        """The course of a quantity at a time in ms; None while its board is out, or where there is none."""
        for stretch in self.stretches:
            if stretch.start_ms <= at_ms and (stretch.end_ms is None or at_ms <= stretch.end_ms):
                return stretch.course(label)
        return None

    def has_course(self, label: str) -> bool:
        """Return whether the scenario says what is true of a quantity, at any time."""
        return any(stretch.course(label) for stretch in self.stretches)

    def true(self, label: str, at_ms: float) -> float | None:
        """Return the true value of a quantity, in its unit; None where it is unknown, or the scenario has no course."""
        course = self.course(label, at_ms)
        value = None if course is None else course.value(at_ms)
        return float(value) if is_number(value) else None

    def told(self, label: str, at_ms: float) -> float | None:
        """Return what was told last of a number by a time, in its unit; None for unknown, or nothing."""
        reading = self.reading(label, at_ms)
        return None if reading is None else reading.value

    def reading(self, label: str, at_ms: float) -> Reading | None:
        """Return the same with its precision; None for nothing."""
        before = [reading for reading in self.readings_of.get(label, ()) if reading.at_ms <= at_ms]
        return before[-1] if before else None

    def state(self, label: str, at_ms: float) -> Any:
        """Return what the state had for a quantity that is watched, at a time."""
        before = [value for time, value in self.states_of.get(label, ()) if time <= at_ms]
        return before[-1] if before else None

    @property
    def lines(self) -> tuple[Line, ...]:
        """Return the numbers to report: those with a course, and those whose reported values changed."""
        return tuple(line for line in self.program.lines if self.has_course(line.label) or self._varied(line.label))

    @property
    def drawn(self) -> tuple[Line, ...]:
        """Return the numbers whose reported values changed, which are worth a chart."""
        return tuple(line for line in self.lines if self._varied(line.label))

    @property
    def tells_state(self) -> bool:
        """Return whether the program has a state to tell, armed or not."""
        return any(watched.label in (_ARMED, _STATUS) for watched in self.program.watched)

    def _varied(self, label: str) -> bool:
        """Return whether what was told or what is true changed; a noise around one value counts."""
        told = {reading.value for reading in self.readings_of.get(label, ()) if reading.value is not None}
        courses = [course for stretch in self.stretches if (course := stretch.course(label)) is not None]
        true = {point.value for course in courses for point in course.points}
        return len(told) > 1 or len(true) > 1 or bool(courses and told and told != true)

    def add(
        self,
        kind: Kind,
        text: str,
        severity: int | None = None,
        at_ms: int | None = None,
        of: str = "",
        word: str = "",
    ) -> Happening:
        """Note that something happened (now, if no time is given), and return it."""
        happening = Happening(self.at_ms if at_ms is None else at_ms, kind, text, severity, self.name, of, word)
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
            case "frame":
                self._take_frame(bytes.fromhex(record["data"]))
            case "messages":
                self._take_messages(record)
            case "failed" | "stood":
                self.traceback = record["traceback"].splitlines()
            case "end":
                self.reason = record["reason"]
        return self._happening(record)

    def _happening(self, record: Mapping[str, Any]) -> Happening | None:
        """Return what a record says has happened."""
        match record["kind"]:
            case "state":
                return self._take_state(record["label"], record["value"])
            case "failsafe":
                return self._take_failsafe(record)
            case "action":
                return self.add(Kind.ACTION, record["name"])
            case "text":
                return self.add(Kind.TEXT, record["text"], record["severity"])
            case "event":
                return self.add(Kind(record["name"]), record["text"])
        return None

    def take_board_out(self, at_ms: int) -> Happening:
        """Note that the board was taken out."""
        self.is_out = True
        self._break_lines(at_ms)
        return self.add(Kind.SWAP, "The board was taken out", at_ms=at_ms)

    def take_new_board(self, at_ms: int) -> Happening:
        """Note that another board is in its place."""
        self.is_out = False
        self.boards += 1
        self.at_ms = max(self.at_ms, at_ms)
        return self.add(Kind.SWAP, "Another board was put in", at_ms=at_ms)

    def largest_difference(self, label: str) -> tuple[float, int] | None:
        """The largest difference of what was told of a number from what was true, in its unit, and its time in ms.

        What a double cannot tell apart after a few roundings is no difference.
        """
        found = [
            (0.0 if isclose(reading.value, true, rel_tol=_NOISE) else abs(reading.value - true), reading.at_ms)
            for reading in self.readings_of.get(label, ())
            if reading.value is not None
            if (true := self.true(label, reading.at_ms)) is not None
        ]
        return max(found, key=lambda pair: (pair[0], -pair[1])) if found else None

    def _start(self, runtime: str) -> None:
        self.runtime = runtime
        self.starts += 1
        self._ended = self.traffic
        self._current = Traffic()
        self._ended_overruns = self.overruns
        self._at_start = None
        self.sample = Sample(at_ms=self.at_ms)
        self._samples = deque((self.sample,))
        if self.starts > 1:
            self._break_lines(self.at_ms)

    def _break_lines(self, at_ms: int) -> None:
        for readings in self.readings_of.values():
            readings.append(Reading(at_ms, None))

    def _take_sample(self, record: Mapping[str, Any]) -> None:
        self.sample = replace(
            self.sample,
            at_ms=record["at"],
            frames=record["frames"],
            size=record["bytes"],
            overruns=record["overruns"],
        )
        self._samples.append(self.sample)
        first = self._samples[0]
        length_ms = self.sample.at_ms - first.at_ms
        if length_ms >= _SECOND_MS:
            self._samples.popleft()
            burst = Burst(self.sample.frames - first.frames, self.sample.size - first.size, length_ms)
            self.busiest = max(self.busiest, burst, key=lambda each: each.size / each.length_ms)

    def _take_state(self, label: str, value: Any) -> Happening | None:
        """A quantity of the state has another value; the first one after a start is no event."""
        known = self.states_of.setdefault(label, [])
        before = known[-1][1] if known else None
        known.append((self.at_ms, value))
        if label == _STATUS:
            self.sample = replace(self.sample, state=value)
        elif label == _ARMED:
            was_armed, is_armed = self.sample.is_armed, bool(value)
            self.sample = replace(self.sample, is_armed=is_armed)
            if was_armed is not is_armed:
                return self.add(Kind.ARMED if is_armed else Kind.DISARMED, "")
        elif label == _MODE and before is not None and before != value:
            return self.add(Kind.MODE, f"{value:g}")
        return None

    def _take_failsafe(self, record: Mapping[str, Any]) -> Happening:
        """A failsafe has another level: its words, and the quantity that it watches, are those of the specification."""
        level, index = record["level"], record["index"]
        guard = next((each for each in self.program.guards if each.attribute == record["name"]), None)
        words = guard.words if guard else ()
        word = words[level - 1] if 0 < level <= len(words) else f"level {level}" if level else "over"
        owner, _, name = (guard.path if guard else "").partition(".")
        label = f"{owner}[{index}].{name}" if index else f"{owner}.{name}"
        return self.add(Kind.FAILSAFE, f"{record['title']} {word}", of=label if guard and guard.path else "", word=word)

    def _take_frame(self, frame: bytes) -> None:
        if self._at_start is None:
            self._at_start = self.parameters  # numbers of instances are those of the start
        for told in self.program.telling.read(frame, self._at_start):
            self.take_told(told)

    def take_told(self, told: Told) -> None:
        """Note what was told now of a quantity."""
        owner, _, name = told.path.partition(".")
        label = f"{owner}[{told.instance}].{name}" if told.instance else told.path
        self._take_reading(label, Reading(self.at_ms, told.value, told.exact, told.precision))

    def _take_reading(self, label: str, reading: Reading) -> None:
        readings = self.readings_of.setdefault(label, [])
        spacing_ms = self._spacing_ms.get(label, 0)
        last = readings[-1] if readings else None
        is_known = reading.value is not None
        if last and is_known == (last.value is not None) and reading.at_ms - last.at_ms < spacing_ms:
            return
        readings.append(reading)
        if len(readings) > _MOST_POINTS:  # a run without end: keep every second one
            self.readings_of[label] = readings[::2]
            self._spacing_ms[label] = max(1, 2 * spacing_ms, 2 * self.at_ms // _MOST_POINTS)

    def _take_messages(self, record: Mapping[str, Any]) -> None:
        names = {str(number): name for number, name in self.program.messages.items()}
        counts = {names.get(number, number): count for number, count in record["counts"].items()}
        self._current = Traffic(
            frames={name: count for name, (count, _) in counts.items()},
            sizes={name: size for name, (_, size) in counts.items()},
            dropped=record["dropped"],
            received=record["received"],
            crc_errors=record["crc_errors"],
            gaps=record["gaps"],
        )
        self.parameters = record["parameters"] or self.parameters


def _stated(event: Event, program: str) -> Happening | None:
    """Return an event of the scenario that the firmware does not report itself, as an entry of the record."""
    if isinstance(event, Fault):
        return Happening(event.at_ms, Kind.FAULT, fault_text(event), program=program, of=event.of)
    if isinstance(event, Sending):
        again = "" if event.every_ms is None else f" every {event.every_ms / 1000:g} s"
        return Happening(event.at_ms, Kind.SENT, event.message + again, program=program)
    return None


def fault_text(fault: Fault) -> str:
    """A fault of the scenario in words."""
    delay = f" {fault.delay_us / 1000:g} ms" if fault.delay_us else ""
    lasts = " to the end" if fault.until_ms is None else f" for {(fault.until_ms - fault.at_ms) / 1000:g} s"
    return f"{fault.of}: {fault.words}{delay}{lasts}"
