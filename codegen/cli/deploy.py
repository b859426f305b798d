"""``codegen deploy``: bring the program to a board over USB, and show what it says."""

import argparse
import math
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping

    from codegen.deploy.board import Board
    from codegen.deploy.connection import Connection
    from codegen.deploy.plan import Plan
    from codegen.deploy.prepared import Prepared
    from codegen.diagnostics import Report
    from codegen.model.system import System

LOG_S = 5.0
MOST_LOG_S = 86400


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "deploy",
        parents=[common],
        description="Compile the program for the board that is connected, copy what changed, start it, and show what "
        "it says. Where it was cut off, the next deploy goes on. Stored parameters, keys and the Wi-Fi's file stay.",
    )
    add_board_options(parser)
    parser.add_argument("--dry-run", action="store_true", help="only say what would be done")
    parser.add_argument(
        "--image",
        metavar="FILE",
        help="write the compiled program as the image of a ROMFS, for a board whose MicroPython has one, and end: no "
        "board is asked",
    )
    parser.add_argument(
        "--wifi",
        metavar="FILE",
        help='copy this JSON as the file that the link names: {"ssid": "...", "password": "..."}',
    )
    parser.add_argument(
        "--log",
        metavar="S",
        type=_log_seconds,
        help=f"for how many seconds to show what the program prints, 0 for not at all (default: {LOG_S:g})",
    )
    parser.set_defaults(run=run)


def _log_seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not 0 <= seconds <= MOST_LOG_S:
        raise argparse.ArgumentTypeError(f"{text} is not a number of seconds from 0 to {MOST_LOG_S}")
    return seconds


def port_name(text: str) -> str:
    """Return the port that an option names."""
    if not text.strip():
        raise argparse.ArgumentTypeError("the name of the port is empty")
    return text


