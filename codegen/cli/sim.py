"""``codegen sim``: run the generated firmware on this host against a scenario, talking MAVLink over UDP."""

import argparse
import math
import os
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from codegen.commands.sim import Wanted
    from codegen.diagnostics import Report
    from codegen.sim.run import Simulation

DEFAULT_TARGET = "udp:127.0.0.1:14550"
FOREVER = "forever"
_FASTEST = 10_000
_SLOWEST = 0.1


class UsageError(Exception):
    """An error of usage: the command cannot be run as it was given; the text is for the user."""


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
    from codegen.cli.progress import working
    from codegen.commands.sim import Unusable, prepare, read_project

    wanted = _wanted(arguments)
    with working("reading the specification"):
        known = read_project(wanted.scenario, project, report)
    if known is None:
        return None
    if known.faulty is not None:
        from codegen.source import shown_path

        print(f"codegen sim: warning: {shown_path(known.faulty)} has faults in other scenarios", file=sys.stderr)
    if arguments.list:
        width = max(map(len, known.scenarios), default=0)
        return [f"{name:{width}}  {scenario.doc}" for name, scenario in known.scenarios.items()]
    _check_files(arguments)
    with working("comparing the firmware with the specification"):
        prepared = prepare(wanted, known.systems, known.scenarios)
    if isinstance(prepared, Unusable):
        raise UsageError(prepared.why)
    _warn_of_stale(prepared.stale)
    _tell_without(prepared.without)
    return prepared.simulation


def _wanted(arguments: argparse.Namespace) -> "Wanted":
    from codegen.commands.sim import Wanted

    return Wanted(
        scenario=arguments.scenario,
        runtime=arguments.runtime,
        target=arguments.out,
        speed=_speed(arguments.speed),
        duration_ms=None if arguments.duration in (None, FOREVER) else _duration_ms(arguments.duration),
        is_whole=arguments.duration is None,
        flash=arguments.flash,
        links=tuple(arguments.link),
        code=arguments.code,
    )


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


def _warn_of_stale(modules: "Sequence[str]") -> None:
    if modules:
        names = ", ".join(modules[:3]) + (" ..." if len(modules) > 3 else "")
        print(f"codegen sim: warning: codegen build would change the firmware that runs now: {names}", file=sys.stderr)


def _tell_without(path: str | None) -> None:
    if path is not None:
        from codegen.source import shown_path

        told = f"there is no {shown_path(path)}: the generated vehicle runs, without code of yours"
        print(f"codegen sim: warning: {told}", file=sys.stderr)


def _check_files(arguments: argparse.Namespace) -> None:
    if arguments.code is not None and not os.path.isfile(arguments.code):
        raise UsageError(f"--code: there is no file {arguments.code}")
    if arguments.flash is not None and os.path.exists(arguments.flash) and not os.path.isdir(arguments.flash):
        raise UsageError(f"--flash: {arguments.flash} is not a folder")
    if arguments.record is not None and not arguments.record.endswith((".json", ".csv")):
        raise UsageError(f"--record: {arguments.record} ends neither with .json nor with .csv")
    if arguments.report is not None and not arguments.report.endswith((".html", ".htm", ".svg")):
        _check_written("--report", arguments.report)
        raise UsageError(f"--report: {arguments.report} ends neither with .html nor with .svg")
    _check_written("--report", arguments.report)
    _check_written("--record", arguments.record)


def _check_written(option: str, path: str | None) -> None:
    """Raise UsageError where a file could not be written in the end."""
    from codegen.cli.output import never_written

    why = None if path is None else never_written(path)
    if why is not None:
        raise UsageError(f"{option}: {why}")


def _run(simulation: "Simulation", arguments: argparse.Namespace) -> int:
    from codegen.cli.status import StatusLine, ended_by_signals, print_result
    from codegen.commands.sim import problems_of, simulated, write_results
    from codegen.sim.expected import unmet

    status = StatusLine(simulation, is_quiet=arguments.quiet)
    with ended_by_signals():
        try:
            recording = simulated(simulation, status.watch)
        except BrokenPipeError:
            raise  # whoever reads the output has gone
        except OSError as fault:
            status.clear()
            print(f"codegen sim: {fault}", file=sys.stderr)
            return 2
    status.clear()
    refused = write_results(simulation, recording, arguments.report, arguments.record)
    print_result(simulation, recording, None if arguments.report in refused else arguments.report)
    problems = problems_of(recording)
    print(end="", flush=True)
    for problem in problems:
        print(f"codegen sim: error: {problem}", file=sys.stderr)
    for path, why in refused.items():
        print(f"codegen sim: error: {path} cannot be written: {why}", file=sys.stderr)
    if refused:
        return 2
    return 1 if problems or unmet(recording) else 0
