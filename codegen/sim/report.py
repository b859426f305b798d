"""The report of a simulation: one page of HTML that needs nothing else."""

import os
import tempfile
from dataclasses import dataclass

from codegen.render import render_page
from codegen.sim.chart import NARROW, WIDE, Chart, draw_chart, is_marked
from codegen.sim.record import SEVERITIES, Happening, Kind, Recording
from codegen.sim.run import Simulation
from codegen.sim.verdict import seconds, verdict

_MOST_ROWS = 1000


@dataclass(frozen=True, slots=True)
class EventRow:
    """One row of the table of events."""

    number: int
    time: str
    severity: str
    text: str
    style: str


@dataclass(frozen=True, slots=True)
class MessageRow:
    """One row of the table of messages."""

    name: str
    count: int
    rate: str
    bytes_per_s: str
    size: int


@dataclass(frozen=True, slots=True)
class ReportView:
    """The page, ready to print. ``facts``, ``links`` and ``parameters`` are names with their values."""

    title: str
    doc: str
    mood: str
    verdict: tuple[str, ...]
    facts: tuple[tuple[str, str], ...]
    summary: str
    charts: tuple[Chart, ...]
    levels: tuple[tuple[str, str], ...]
    has_faults: bool
    events: tuple[EventRow, ...]
    left_out: int
    messages: tuple[MessageRow, ...]
    total: MessageRow
    links: tuple[tuple[str, str], ...]
    parameters: tuple[tuple[str, str], ...]
    console: tuple[str, ...]


def write_report(path: str, simulation: Simulation, recording: Recording) -> None:
    """Write the page, whole or not at all. OSError: it cannot be written."""
    text = render_page("sim/report.html.j2", report_view(simulation, recording))
    folder = os.path.dirname(os.path.abspath(path))
    handle, temporary = tempfile.mkstemp(dir=folder, prefix=".report-", suffix=".html")
    try:
        with open(handle, "w", encoding="utf-8", errors="replace") as file:
            file.write(text)
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def report_view(simulation: Simulation, recording: Recording) -> ReportView:
    """The view of the page."""
    happened = recording.happenings
    listed = [happening for happening in happened if happening.kind is not Kind.CONSOLE]
    sentences = verdict(recording)
    wide = draw_chart(recording, listed, WIDE, "wide")
    return ReportView(
        title=simulation.scenario.name,
        doc=simulation.scenario.doc,
        mood=_mood(recording),
        verdict=tuple(sentences),
        facts=_facts(simulation, recording),
        summary=_summary(recording, sentences),
        charts=(wide, draw_chart(recording, listed, NARROW, "narrow")),
        levels=tuple((level.style, level.label) for level in wide.levels),
        has_faults=bool(wide.bands),
        events=tuple(_event_row(number, event) for number, event in enumerate(listed[:_MOST_ROWS], 1)),
        left_out=max(0, len(listed) - _MOST_ROWS) + recording.texts_left_out,
        messages=_message_rows(recording),
        total=_row("all", *_totals(recording), recording),
        links=_links(recording),
        parameters=tuple((name, f"{value:g}") for name, value in sorted(recording.parameters.items())),
        console=tuple(happening.text for happening in happened if happening.kind is Kind.CONSOLE),
    )


def _mood(recording: Recording) -> str:
    if recording.problem:
        return "failed"
    return "fired" if any(happening.kind is Kind.FAILSAFE for happening in recording.happenings) else "calm"


def _facts(simulation: Simulation, recording: Recording) -> tuple[tuple[str, str], ...]:
    sample = recording.sample
    speed = "as fast as it can" if not simulation.speed else f"{simulation.speed:g} times real time"
    return (
        ("Runtime", recording.runtime or str(simulation.runtime)),
        ("Simulated time", f"{seconds(recording.at_ms)} of {_planned(simulation)}"),
        ("Speed", "real time" if simulation.speed == 1 else speed),
        ("At the end", f"{'armed' if sample.is_armed else 'disarmed'}, {sample.state_name}"),
        ("Restarts", str(max(0, recording.starts - 1))),
    )


def _planned(simulation: Simulation) -> str:
    return "no limit" if simulation.duration_ms is None else seconds(simulation.duration_ms)


def _summary(recording: Recording, sentences: list[str]) -> str:
    """What somebody is told who does not see the chart."""
    scenario = recording.scenario
    start, end = (scenario.millivolts(at_ms) / 1000 for at_ms in (0, recording.at_ms))
    course = f"The true voltage goes from {start:.2f} V to {end:.2f} V in {seconds(recording.at_ms)}."
    return " ".join([course, *sentences])


def _event_row(number: int, event: Happening) -> EventRow:
    severity = "" if event.severity is None else _severity(event.severity)
    if event.kind is Kind.FAILSAFE or event.kind is Kind.STOPPED:
        style = "severe"
    else:
        style = "marked" if is_marked(event) else ""
    words = {Kind.ARMED: "Armed", Kind.DISARMED: "Disarmed", Kind.REBOOT: "Reboot"}
    text = event.text or words.get(event.kind, event.kind.value)
    if event.kind is Kind.REFUSED:
        text = f"Arming refused: {event.text}"
    return EventRow(number, seconds(event.at_ms), severity, text, style)


def _severity(number: int) -> str:
    return SEVERITIES[number] if 0 <= number < len(SEVERITIES) else str(number)


def _message_rows(recording: Recording) -> tuple[MessageRow, ...]:
    traffic = recording.traffic
    return tuple(
        _row(name, traffic.frames[name], traffic.sizes.get(name, 0), recording) for name in sorted(traffic.frames)
    )


def _totals(recording: Recording) -> tuple[int, int]:
    traffic = recording.traffic
    return sum(traffic.frames.values()), sum(traffic.sizes.values())


def _row(name: str, count: int, size: int, recording: Recording) -> MessageRow:
    length_s = max(recording.at_ms, 1) / 1000
    return MessageRow(name, count, f"{count / length_s:.2f}", f"{size / length_s:.1f}", size)


def _links(recording: Recording) -> tuple[tuple[str, str], ...]:
    traffic = recording.traffic
    return (
        ("Frames dropped by full or broken ports", str(traffic.dropped)),
        ("Gaps in the sequence of frames that went out", str(traffic.gaps)),
        ("Bytes received", str(traffic.received)),
        ("Damaged frames received (CRC)", str(traffic.crc_errors)),
        ("Control slots missed", str(recording.overruns)),
        ("Highest load of the control loop", f"{recording.peak_load / 10:.1f} %"),
    )
