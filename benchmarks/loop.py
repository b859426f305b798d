# ruff: noqa: T201  what is printed is the answer
"""Measures the cost of each part of a pass of the main loop: counts passes, and writes codegen/loop/costs.json.

Instructions are counted as by cost.py, of single passes of several projects. Costs of one kind are fitted to all of
them by least squares of the relative errors; no cost is below 0. To be done again after each change of the main loop.
"""

import argparse
import json
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import cost
import measure
import results
from loop_plan import Counted, Plan
from whole_program import module_folders

from codegen.diagnostics import Report
from codegen.loop.costs import FILE
from codegen.loop.parts import Part, Work
from codegen.model.system import System
from codegen.project.systems import read_system

PROJECTS = results.ROOT / "tests" / "projects"
ROVER = results.ROOT
EVERYTHING = {
    "specs/board.yaml": (("BATT2_MONITOR: 0", "BATT2_MONITOR: 4"), ("samples: 5", "samples: 15")),
}
"""The changes in a copy of the rover, so that more is read."""
OTHERS = ("named_tables", "received", "watched_boat")
STAGES: tuple[tuple[str, tuple[str, ...], tuple[Part, ...]], ...] = (
    ("control alone", ("control",), (Part.PASS,)),
    ("jobs that do nothing", ("empty jobs",), (Part.JOBS, Part.JOB, Part.CALL)),
    ("links with nothing to do", ("links",), (Part.LINK,)),
    (
        "frames",
        ("frames",),
        (Part.STREAMS, Part.TABLE, Part.MESSAGE, Part.FRAME, Part.BYTE, Part.VALUE, Part.ENDING),
    ),
    ("further stations", ("stations",), (Part.STATION,)),
    ("a HEARTBEAT", ("heard",), (Part.HEARD,)),
    ("readings", ("readings",), (Part.COMPONENT, Part.READING, Part.SAMPLE)),
    ("failsafes", ("jobs",), (Part.WATCH, Part.FAILSAFE, Part.CONDITION, Part.REPORT, Part.REMINDER)),
)
"""The stages of the fit, one after another: name, rows, and fitted costs."""


@dataclass(frozen=True)
class Row:
    """A count of instructions for some work, in a project."""

    project: str
    name: str
    of: str
    work: Work
    instructions: int


def rows_of(project: str, plan: Plan, modules: Sequence[Path], folder: Path) -> list[Row]:
    """Count what a plan says with the modules of a project."""
    written = folder / f"{project}.json"
    written.write_text(json.dumps(plan.as_json()), encoding="utf-8")
    counts = cost.single_counts("cost_passes.py", str(written), modules, folder)
    rows = []
    for counted in plan.counted:
        found, sent = counts[counted.name]
        work = _as_sent(counted, sent)
        if work is not None:
            rows.append(Row(project, counted.name, counted.of, work, found - counts[counted.beyond][0]))
    return rows


def _as_sent(counted: Counted, sent: tuple[int, int]) -> Work | None:
    """Return the work with the frames that went out; None where a message was withheld."""
    frames, size = sent
    if counted.of == "stations":  # the frame is that of the pass beyond which they are counted
        return counted.work
    if counted.of != "frames":
        if frames:
            raise SystemExit(f"{counted.name}: {frames} frames went out as well")
        return counted.work
    if frames < counted.work[Part.FRAME]:
        return None
    return Work({**counted.work, Part.BYTE: size})


def fitted(
    rows: Iterable[Row], stages: Iterable[tuple[str, tuple[str, ...], tuple[Part, ...]]] = STAGES
) -> tuple[dict[Part, float], list[dict[str, object]]]:
    """Return the costs of all parts, and how well they fit."""
    costs: dict[Part, float] = {}
    fits: list[dict[str, object]] = []
    rows = list(rows)
    for name, kinds, parts in stages:
        mine = [row for row in rows if row.of in kinds]
        left = [(row.work, row.instructions - _known(row.work, costs), row.instructions) for row in mine]
        costs |= least_squares(left, parts)
        errors = [abs(_known(row.work, costs) / row.instructions - 1) for row in mine]
        fits.append({"of": name, "rows": len(mine), "error": round(max(errors), 3)})
    return costs, fits


def _known(work: Work, costs: Mapping[Part, float]) -> float:
    return sum(count * costs.get(part, 0) for part, count in work.items())


