"""The report of a simulation: one page of HTML that needs nothing else."""

from collections.abc import Iterable
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.render.templates import render_page
from codegen.sim.amount import amount, digits_of, seconds
from codegen.sim.chart import NARROW, WIDE, Chart, draw_chart, is_marked
from codegen.sim.expected import unmet
from codegen.sim.line import Line
from codegen.sim.record import Recording
from codegen.sim.run import Simulation
from codegen.sim.sample import SEVERITIES, Happening, Kind, state_words
from codegen.sim.verdict import line_name, verdict
from codegen.sim.written import write_whole

_MOST_ROWS = 1000
_PREFIXES = {
    Kind.REFUSED: "Arming refused",
    Kind.FAILSAFE: "Failsafe",
    Kind.ACTION: "Action",
    Kind.MODE: "Mode",
    Kind.SENT: "Sent",
    Kind.FAILED: "Failed",
}
"""The words in front of the texts of some happenings."""


@dataclass(frozen=True, slots=True)
class EventRow:
    """One row of the table of events."""

    number: int
    time: str
    program: str
    severity: str
    text: str
    style: str


@dataclass(frozen=True, slots=True)
class MessageRow:
    """One row of the table of messages; ``program`` is that which sends it, where several run."""

    program: str
    name: str
    count: int
    rate: str
    bytes_per_s: str
    size: int


@dataclass(frozen=True, slots=True)
class FigureView:
    """The charts of one quantity, ``title``; ``levels`` is the legend's part."""

    title: str
    doc: str
    has_true: bool
    summary: str
    charts: tuple[Chart, ...]
    levels: tuple[tuple[str, str], ...]
    has_faults: bool


@dataclass(frozen=True, slots=True)
class ProgramView:
    """A program at the end of a run: its counters and parameters by name; ``name`` is empty where it is alone."""

    name: str
    links: tuple[tuple[str, str], ...]
    parameters: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class ReportView:
    """The page, ready to print. ``facts`` are names with their values."""

    title: str
    doc: str
    mood: str
    verdict: tuple[str, ...]
    facts: tuple[tuple[str, str], ...]
    figures: tuple[FigureView, ...]
    has_programs: bool
    events: tuple[EventRow, ...]
    left_out: int
    messages: tuple[MessageRow, ...]
    total: MessageRow
    programs: tuple[ProgramView, ...]
    console: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class PictureView:
    """The first chart alone."""

    title: str
    summary: str
    chart: Chart


def write_report(path: str, simulation: Simulation, recording: Recording) -> None:
    """Write the page, or for a path that ends with .svg its first chart, whole or not at all.

    OSError: it cannot be written.
    """
    view = report_view(simulation, recording)
    if not path.endswith(".svg"):
        write_whole(path, render_page("sim/report.html.j2", view))
        return
    if not view.figures:
        raise OSError("the scenario draws no quantity")
    figure = view.figures[0]
    write_whole(path, render_page("sim/chart.svg.j2", PictureView(view.title, figure.summary, figure.charts[0])))


def report_view(simulation: Simulation, recording: Recording) -> ReportView:
    """The view of the page."""
    happened = recording.happenings
    listed = [happening for happening in happened if happening.kind is not Kind.CONSOLE]
    sentences = verdict(recording)
    return ReportView(
        title=simulation.scenario.name,
        doc=simulation.scenario.doc,
        mood=_mood(recording),
        verdict=tuple(sentences),
        facts=_facts(simulation, recording),
        figures=tuple(_figures(recording, listed, sentences)),
        has_programs=bool(recording.beside),
        events=tuple(_event_row(number, event) for number, event in enumerate(listed[:_MOST_ROWS], 1)),
        left_out=max(0, len(listed) - _MOST_ROWS) + sum(record.texts_left_out for record in recording.all),
        messages=tuple(row for record in recording.all for row in _message_rows(record, recording.at_ms)),
        total=_row("", "all", *_totals(recording), recording.at_ms),
        programs=tuple(_program(record) for record in recording.all),
        console=tuple(_console_line(happening) for happening in happened if happening.kind is Kind.CONSOLE),
    )


def _figures(recording: Recording, listed: list[Happening], sentences: list[str]) -> Iterable[FigureView]:
    for record in recording.all:
        for line in record.drawn:
            yield _figure(record, line, listed, sentences)


def _figure(recording: Recording, line: Line, listed: list[Happening], sentences: list[str]) -> FigureView:
    wide = draw_chart(recording, listed, WIDE, "wide", line)
    return FigureView(
        title=line_name(recording, line),
        doc=line.doc,
        has_true=bool(wide.true),
        summary=_summary(recording, line, sentences),
        charts=(wide, draw_chart(recording, listed, NARROW, "narrow", line)),
        levels=tuple((level.style, level.label) for level in wide.levels),
        has_faults=bool(wide.bands),
    )


def _program(recording: Recording) -> ProgramView:
    parameters = tuple((name, f"{value:g}") for name, value in sorted(recording.parameters.items()))
    return ProgramView(recording.name, _links(recording), parameters)


