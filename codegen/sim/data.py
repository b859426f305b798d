"""The record of a simulation as data: JSON with all of it, or CSV with the quantities, by name and unit."""

import csv
import io
import json
from collections.abc import Iterator
from typing import Any

from codegen.sim.record import Recording
from codegen.sim.verdict import verdict
from codegen.sim.written import write_whole


def write_data(path: str, recording: Recording) -> None:
    """Write the file, whole or not at all, in the format of its name. OSError: it cannot be written."""
    write_whole(path, csv_text(recording) if path.endswith(".csv") else json_text(recording))


def json_text(recording: Recording) -> str:
    """The whole record: times in ms of the scenario, numbers in the units of their quantities."""
    return (
        json.dumps(
            {
                "scenario": recording.scenario.name,
                "runtime": recording.runtime,
                "length_ms": recording.at_ms,
                "verdict": verdict(recording),
                "quantities": list(_quantities(recording)),
                "happenings": [
                    {
                        "at_ms": each.at_ms,
                        "program": each.program,
                        "kind": each.kind.value,
                        "text": each.text,
                        "severity": each.severity,
                        "quantity": each.of or None,
                    }
                    for each in recording.happenings
                ],
                "messages": {
                    record.program.name: {
                        name: {"frames": count, "bytes": record.traffic.sizes.get(name, 0)}
                        for name, count in sorted(record.traffic.frames.items())
                    }
                    for record in recording.all
                },
            },
            indent=1,
            ensure_ascii=False,
        )
        + "\n"
    )


def csv_text(recording: Recording) -> str:
    """A row for each number that was told, with what was true then; a cell is empty where it is not known."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(("at_ms", "program", "quantity", "unit", "true", "told"))
    for record in recording.all:
        for line in record.lines:
            for reading in record.readings_of.get(line.label, ()):
                true = record.true(line.label, reading.at_ms)
                rows.writerow((reading.at_ms, record.program.name, line.label, line.unit, true, reading.value))
    return text.getvalue()


def _quantities(recording: Recording) -> Iterator[dict[str, Any]]:
    for record in recording.all:
        for line in record.lines:
            yield {
                "name": line.label,
                "program": record.program.name,
                "unit": line.unit,
                "course": [
                    [point.at_ms, point.value]
                    for stretch in record.stretches
                    if (course := stretch.course(line.label)) is not None
                    for point in course.points
                ],
                "told": [[reading.at_ms, reading.value] for reading in record.readings_of.get(line.label, ())],
            }
