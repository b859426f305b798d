"""The chart of a quantity over time: where every line and label lies, in its drawing's units."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from codegen.frozen import dataclass
from codegen.model.scenario import Fault, Point, Stretch, Swap, is_number
from codegen.sim.amount import amount, digits_of
from codegen.sim.line import Line
from codegen.sim.record import Recording
from codegen.sim.sample import Happening, Kind, Reading

MOST_MARKERS = 40
_UNITS = ((1000, "s", 600_000), (60_000, "min", 6 * 3_600_000), (3_600_000, "h", None))
_LEAST = 0.02
"""The least height of a chart whose true value stays, as a share of the largest value in it."""
_DIGIT = 7
"""Width of a digit of a label."""
_SILENT_MS = 1000
"""A line breaks where nothing was told for longer, and for several times as long as usual."""
_SHORT = 5
"""Characters of a word beside the line of a level."""
_MARKER_ROWS = 3
_MARKER_SPACE = 19


@dataclass(frozen=True, slots=True)
class Size:
    """Size of a drawing and of the margins around its plot; ``ticks`` is about how many labels the time axis gets."""

    width: int
    height: int
    left: int
    right: int
    top: int
    bottom: int
    ticks: int


WIDE = Size(1040, 400, 58, 84, 36, 46, 10)
NARROW = Size(400, 330, 40, 12, 36, 44, 4)


@dataclass(frozen=True, slots=True)
class Tick:
    """A label of an axis, at a coordinate along it."""

    at: float
    label: str


@dataclass(frozen=True, slots=True)
class Height:
    """A threshold: its height, the class of its line, its label in the legend and beside the line."""

    y: float
    style: str
    label: str
    short: str


@dataclass(frozen=True, slots=True)
class Band:
    """A time in which there was a fault."""

    x: float
    width: float
    label: str


@dataclass(frozen=True, slots=True)
class Marker:
    """A happening: its time, the height of its number, and its number in the table."""

    x: float
    y: float
    number: int
    style: str
    text: str


@dataclass(frozen=True, slots=True)
class Chart:
    """Everything that is drawn. ``true`` and ``reported`` are paths of SVG, which break where nothing can be known; the
    latter also where nothing was told."""

    size: Size
    name: str
    unit: str
    time_unit: str
    time_ticks: tuple[Tick, ...]
    value_ticks: tuple[Tick, ...]
    levels: tuple[Height, ...]
    bands: tuple[Band, ...]
    markers: tuple[Marker, ...]
    true: str
    reported: str


def is_marked(happening: Happening) -> bool:
    """Return whether a happening stands in the chart: all but the chatter, and what follows from a failsafe at once."""
    if happening.kind is Kind.TEXT:
        return happening.severity is not None and happening.severity <= 4
    return happening.kind not in (Kind.CONSOLE, Kind.ACTION, Kind.MODE)


def concerns(happening: Happening, recording: Recording, label: str) -> bool:
    """Return whether a happening concerns a quantity: it is of its program, and
    about no other quantity of that alone.
    """
    return happening.program == recording.name and happening.of in ("", label)


def draw_chart(recording: Recording, happenings: Sequence[Happening], size: Size, name: str, line: Line) -> Chart:
    """The chart of one quantity; ``happenings`` are the rows of the table, whose numbers the markers show."""
    return _Drawing(recording, size, line).chart(happenings, name)


class _Drawing:
    """Turns times and values in the unit of the quantity into coordinates."""

    def __init__(self, recording: Recording, size: Size, line: Line) -> None:
        self._recording = recording
        self._size = size
        self._line = line
        self._end_ms = max(recording.at_ms, 1)
        self._levels = [
            (level, recording.parameters[level.parameter])
            for level in line.levels
            if recording.parameters.get(level.parameter)
        ]
        self._true = [part for stretch in recording.stretches for part in self._true_parts(stretch)]
        self._readings = recording.readings_of.get(line.label, ())
        told = [reading.value for reading in self._readings if reading.value is not None]
        drawn = [*(value for part in self._true for _, value in part), *told]
        values = [*drawn, *(value for _, value in self._levels)] or [0.0]
        lowest, highest = min(values), max(values)
        turns = {value for part in self._true for _, value in part}
        least = 0.0 if len(turns) > 1 else _LEAST * max(abs(lowest), abs(highest))
        self._step = max(_value_step(max(highest - lowest, least) or 1.0), float(line.is_whole))
        self._low = math.floor((lowest - self._step / 4) / self._step)
        self._high = math.ceil((highest + self._step / 4) / self._step)

    def chart(self, happenings: Sequence[Happening], name: str) -> Chart:
        rows = self._rows(happenings)
        more = _MARKER_SPACE * max(rows, default=0)
        digits, unit_of_value = digits_of(self._step), self._line.unit
        heights = [number * self._step for number in range(self._low, self._high + 1)]
        widest = _DIGIT * max(len(f"{value:.{digits}f}") for value in heights) + 12
        size = self._size
        left = max(size.left, widest)
        self._size = replace(size, top=size.top + more, height=size.height + more, left=left)
        per_unit, unit = next((ms, unit) for ms, unit, until in _UNITS if until is None or self._end_ms <= until)
        step = _time_step(self._end_ms / per_unit, self._size.ticks)
        times = [step * index for index in range(int(self._end_ms / per_unit / step + 1e-9) + 1)]
        return Chart(
            size=self._size,
            name=name,
            unit=unit_of_value,
            time_unit=unit,
            time_ticks=tuple(Tick(self._x(time * per_unit), f"{time:g}") for time in times),
            value_ticks=tuple(Tick(self._y(value), f"{value:.{digits}f}") for value in heights),
            levels=tuple(
                Height(
                    self._y(value),
                    level.style,
                    f"{level.parameter} {amount(value, unit_of_value)}",
                    f"{level.word if len(level.word) <= _SHORT else level.word[: _SHORT - 1] + '.'} {value:g}",
                )
                for level, value in self._levels
            ),
            bands=tuple(self._bands()),
            markers=tuple(self._markers(happenings, rows)),
            true=" ".join(_path([(self._x(at_ms), self._y(value)) for at_ms, value in line]) for line in self._true),
            reported=" ".join(self._reported()),
        )

    def _x(self, at_ms: float) -> float:
        size = self._size
        return round(size.left + at_ms / self._end_ms * (size.width - size.left - size.right), 1)

    def _y(self, value: float) -> float:
        size = self._size
        share = (self._high - value / self._step) / (self._high - self._low)
        return round(size.top + share * (size.height - size.top - size.bottom), 1)

    def _true_parts(self, stretch: Stretch) -> Iterable[list[tuple[int, float]]]:
        """The true values while a board was there, in parts in which they are known; none if it was not reached."""
        end_ms = self._end_ms if stretch.end_ms is None else min(stretch.end_ms, self._end_ms)
        course = stretch.course(self._line.label)
        if course is None or stretch.start_ms > end_ms:
            return
        inside = [point for point in course.points if stretch.start_ms < point.at_ms < end_ms]
        ends = [Point(at_ms, course.value(at_ms)) for at_ms in (stretch.start_ms, end_ms)]
        part: list[tuple[int, float]] = []
        for point in [ends[0], *inside, ends[1]]:
            if is_number(point.value):
                part.append((point.at_ms, float(point.value)))
            elif part:
                yield [*part, (point.at_ms, part[-1][1])]
                part = []
        if part:
            yield part

    def _reported(self) -> Iterable[str]:
        """The lines of what was told, without a break in each."""
        part: list[Reading] = []
        for reading in self._readings:
            is_late = bool(part) and reading.at_ms - part[-1].at_ms > self._longest_ms
            if part and (reading.value is None or is_late):
                yield _path(self._thinned(part))
                part = []
            if reading.value is not None:
                part.append(reading)
        if part:
            yield _path(self._thinned(part))

    @property
    def _longest_ms(self) -> int:
        """The longest time between two values that belong to one line."""
        spans = sorted(after.at_ms - before.at_ms for before, after in pairwise(self._readings))
        return max(_SILENT_MS, 3 * spans[len(spans) // 2] if spans else 0)

    def _thinned(self, readings: Iterable[Reading]) -> list[tuple[float, float]]:
        """The points of a line: of those that share a unit of width the first, the lowest, the highest and the last."""
        points = [(self._x(reading.at_ms), self._y(reading.value or 0.0)) for reading in readings]
        thinned: list[tuple[float, float]] = []
        for _, group in groupby(points, key=lambda point: int(point[0])):
            column = list(group)
            kept = {0, len(column) - 1}
            kept.add(min(range(len(column)), key=lambda index: column[index][1]))
            kept.add(max(range(len(column)), key=lambda index: column[index][1]))
            thinned.extend(column[index] for index in sorted(kept))
        return thinned

    def _bands(self) -> Iterable[Band]:
        for event in self._recording.scenario.events:
            if event.at_ms >= self._end_ms:
                continue
            if isinstance(event, Fault) and self._recording.is_main and event.of == self._line.label:
                yield self._band(event.at_ms, event.until_ms, event.words)
            elif isinstance(event, Swap) and event.program == self._recording.key:
                yield self._band(event.at_ms, event.until_ms, "no board")

    def _band(self, at_ms: int, until_ms: int | None, label: str) -> Band:
        x = self._x(at_ms)
        width = round(self._x(self._end_ms if until_ms is None else min(until_ms, self._end_ms)) - x, 1)
        return Band(x, width, label if width > 7 * len(label) + 12 else "")

    def _marked(self, happenings: Sequence[Happening]) -> list[tuple[int, Happening]]:
        """Return what is marked, with its number in the table."""
        return [
            (number, happening)
            for number, happening in enumerate(happenings, 1)
            if is_marked(happening) and concerns(happening, self._recording, self._line.label)
        ]

    def _markers(self, happenings: Sequence[Happening], rows: Sequence[int]) -> Iterable[Marker]:
        for (index, happening), row in zip(self._marked(happenings), rows, strict=False):
            style = "severe" if happening.kind in (Kind.FAILSAFE, Kind.STOPPED) else "plain"
            y = self._size.top - 12 - row * _MARKER_SPACE
            yield Marker(self._x(happening.at_ms), y, index, style, happening.text or happening.kind.value)

    def _rows(self, happenings: Sequence[Happening]) -> list[int]:
        """Return for each marker the row of its number: numbers that would cover each other stand in several."""
        taken = [-100.0] * _MARKER_ROWS
        rows = []
        for _, happening in self._marked(happenings)[:MOST_MARKERS]:
            x = self._x(happening.at_ms)
            free = [row for row in range(_MARKER_ROWS) if x - taken[row] >= _MARKER_SPACE]
            row = free[0] if free else min(range(_MARKER_ROWS), key=lambda row: taken[row])
            taken[row] = x
            rows.append(row)
        return rows


def _path(points: Sequence[tuple[float, float]]) -> str:
    """The path through points; a single one becomes a dot."""
    start, *rest = points
    return f"M{start[0]:g} {start[1]:g}" + ("".join(f"L{x:g} {y:g}" for x, y in rest) or "h0.1")


def _value_step(length: float) -> float:
    """The smallest of 1, 2, 5 times a power of 10 of which at most eight make a length."""
    power = math.floor(math.log10(length)) - 1
    steps = (float(f"{base}e{power + more}") for more in range(4) for base in (1, 2, 5))
    return next(step for step in steps if length / step <= 8)


def _time_step(length: float, ticks: int) -> float:
    steps = [base * 10.0**power for power in range(-3, 4) for base in (1, 2, 5)] + [15, 30, 60, 120]
    return next((step for step in sorted(steps) if length / step <= ticks), length)
