"""The cost of the old and the new battery messages on the same flight: bytes per second, with BATT_REPORT 0, 1 and 2.

`python benchmarks/battery_generations.py [SCENARIO]` runs a scenario of the project through the simulation, as fast as
it can, once with each value of the parameter, and prints a table. The simulation goes by its own clock, so that every
run gives the same numbers. The frames go to this program, which counts nothing: the counts are the firmware's.
"""

import argparse
import socket
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from codegen.diagnostics import Report
from codegen.model.scenario import Scenario, Swap
from codegen.model.system import System
from codegen.project.systems import folders_of, read_scenarios, read_systems, scenarios_path
from codegen.sim.address import Address
from codegen.sim.process import Runtime, find_interpreter
from codegen.sim.program import simulated_programs
from codegen.sim.run import Simulation, simulate

PROJECT = Path(__file__).resolve().parents[1] / "specs" / "codegen.yaml"
PARAMETER = "BATT_REPORT"
REPORTS = {0: "old", 1: "new", 2: "both"}
OLD = ("BATTERY_STATUS", "SMART_BATTERY_INFO")
NEW = ("BATTERY_STATUS_V2", "BATTERY_INFO", "BATTERY_CELL_VOLTAGES")

Rates = Mapping[str, float]
"""Bytes per second by message."""


def measured(scenario: Scenario, system: System, value: int, port: int) -> Rates:
    """The bytes per second of each message with one value of the parameter."""
    interpreter = find_interpreter(Runtime.MICROPYTHON)
    if interpreter is None:
        raise SystemExit("micropython is not installed: make build does it")
    chosen = replace(scenario, parameters={**scenario.parameters, PARAMETER: float(value)}, beside=())
    chosen = replace(chosen, events=tuple(event for event in chosen.events if not isinstance(event, Swap)))
    folders = {"": folders_of(system)}
    simulation = Simulation(
        scenario=chosen,
        duration_ms=chosen.duration_ms,
        speed=0.0,
        runtime=Runtime.MICROPYTHON,
        interpreter=interpreter,
        to=Address("127.0.0.1", port, ""),
        flash=None,
        programs=simulated_programs(chosen, [system], folders, None),
    )
    recording = simulation.recording()
    simulate(simulation, recording, lambda *_: None)
    if recording.problem:
        raise SystemExit(f"{PARAMETER} {value}: {recording.problem}")
    length_s = recording.at_ms / 1000
    return {name: size / length_s for name, size in recording.traffic.sizes.items()}


def table(rates: Mapping[int, Rates]) -> Iterator[str]:
    """The lines of the table: the messages of batteries, their sum, everything, and what new costs against old."""
    names = [name for name in (*OLD, *NEW) if any(name in each for each in rates.values())]
    width = max(map(len, (*names, "battery messages")))
    yield f"{'bytes/s':{width}}" + "".join(f"{REPORTS[value]:>10}" for value in rates)
    for name in names:
        yield f"{name:{width}}" + "".join(f"{each.get(name, 0):10.1f}" for each in rates.values())
    sums = {value: sum(each.get(name, 0) for name in (*OLD, *NEW)) for value, each in rates.items()}
    yield f"{'battery messages':{width}}" + "".join(f"{size:10.1f}" for size in sums.values())
    yield f"{'all messages':{width}}" + "".join(f"{sum(each.values()):10.1f}" for each in rates.values())
    if sums.get(0) and 1 in sums:
        yield f"new/old: {sums[1] / sums[0]:.2f}"


@contextmanager
def listening() -> Iterator[int]:
    """A port of this host that datagrams can be sent to."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as opened:
        opened.bind(("127.0.0.1", 0))
        number: int = opened.getsockname()[1]
        yield number


def main(argv: Sequence[str] | None = None) -> int:
    """Run and print; the exit code."""
    parser = argparse.ArgumentParser(description="bytes per second of the old and the new battery messages")
    parser.add_argument("scenario", nargs="?", default="nominal")
    parser.add_argument("--project", default=str(PROJECT))
    arguments = parser.parse_args(argv)
    report = Report()
    systems = read_systems(arguments.project, report)
    scenarios = read_scenarios(scenarios_path(arguments.project), systems, report)
    if report.has_errors or not scenarios or arguments.scenario not in scenarios:
        raise SystemExit(f"{arguments.project}: no scenario {arguments.scenario!r}, or errors: run codegen check")
    if PARAMETER not in systems[0].parameters:
        raise SystemExit(f"{arguments.project} has no parameter {PARAMETER}")
    with listening() as port:
        rates = {value: measured(scenarios[arguments.scenario], systems[0], value, port) for value in REPORTS}
    seconds = scenarios[arguments.scenario].duration_ms / 1000
    sys.stdout.write("\n".join([f"{arguments.scenario}, {seconds:g} s", *table(rates)]) + "\n")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
