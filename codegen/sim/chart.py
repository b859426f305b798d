"""The chart of a battery's voltage, or current, over time: where every line and label lies, in its drawing's units."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import Enum
from itertools import groupby

from codegen.frozen import dataclass
from codegen.model.scenario import AdcFault, Battery, Fault, Point, Stretch, Swap, value_at
from codegen.sim.record import FAILSAFE_TEXT, Recording
from codegen.sim.sample import Happening, Kind, Reading

LEVELS = (("LOW_VOLT", "low", "low"), ("CRT_VOLT", "critical", "crit."))
"""Parameters, without the prefix of the battery, whose voltage is drawn as a line, with its class and a word for it."""
MOST_MARKERS = 40
_UNITS = ((1000, "s", 600_000), (60_000, "min", 6 * 3_600_000), (3_600_000, "h", None))
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


class Shown(Enum):
    """What a chart shows; its unit."""

    VOLTAGE = "V"
    CURRENT = "A"


@dataclass(frozen=True, slots=True)
class Tick:
    """A label of an axis, at a coordinate along it."""

    at: float
    label: str


@dataclass(frozen=True, slots=True)
class Level:
    """A threshold: its height, the class of its line, its label in the legend and beside the line."""

    y: float
    style: str
    label: str
    short: str


@dataclass(frozen=True, slots=True)
class Band:
    """A time in which the ADC had a fault."""

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
    """Everything that is drawn. ``true`` and ``reported`` are paths of SVG, which break where there is no battery; the
    latter also where it was unknown."""

    size: Size
    name: str
    unit: str
    time_unit: str
    time_ticks: tuple[Tick, ...]
    value_ticks: tuple[Tick, ...]
    levels: tuple[Level, ...]
    bands: tuple[Band, ...]
    markers: tuple[Marker, ...]
    true: str
    reported: str


def is_marked(happening: Happening) -> bool:
    """Whether a happening stands in the chart: all but the chatter."""
    if happening.kind is Kind.TEXT:
        return happening.severity is not None and happening.severity <= 4
    return happening.kind is not Kind.CONSOLE


def concerns(happening: Happening, recording: Recording, instance: int) -> bool:
    """Whether a happening concerns a battery: it is of its program, and of no other battery of that."""
    if happening.program != recording.name:
        return False
    match = FAILSAFE_TEXT.match(happening.text)
    return match is None or int(match[2]) == instance + 1


def draw_chart(
    recording: Recording,
    happenings: Sequence[Happening],
    size: Size,
    name: str,
    instance: int = 0,
    shown: Shown = Shown.VOLTAGE,
) -> Chart:
    """The chart of one battery; ``happenings`` are the rows of the table, whose numbers the markers show."""
    return _Drawing(recording, size, instance, shown).chart(happenings, name)


class _Drawing:
    """Turns times and voltages in mV, or currents in mA, into coordinates."""

    def __init__(self, recording: Recording, size: Size, instance: int, shown: Shown) -> None:
        self._recording = recording
        self._size = size
        self._instance = instance
        self._shown = shown
        self._end_ms = max(recording.at_ms, 1)
        self._levels = list(self._level_lines()) if shown is Shown.VOLTAGE else []
        self._true = [line for stretch in recording.stretches if (line := self._true_line(stretch))]
        self._readings = [
            Reading(reading.at_ms, reading.millivolts if shown is Shown.VOLTAGE else reading.milliamperes)
            for reading in recording.readings_of.get(instance, ())
        ]
        readings = [reading.millivolts for reading in self._readings if reading.millivolts is not None]
        drawn = [*(value for line in self._true for _, value in line), *readings]
        values = [*drawn, *(level[-1] for level in self._levels)] or [0]
        lowest, highest = min(values), max(values)
        self._step = _value_step(max(highest - lowest, 200))
        self._low = (lowest - self._step // 4) // self._step * self._step
        self._high = -(-(highest + self._step // 4) // self._step) * self._step

    def chart(self, happenings: Sequence[Happening], name: str) -> Chart:
        rows = self._rows(happenings)
        more = _MARKER_SPACE * max(rows, default=0)
        self._size = replace(self._size, top=self._size.top + more, height=self._size.height + more)
        per_unit, unit = next((ms, unit) for ms, unit, until in _UNITS if until is None or self._end_ms <= until)
        step = _time_step(self._end_ms / per_unit, self._size.ticks)
        times = [step * index for index in range(int(self._end_ms / per_unit / step + 1e-9) + 1)]
        heights = range(int(self._low), int(self._high) + 1, self._step)
        digits = 1 if self._step % 100 == 0 else 2
        return Chart(
            size=self._size,
            name=name,
            unit=self._shown.value,
            time_unit=unit,
            time_ticks=tuple(Tick(self._x(time * per_unit), f"{time:g}") for time in times),
            value_ticks=tuple(Tick(self._y(value), f"{value / 1000:.{digits}f}") for value in heights),
            levels=tuple(
                Level(self._y(mv), style, f"{name} {mv / 1000:g} V", f"{word} {mv / 1000:g} V")
                for style, name, word, mv in self._levels
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
        share = (self._high - value) / (self._high - self._low)
        return round(size.top + share * (size.height - size.top - size.bottom), 1)

    def _level_lines(self) -> Iterable[tuple[str, str, str, int]]:
        recording = self._recording
        if self._instance < len(recording.prefixes):
            for suffix, style, word in LEVELS:
                name = recording.prefixes[self._instance] + suffix
                if recording.parameters.get(name):
                    yield style, name, word, round(recording.parameters[name] * 1000)

    def _true_line(self, stretch: Stretch) -> list[tuple[int, float]]:
        """The true values while a board was there: none before it came, or if it was not reached."""
        end_ms = self._end_ms if stretch.end_ms is None else min(stretch.end_ms, self._end_ms)
        if self._instance >= len(stretch.batteries) or stretch.start_ms > end_ms:
            return []
        battery = stretch.batteries[self._instance]
        points = self._points(battery)
        if not points:
            return []
        inside = [(point.at_ms, float(point.value)) for point in points if stretch.start_ms < point.at_ms < end_ms]
        ends = [(at_ms, value_at(points, at_ms)) for at_ms in (stretch.start_ms, end_ms)]
        return [ends[0], *inside, ends[1]]

    def _points(self, battery: Battery) -> tuple[Point, ...]:
        return battery.points if self._shown is Shown.VOLTAGE else battery.currents

    def _reported(self) -> Iterable[str]:
        for is_known, readings in groupby(self._readings, key=lambda reading: reading.millivolts is not None):
            if is_known:
                yield _path(self._thinned(readings))

    def _thinned(self, readings: Iterable[Reading]) -> list[tuple[float, float]]:
        """The points of a line: of those that share a unit of width the first, the lowest, the highest and the last."""
        points = [(self._x(reading.at_ms), self._y(reading.millivolts or 0)) for reading in readings]
        thinned: list[tuple[float, float]] = []
        for _, group in groupby(points, key=lambda point: int(point[0])):
            column = list(group)
            kept = {0, len(column) - 1}
            kept.add(min(range(len(column)), key=lambda index: column[index][1]))
            kept.add(max(range(len(column)), key=lambda index: column[index][1]))
            thinned.extend(column[index] for index in sorted(kept))
        return thinned

    def _bands(self) -> Iterable[Band]:
        labels = {AdcFault.FAIL: "ADC fails", AdcFault.ABSENT: "no ADC", AdcFault.SLOW: "ADC slow"}
        for event in self._recording.scenario.events:
            if event.at_ms >= self._end_ms:
                continue
            if isinstance(event, Fault) and self._recording.is_main and event.instance == self._instance:
                yield self._band(event.at_ms, event.until_ms, labels[event.adc])
            elif isinstance(event, Swap) and event.program == self._recording.key:
                yield self._band(event.at_ms, event.until_ms, "no battery")

    def _band(self, at_ms: int, until_ms: int | None, label: str) -> Band:
        x = self._x(at_ms)
        width = round(self._x(self._end_ms if until_ms is None else min(until_ms, self._end_ms)) - x, 1)
        return Band(x, width, label if width > 7 * len(label) + 12 else "")

    def _marked(self, happenings: Sequence[Happening]) -> list[tuple[int, Happening]]:
        """What is marked, with its number in the table."""
        return [
            (number, happening)
            for number, happening in enumerate(happenings, 1)
            if is_marked(happening) and concerns(happening, self._recording, self._instance)
        ]

    def _markers(self, happenings: Sequence[Happening], rows: Sequence[int]) -> Iterable[Marker]:
        for (index, happening), row in zip(self._marked(happenings), rows, strict=False):
            style = "severe" if happening.kind in (Kind.FAILSAFE, Kind.STOPPED) else "plain"
            y = self._size.top - 12 - row * _MARKER_SPACE
            yield Marker(self._x(happening.at_ms), y, index, style, happening.text or happening.kind.value)

    def _rows(self, happenings: Sequence[Happening]) -> list[int]:
        """For each marker the row that its number stands in: numbers that would cover each other stand in several."""
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


def _value_step(length: float) -> int:
    steps = (int(f"{base}{'0' * power}") for power in range(1, 8) for base in (1, 2, 5))
    return next(step for step in steps if step >= 50 and length / step <= 8)


def _time_step(length: float, ticks: int) -> float:
    steps = [base * 10.0**power for power in range(-3, 4) for base in (1, 2, 5)] + [15, 30, 60, 120]
    return next((step for step in sorted(steps) if length / step <= ticks), length)
