"""The chart of the voltage over time: where every line and label lies, in the units of its drawing."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from codegen.model.scenario import AdcFault, Fault
from codegen.sim.record import Happening, Kind, Reading, Recording

LEVELS = (("BATT_LOW_VOLT", "low", "low"), ("BATT_CRT_VOLT", "critical", "crit."))
"""Parameters whose voltage is drawn as a line, each with the class of the line and a word for it."""
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
    """Everything that is drawn. ``true`` and ``reported`` are paths of SVG; the latter breaks where it was unknown."""

    size: Size
    name: str
    time_unit: str
    time_ticks: tuple[Tick, ...]
    voltage_ticks: tuple[Tick, ...]
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


def draw_chart(recording: Recording, happenings: Sequence[Happening], size: Size, name: str) -> Chart:
    """The chart of a recording; ``happenings`` are the rows of the table, whose numbers the markers show."""
    return _Drawing(recording, size).chart(happenings, name)


class _Drawing:
    """Turns times and voltages into coordinates."""

    def __init__(self, recording: Recording, size: Size) -> None:
        self._recording = recording
        self._size = size
        self._end_ms = max(recording.at_ms, 1)
        self._levels = [
            (style, name, word, round(recording.parameters[name] * 1000))
            for name, style, word in LEVELS
            if recording.parameters.get(name)
        ]
        self._true = self._true_points()
        readings = [reading.millivolts for reading in recording.readings if reading.millivolts is not None]
        shown = [*(mv for _, mv in self._true), *readings, *(level[-1] for level in self._levels)]
        lowest, highest = min(shown), max(shown)
        self._step_mv = _voltage_step(max(highest - lowest, 200))
        self._low_mv = (lowest - self._step_mv // 4) // self._step_mv * self._step_mv
        self._high_mv = -(-(highest + self._step_mv // 4) // self._step_mv) * self._step_mv

    def chart(self, happenings: Sequence[Happening], name: str) -> Chart:
        rows = self._rows(happenings)
        more = _MARKER_SPACE * max(rows, default=0)
        self._size = replace(self._size, top=self._size.top + more, height=self._size.height + more)
        per_unit, unit = next((ms, unit) for ms, unit, until in _UNITS if until is None or self._end_ms <= until)
        step = _time_step(self._end_ms / per_unit, self._size.ticks)
        times = [step * index for index in range(int(self._end_ms / per_unit / step + 1e-9) + 1)]
        heights = range(int(self._low_mv), int(self._high_mv) + 1, self._step_mv)
        digits = 1 if self._step_mv % 100 == 0 else 2
        return Chart(
            size=self._size,
            name=name,
            time_unit=unit,
            time_ticks=tuple(Tick(self._x(time * per_unit), f"{time:g}") for time in times),
            voltage_ticks=tuple(Tick(self._y(mv), f"{mv / 1000:.{digits}f}") for mv in heights),
            levels=tuple(
                Level(self._y(mv), style, f"{name} {mv / 1000:g} V", f"{word} {mv / 1000:g} V")
                for style, name, word, mv in self._levels
            ),
            bands=tuple(self._bands()),
            markers=tuple(self._markers(happenings, rows)),
            true=_path([(self._x(at_ms), self._y(mv)) for at_ms, mv in self._true]),
            reported=" ".join(self._reported()),
        )

    def _x(self, at_ms: float) -> float:
        size = self._size
        return round(size.left + at_ms / self._end_ms * (size.width - size.left - size.right), 1)

    def _y(self, millivolts: float) -> float:
        size = self._size
        share = (self._high_mv - millivolts) / (self._high_mv - self._low_mv)
        return round(size.top + share * (size.height - size.top - size.bottom), 1)

    def _true_points(self) -> list[tuple[int, float]]:
        scenario = self._recording.scenario
        inside = [(p.at_ms, float(p.millivolts)) for p in scenario.points if 0 < p.at_ms < self._end_ms]
        return [(0, scenario.millivolts(0)), *inside, (self._end_ms, scenario.millivolts(self._end_ms))]

    def _reported(self) -> Iterable[str]:
        for is_known, readings in groupby(self._recording.readings, key=lambda reading: reading.millivolts is not None):
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
        for event in self._recording.scenario.events:
            if isinstance(event, Fault) and event.at_ms < self._end_ms:
                until_ms = self._end_ms if event.until_ms is None else min(event.until_ms, self._end_ms)
                x = self._x(event.at_ms)
                label = {AdcFault.FAIL: "ADC fails", AdcFault.ABSENT: "no ADC", AdcFault.SLOW: "ADC slow"}[event.adc]
                width = round(self._x(until_ms) - x, 1)
                yield Band(x, width, label if width > 64 else "")

    def _markers(self, happenings: Sequence[Happening], rows: Sequence[int]) -> Iterable[Marker]:
        marked = [(index, happening) for index, happening in enumerate(happenings, 1) if is_marked(happening)]
        for (index, happening), row in zip(marked, rows, strict=False):
            style = "severe" if happening.kind in (Kind.FAILSAFE, Kind.STOPPED) else "plain"
            y = self._size.top - 12 - row * _MARKER_SPACE
            yield Marker(self._x(happening.at_ms), y, index, style, happening.text or happening.kind.value)

    def _rows(self, happenings: Sequence[Happening]) -> list[int]:
        """For each marker the row that its number stands in: numbers that would cover each other stand in several."""
        taken = [-100.0] * _MARKER_ROWS
        rows = []
        for happening in [happening for happening in happenings if is_marked(happening)][:MOST_MARKERS]:
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


def _voltage_step(range_mv: float) -> int:
    return next(step for step in (50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000) if range_mv / step <= 8)


def _time_step(length: float, ticks: int) -> float:
    steps = [base * 10.0**power for power in range(-3, 4) for base in (1, 2, 5)] + [15, 30, 60, 120]
    return next((step for step in sorted(steps) if length / step <= ticks), length)
