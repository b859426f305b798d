"""The projects whose heap is measured: those of this repository with a program, and drawn ones, some of them large."""

import shutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import measure
from population.answer import Answer
from population.answers import answer, refused
from population.fields import Message, read_messages
from population.project import write_project
from pymavlink.dialects.v20 import common

from codegen.diagnostics import Report
from codegen.model.program import RECEIVED, SENT
from codegen.model.system import System
from codegen.project.systems import read_systems

PROJECTS = measure.ROOT / "tests" / "projects"
OTHERS = (
    *("angles", "commanded", "flagged", "guarded", "moored_buoy", "named_tables", "networked", "own_dialect"),
    *("radio_rover", "received", "sensors", "slow_readings", "watched_boat"),
)
VEHICLE = (
    "control: {rate: 50 Hz, links: 50 Hz, report_every: 5 s}\n"
    "storage: {files: [settings.a, settings.b], chunk: 200, step_limit: 20 ms}\n"
    "services: {fastest: 10 Hz}\n"
)
HEARTBEAT = (
    "message: HEARTBEAT\nrequirement: FR-1.1\nstream: ALL\nfields:\n"
    "  type: {enum: MAV_TYPE_GENERIC}\n  autopilot: {enum: MAV_AUTOPILOT_INVALID}\n  base_mode: {flags: []}\n"
    "  custom_mode: {constant: 0}\n  system_status: {enum: MAV_STATE_ACTIVE}\n  mavlink_version: {dialect: version}\n"
)
PARAMETER = "type: {kind}, default: 1, min: 0, max: 100, step: 1, requirement: FR-1.1"
STATE = "components:\n  lab:\n    doc: A laboratory.\n    quantities:\n      level: {doc: A level., unit: m}\n"
KINDS = ("uint8", "int16", "real32", "uint32")


@dataclass(frozen=True)
class Drawn:
    """A project that is drawn by lot: so many tables of messages sent, of received ones, and so many parameters."""

    sent: int
    received: int
    parameters: int
    seed: int = 1

    @property
    def name(self) -> str:
        """Its name among the others."""
        return f"{self.sent}-{self.received}-{self.parameters}-{self.seed}"


DRAWN = (
    *(Drawn(0, 0, 0), Drawn(0, 0, 100), Drawn(0, 0, 250)),
    *(Drawn(10, 0, 0), Drawn(30, 0, 0), Drawn(74, 0, 0), Drawn(30, 0, 0, 2)),
    *(Drawn(10, 10, 0), Drawn(30, 30, 0), Drawn(30, 30, 0, 3), Drawn(74, 42, 249, 4)),
)


def shipped() -> Iterator[tuple[str, Path]]:
    """Yield the projects of this repository by their names: the folders that have their specs."""
    yield "rover", measure.ROOT
    yield "boat", measure.ROOT / "examples" / "boat"
    for name in OTHERS:
        yield name, PROJECTS / name


def systems_of(folder: Path) -> tuple[System, ...]:
    """Return the programs of a project."""
    report = Report()
    systems = read_systems(str(folder / "specs" / "codegen.yaml"), report)
    if not systems or report.has_errors:
        raise SystemExit("\n".join(f"{each.place.shown()}: {each.rule.id}: {each.message}" for each in report))
    return systems


def draw(project: Drawn, folder: Path) -> System:
    """Write the specification of a drawn project, without what the generator refuses; return its system."""
    messages = read_messages("common", common)
    names = [name for name in sorted(messages) if name not in {"HEARTBEAT", *SENT, *RECEIVED}]
    step = len(names) / max(1, project.sent)
    chosen = [messages[names[int(number * step)]] for number in range(project.sent)]
    tables = {message.name: answer(message, project.seed) for message in chosen}
    left_out: set[tuple[str, str]] = set()
    while True:
        shutil.rmtree(folder, ignore_errors=True)
        places = write_project(folder, "common", tables)
        received = dict(_received(project, chosen, tables, left_out))
        _write_program(project, folder / "specs", received)
        report = Report()
        systems = read_systems(str(folder / "specs" / "codegen.yaml"), report)
        errors = [each for each in report if each.is_error]
        if systems and not errors:
            return systems[0]
        before = len(left_out), sum(each.kind == "fixed" for answers in tables.values() for each in answers)
        for error in errors:
            path = Path(error.place.file).relative_to(folder.resolve() / "specs")
            about = places.get((path.as_posix(), error.place.line))
            if about is not None:
                tables = {
                    name: [refused(each) if each.label == about.label else each for each in answers]
                    for name, answers in tables.items()
                }
            elif path.parent.name == "receives":
                line = (folder / "specs" / path).read_text().splitlines()[error.place.line - 1]
                left_out.add((path.stem, line.partition(":")[0].strip()))
        after = len(left_out), sum(each.kind == "fixed" for answers in tables.values() for each in answers)
        if before == after:
            raise SystemExit("\n".join(f"{each.place.shown()}: {each.rule.id}: {each.message}" for each in errors))


def _received(
    project: Drawn, chosen: Sequence[Message], tables: Mapping[str, Sequence[Answer]], left_out: set[tuple[str, str]]
) -> Iterator[tuple[str, list[str]]]:
    """Yield the fields of received tables: each goes back into the quantity that tells it."""
    for message in chosen[:: max(1, len(chosen) // max(1, project.received))][: project.received]:
        fields = [
            f"  {each.key}: {each.written}"
            for each in tables[message.name]
            if each.kind == "number" and each.quantity and (message.name.lower(), each.key) not in left_out
        ]
        if fields:
            yield message.name, list(dict.fromkeys(fields))


def _write_program(project: Drawn, specs: Path, received: Mapping[str, Sequence[str]]) -> None:
    (specs / "vehicle.yaml").write_text(VEHICLE)
    if not project.sent:
        (specs / "state.yaml").write_text(STATE)
    (specs / "messages" / "heartbeat.yaml").write_text(HEARTBEAT)
    (specs / "board.yaml").write_text("board: esp32_s3_psram\nlinks:\n  radio: {uart: 1, tx: 4, rx: 5, baud: 57600}\n")
    lines = [
        f"  LAB_P{number}: {{doc: P., {PARAMETER.format(kind=KINDS[number % len(KINDS)])}}}"
        for number in range(project.parameters)
    ]
    (specs / "parameters.yaml").write_text("parameters:\n" + "\n".join(lines) + "\n" if lines else "parameters: {}\n")
    (specs / "receives").mkdir(exist_ok=True)
    for name, fields in received.items():
        text = "\n".join((f"receive: {name}", "requirement: FR-1.1", "fields:", *fields, ""))
        (specs / "receives" / f"{name.lower()}.yaml").write_text(text)