def add_board_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that name the board and the program: ``deploy`` and ``bench`` ask for both."""
    parser.add_argument(
        "--port",
        metavar="P",
        type=port_name,
        help="serial port, such as /dev/ttyACM0 or COM3 (default: the only board)",
    )
    parser.add_argument("--program", metavar="NAME", default="", help="a further program of the project")
    parser.add_argument(
        "--force", action="store_true", help="also where the board has another chip than that of board.yaml"
    )


def run(arguments: argparse.Namespace) -> int:
    """Do it, and return the exit code."""
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.commands.deploy import wifi_of, write_image
    from codegen.deploy.findings import BoardFaultError
    from codegen.diagnostics import Report

    given = ["dry-run"] if arguments.dry_run else []
    given += [option for option in ("port", "wifi", "log") if getattr(arguments, option) is not None]
    if arguments.image is not None and given:
        print(f"codegen deploy: --image asks no board; --{given[0]} does not go with it", file=sys.stderr)
        return 2
    project = project_file(arguments)
    if project is None:
        return report_no_project()
    report = Report()
    system = chosen_system("deploy", project, arguments.program, report)
    if isinstance(system, int):
        return system
    if arguments.image is not None:
        path = arguments.image
        if write_image(path, system, project, report):
            print(
                f"{path} written: mpremote romfs deploy {path}, and main.py beside it by mpremote cp", file=sys.stderr
            )
        print_findings(report)
        return report.exit_code
    wifi = None if arguments.wifi is None else wifi_of(arguments.wifi, system, report)
    if report.has_errors:
        print_findings(report)
        return report.exit_code
    port = arguments.port or project
    try:
        from codegen.deploy.connection import Connection, find_port

        port = find_port(arguments.port)
        connection = Connection(port)
        try:
            _deploy(connection, system, arguments, wifi, report)
        finally:
            connection.close()
    except BoardFaultError as fault:
        fault.tell(port, report)
    print_findings(report)
    return report.exit_code


def chosen_system(command: str, project: str, program: str, report: "Report") -> "System | int":
    """The system of a program, or the exit code where there is none, after saying why."""
    from codegen.cli.findings import print_findings
    from codegen.diagnostics import did_you_mean
    from codegen.project.systems import read_systems

    systems = {system.spec.program: system for system in read_systems(project, report)}
    if report.has_errors or not systems:
        print_findings(report)
        return report.exit_code or 2
    if program not in systems:
        hint = did_you_mean(program, [name for name in systems if name]) or "this project has one program"
        print(f"codegen {command}: --program: there is no {program} ({hint})", file=sys.stderr)
        return 2
    return systems[program]


def _deploy(
    connection: "Connection",
    system: "System",
    arguments: argparse.Namespace,
    wifi: tuple[str, bytes] | None,
    report: "Report",
) -> None:
    from codegen.cli.progress import working
    from codegen.deploy.transfer import put, transfer

    board, prepared = looked_at(connection, system, report, is_forced=arguments.force)
    if prepared is None:
        connection.restart()  # the board goes on with the program that it has
        return
    todo = prepared.plan
    if arguments.dry_run:
        for line in _would_do(todo, wifi):
            print(line)
        connection.restart()
        return
    if not todo.is_empty:
        steps = len(todo.removals) + len(todo.copies)
        with working("looking at the board") as now:
            for count, step in enumerate(transfer(connection, prepared.files, todo, prepared.owned), 1):
                now(f"{count}/{steps} {step}")
    for each in todo.removals:
        if each.kept:
            print(f"{each.path} was not codegen's: it is {each.kept} now", file=sys.stderr)
    if wifi is not None:
        put(connection, *wifi)
        print(f"{wifi[0]} copied", file=sys.stderr)
    print(_summary(todo), file=sys.stderr)
    connection.restart()
    _show_log(
        connection, system, LOG_S if arguments.log is None else arguments.log, board, prepared.short_names, report
    )


def looked_at(
    connection: "Connection", system: "System", report: "Report", *, is_forced: bool
) -> "tuple[Board, Prepared | None]":
    """Say which board it is; return it with what a deploy would do there, None after a finding."""
    from codegen.cli.progress import working
    from codegen.commands.deploy import prepared_for
    from codegen.deploy.transfer import identified

    board = identified(connection)
    print(f"{board.words} ({connection.port})", file=sys.stderr)
    if board.roms:
        print("it has a ROMFS, from which the program takes less heap: codegen deploy --image FILE", file=sys.stderr)
    with working("compiling, and looking what the board has"):
        return board, prepared_for(connection, board, system, report, is_forced=is_forced)


def _would_do(todo: "Plan", wifi: tuple[str, bytes] | None) -> list[str]:
    lines = [
        f"keep {each.path} as {each.kept}: it {each.why}" if each.kept else f"remove {each.path}: it {each.why}"
        for each in todo.removals
    ]
    lines += [f"copy {path}" for path in todo.copies]
    return lines + ([f"copy {wifi[0]}"] if wifi else [])


def _summary(todo: "Plan") -> str:
    if todo.is_empty:
        return f"up to date: {todo.unchanged} files"
    gone = [each for each in todo.removals if each.path not in todo.copies and not each.kept]
    removed = f", {len(gone)} removed" if gone else ""
    return f"{len(todo.copies)} files copied, {todo.unchanged} unchanged{removed}"


def _show_log(
    connection: "Connection",
    system: "System",
    seconds: float,
    board: "Board",
    names: "Mapping[str, Mapping[str, str]]",
    report: "Report",
) -> None:
    """Print what the program says; an exception is a finding, whether the program ends with it or not."""
    from codegen.deploy.findings import PROGRAM_ENDED
    from codegen.emit.short_names import readable
    from codegen.source import Place

    if any(link.spec.usb for link in system.links):
        print("the USB port is a link now: there is no log to see", file=sys.stderr)
        return
    is_traced, raised, is_over = False, "", False
    for line in connection.said(seconds):
        print(readable(line, names), flush=True)
        if line.startswith("Traceback (most recent call last)"):
            is_traced = True
        elif is_traced and not raised and line.strip() and not line.startswith(" "):
            raised = line
        is_over = is_over or (is_traced and line.startswith(("MicroPython v", ">>>")))
    if raised:
        said = "the program ended" if is_over else "an exception, with which the program runs on"
        report.add(PROGRAM_ENDED, Place(connection.port), f"{said}: {raised}", f"it runs on {board.machine}")
