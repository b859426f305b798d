"""``codegen bench``: run the self-test of the program on the board that has it, and write down what was measured."""

import argparse
import sys
from typing import TYPE_CHECKING, Any

from codegen.cli.deploy import add_board_options, chosen_system, looked_at
from codegen.cli.output import never_written

if TYPE_CHECKING:
    from codegen.deploy.connection import Connection
    from codegen.diagnostics import Report
    from codegen.model.bench_record import BenchRecord
    from codegen.model.system import System

RUN_S = 10.0
OUT = "bench.json"


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "bench",
        parents=[common],
        description="Run the self-test of the program on the board that codegen deploy has brought it to: times, heap, "
        "missed control slots, noise of the converter. The file that it writes is evidence for codegen trace "
        "--results. The program runs meanwhile as it does always: wheels off the ground.",
    )
    add_board_options(parser)
    parser.add_argument(
        "--seconds",
        metavar="S",
        type=float,
        default=RUN_S,
        help=f"for how many seconds the main loop runs (default: {RUN_S:g})",
    )
    parser.add_argument("--out", metavar="FILE", default=OUT, help=f"where the results go (default: {OUT})")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Do it, and return the exit code."""
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.deploy.bench import bench_text
    from codegen.deploy.findings import BoardFaultError
    from codegen.diagnostics import Report
    from codegen.emit.file import write_file

    if not 0 < arguments.seconds <= 3600:
        print("codegen bench: --seconds is more than 0 and at most 3600", file=sys.stderr)
        return 2
    if arguments.out.endswith(".json"):
        why = never_written(arguments.out)
    else:
        why = f"{arguments.out} does not end with .json, by which codegen trace knows such results"
    if why is not None:
        print(f"codegen bench: --out: {why}", file=sys.stderr)
        return 2
    project = project_file(arguments)
    if project is None:
        return report_no_project()
    report = Report()
    system = chosen_system("bench", project, arguments.program, report)
    if isinstance(system, int):
        return system
    port, record = arguments.port or project, None
    try:
        from codegen.deploy.connection import Connection, find_port

        port = find_port(arguments.port)
        connection = Connection(port)
        try:
            record = _bench(connection, system, arguments, report)
            connection.restart()
        finally:
            connection.close()
    except BoardFaultError as fault:
        fault.tell(port, report)
    if record is not None:
        _show(record)
        if write_file(arguments.out, bench_text(record), report):
            print(f"written to {arguments.out}", file=sys.stderr)
    print_findings(report)
    return report.exit_code


def _bench(
    connection: "Connection", system: "System", arguments: argparse.Namespace, report: "Report"
) -> "BenchRecord | None":
    """Say what is done meanwhile, and return what was measured; None after a finding."""
    from codegen.cli.progress import working
    from codegen.commands.bench import is_deployed, measure

    board, prepared = looked_at(connection, system, report, is_forced=arguments.force)
    if prepared is None or not is_deployed(prepared, connection.port, report):
        return None
    with working("measuring on the board") as now:
        return measure(connection, board, system, prepared, arguments.seconds, now)


def _show(record: "BenchRecord") -> None:
    """Print the measures as a table."""
    width = max(map(len, record.measures), default=0)
    for name, value in record.measures.items():
        print(f"{name:<{width}}  {value:>12,.{0 if value == int(value) else 1}f}")
    for text in record.told:
        print(f"note: {text}")
