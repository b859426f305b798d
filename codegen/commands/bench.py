"""The way of the data for ``codegen bench``: what a board has to know, what it measures, what the results are about."""

import json
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from codegen.model.system import System
from codegen.targets.suite.facts.bench import bench_facts, bench_inputs

if TYPE_CHECKING:
    from codegen.deploy.board import Board
    from codegen.deploy.connection import Connection
    from codegen.deploy.prepared import Prepared
    from codegen.diagnostics import Report
    from codegen.model.bench_record import BenchRecord


def bench_inputs_of(systems: Iterable[System]) -> dict[tuple[str, str], str]:
    """Return by project and program the hash of the specification that results of `codegen bench` have to be about."""
    return {(each.spec.project.project, each.spec.program): bench_inputs(each) for each in systems}


def is_deployed(prepared: "Prepared", port: str, report: "Report") -> bool:
    """Return whether a board has what the specification makes now; where it has not, a finding says so."""
    from codegen.deploy.bench import NOT_DEPLOYED
    from codegen.source import Place

    if prepared.plan.is_empty:
        return True
    names = [*prepared.plan.copies, *(each.path for each in prepared.plan.removals)]
    others = f" and {len(names) - 1} more" if len(names) > 1 else ""
    message = f"the board has not what the specification makes now: {names[0]}{others}"
    report.add(NOT_DEPLOYED, Place(port), message, "codegen deploy")
    return False


def measure(
    connection: "Connection",
    board: "Board",
    system: System,
    prepared: "Prepared",
    seconds: float,
    now: Callable[[str], None],
) -> "BenchRecord":
    """Run the self-test on a board that has the program; its main loop runs for some ``seconds``.

    ``now`` is told the name of each step before it begins.
    """
    from codegen.deploy.bench import measured, prepare_bench, record_of, steps

    facts = bench_facts(system)
    prepare_bench(connection, facts)
    lines: list[list[object]] = []
    for name, call in steps(facts, seconds):
        now(name)
        lines += _lines(connection.run(call))
    found = measured(iter(lines), seconds, has_loop=bool(facts["program"]))
    spec = system.spec
    about = {"project": spec.project.project, "program": spec.program, "inputs": bench_inputs(system)}
    return record_of(board, about, found, prepared.files, own_ports=bool(facts["own_ports"]))


def _lines(printed: str) -> list[list[object]]:
    """Return what the self-test has printed, among what the program may print."""
    return [json.loads(line) for line in printed.splitlines() if line.startswith('["')]