def _console_line(happening: Happening) -> str:
    return f"{happening.program}: {happening.text}" if happening.program else happening.text


def _mood(recording: Recording) -> str:
    if any(record.problem for record in recording.all):
        return "failed"
    if unmet(recording):
        return "failed"
    return "fired" if any(happening.kind is Kind.FAILSAFE for happening in recording.happenings) else "calm"


def _facts(simulation: Simulation, recording: Recording) -> tuple[tuple[str, str], ...]:
    sample = recording.sample
    speed = "as fast as it can" if not simulation.speed else f"{simulation.speed:g} times real time"
    return (
        ("Runtime", recording.runtime or str(simulation.runtime)),
        ("Simulated time", f"{seconds(recording.at_ms)} of {_planned(simulation)}"),
        ("Speed", "real time" if simulation.speed == 1 else speed),
        *((("At the end", state_words(sample)),) if recording.tells_state else ()),
        ("Restarts", str(sum(record.restarts for record in recording.all))),
        *((("Programs", ", ".join(record.name for record in recording.all)),) if recording.beside else ()),
    )


def _planned(simulation: Simulation) -> str:
    return "no limit" if simulation.duration_ms is None else seconds(simulation.duration_ms)


def _summary(recording: Recording, line: Line, sentences: list[str]) -> str:
    """Return what somebody is told who does not see the chart."""
    end_ms = recording.at_ms
    name, is_true = line_name(recording, line), recording.has_course(line.label)
    start, end = (recording.true(line.label, at_ms) if is_true else None for at_ms in (0, end_ms))
    if start is None or end is None:
        return " ".join([f"{name} over time.", *sentences])
    digits = digits_of(max(abs(end - start), abs(end) / 100, 1e-9) / 10)
    course = f"{amount(start, line.unit, digits)} to {amount(end, line.unit, digits)}"
    return " ".join([f"The true {name} goes from {course} in {seconds(end_ms)}.", *sentences])


def _event_row(number: int, event: Happening) -> EventRow:
    severity = "" if event.severity is None else _severity(event.severity)
    if event.kind is Kind.FAILSAFE or event.kind is Kind.STOPPED:
        style = "severe"
    else:
        style = "marked" if is_marked(event) else ""
    words = {Kind.ARMED: "Armed", Kind.DISARMED: "Disarmed", Kind.REBOOT: "Reboot"}
    text = event.text or words.get(event.kind, event.kind.value)
    if event.kind in _PREFIXES:
        text = f"{_PREFIXES[event.kind]}: {event.text}"
    return EventRow(number, seconds(event.at_ms), event.program, severity, text, style)


def _severity(number: int) -> str:
    return SEVERITIES[number] if 0 <= number < len(SEVERITIES) else str(number)


def _message_rows(recording: Recording, length_ms: int) -> tuple[MessageRow, ...]:
    traffic = recording.traffic
    return tuple(
        _row(recording.name, name, traffic.frames[name], traffic.sizes.get(name, 0), length_ms)
        for name in sorted(traffic.frames)
    )


def _totals(recording: Recording) -> tuple[int, int]:
    traffics = [record.traffic for record in recording.all]
    return (
        sum(sum(traffic.frames.values()) for traffic in traffics),
        sum(sum(traffic.sizes.values()) for traffic in traffics),
    )


def _row(program: str, name: str, count: int, size: int, length_ms: int) -> MessageRow:
    length_s = max(length_ms, 1) / 1000
    return MessageRow(program, name, count, f"{count / length_s:.2f}", f"{size / length_s:.1f}", size)


def _links(recording: Recording) -> tuple[tuple[str, str], ...]:
    traffic = recording.traffic
    return (
        ("Frames dropped by full or broken ports", str(traffic.dropped)),
        ("Gaps in the sequence of frames that went out", str(traffic.gaps)),
        ("Bytes received", str(traffic.received)),
        ("Damaged frames received (CRC)", str(traffic.crc_errors)),
        ("Control slots missed", str(recording.overruns)),
        ("Load of the board, predicted", _load(recording)),
    )


def _load(recording: Recording) -> str:
    """Return how busy the board would be, on the whole and in the second with most frames; see codegen/loop."""
    load = recording.program.load
    if isinstance(load, str):
        return f"unknown: {load}" if load else "unknown"
    traffic, busiest = recording.traffic, recording.busiest
    frames, size = sum(traffic.frames.values()), sum(traffic.sizes.values())
    whole = load.share(traffic.frames, size, traffic.received, recording.at_ms)
    if not frames:
        return f"{float(100 * whole):.1f} %"
    # The frames of the busiest second are not told by name: they are taken to be as all others are.
    alike = {name: Fraction(count * busiest.frames, frames) for name, count in traffic.frames.items()}
    peak = load.share(alike, busiest.size, 0, busiest.length_ms)
    return f"{float(100 * whole):.1f} %, {float(100 * max(whole, peak)):.1f} % in the busiest second"