def least_squares(rows: Sequence[tuple[Work, float, float]], parts: Sequence[Part]) -> dict[Part, float]:
    """Return the costs of parts, none below 0, that fit best; a row has work, instructions, and what errors are of."""
    kept = [part for part in parts if any(work[part] for work, _, _ in rows)]
    while kept:
        weighed = [([work[part] / whole for part in kept], value / whole) for work, value, whole in rows]
        matrix = [
            [sum(row[i] * row[j] for row, _ in weighed) + (1e-12 if i == j else 0) for j in range(len(kept))]
            + [sum(row[i] * value for row, value in weighed)]
            for i in range(len(kept))
        ]
        found = dict(zip(kept, _solved(matrix), strict=True))
        below = min(found, key=lambda part: found[part])
        if found[below] >= 0:
            return {part: found.get(part, 0.0) for part in parts}
        kept.remove(below)
    return dict.fromkeys(parts, 0.0)


def _solved(matrix: list[list[float]]) -> list[float]:
    """Solve linear equations by Gauss's elimination, with the largest pivot."""
    size = len(matrix)
    for column in range(size):
        pivot = max(range(column, size), key=lambda row: abs(matrix[row][column]))
        matrix[column], matrix[pivot] = matrix[pivot], matrix[column]
        for row in range(size):
            if row != column:
                factor = matrix[row][column] / matrix[column][column]
                matrix[row] = [a - factor * b for a, b in zip(matrix[row], matrix[column], strict=True)]
    return [matrix[row][size] / matrix[row][row] for row in range(size)]


def system_of(folder: Path) -> System:
    """Read the system of a project."""
    report = Report()
    system = read_system(str(folder / "specs" / "codegen.yaml"), report)
    if system is None:
        raise SystemExit(f"{folder}: {report.diagnostics}")
    return system


def rover_plan(system: System, *, whole: bool = True) -> Plan:
    """Return what is counted of the rover."""
    assert system.program is not None
    plan = Plan(system, system.program)
    plan.count_passes()
    plan.count_heard()
    plan.count_messages()
    plan.count_readings()
    if whole:
        plan.count_stations()
        plan.count_jobs()
    return plan


def counted_rows(folder: Path) -> list[Row]:
    """Build the projects, and count them all."""
    rows: list[Row] = []
    for name, source, changes in (
        ("rover", ROVER, {}),
        ("more", ROVER, EVERYTHING),
        *((each, PROJECTS / each, {}) for each in OTHERS),
    ):
        project = folder / name
        measure.project(source, project, changes)
        system = system_of(project)
        assert system.program is not None
        plan = rover_plan(system, whole=name == "rover")
        rows += rows_of(name, plan, module_folders(project / "generated", "firmware", "mocks"), folder)
    return rows


def sensor_costs(folder: Path) -> dict[Part, float]:
    """Return what sensors take, as cost_sources.py counts them."""
    project = folder / "sensors"
    measure.project(PROJECTS / "sensors", project)
    modules = module_folders(project / "generated", "firmware", "mocks")
    costs, _ = cost.instructions("cost_sources.py", 0, modules, folder)
    sensors = len(system_of(project).polled)
    nothing, one = costs["nothing"], costs["no_sensor"]
    return {
        Part.SENSOR: (costs["every_sensor"] - one) / sensors,
        Part.SENSORS: one - nothing,
        Part.TURN: costs["turn"] - nothing,
    }


def main() -> None:
    """Count, fit, and write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", action="store_true", help="print each row that was counted, and what the costs say")
    arguments = parser.parse_args()
    if cost.problem():
        raise SystemExit(cost.problem())
    with measure.scratch() as folder:
        rows = counted_rows(folder)
        sensors = sensor_costs(folder)
    costs, fits = fitted(rows)
    costs |= sensors
    if arguments.rows:
        for row in rows:
            told = round(_known(row.work, costs))
            print(f"{row.project:13} {row.name:18} {row.instructions:8} {told:8}", dict(row.work))
    content = {
        "measured_by": "benchmarks/loop.py",
        "micropython": results.read_versions()["MicroPython"],
        "parts": {part.value: round(costs[part]) for part in Part if part is not Part.CONVERSION},
        "fits": fits,
    }
    Path(FILE).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    json.dump(content, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
