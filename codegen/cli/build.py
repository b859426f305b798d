"""``codegen build``: generate the output folder, or say what would become of it."""

import argparse
import sys
import time

from codegen.cli.depfile import add_depfile_options, depfile_nonsense, write_depfile
from codegen.cli.output import ARCHITECTURES, add_output_options, is_plain, nonsense, up_to_date

TYPE_CHECKING = False  # typing takes longer to import than --help may take
if TYPE_CHECKING:
    from typing import Any


def add_command(commands: "Any", common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "build",
        parents=[common],
        description="Generate the output folder. Files that are right already are not touched; a generated file that "
        "was edited by hand stops the build before anything is written.",
    )
    add_output_options(parser)
    parser.add_argument(
        "--mpy",
        metavar="ARCH",
        choices=ARCHITECTURES,
        help="compile the firmware for a board too, into build/ARCH beside the specification's folder: "
        + ", ".join(ARCHITECTURES),
    )
    add_depfile_options(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Do what the options ask for, and return the exit code."""
    fault = nonsense(arguments) or depfile_nonsense(arguments)
    if fault:
        print(f"codegen build: {fault}", file=sys.stderr)
        return 2
    from codegen.cli.project import project_file, report_no_project

    project = project_file(arguments)
    if project is None:
        return report_no_project()
    from codegen.emit import stamp
    from codegen.project.output import stated_output

    started = time.time()
    stated = stated_output(project) if is_plain(arguments) else None
    kept = stamp.unchanged(project, stated) if stated is not None and arguments.mpy is None else None
    if stated is not None and kept is not None:
        print(up_to_date(kept), file=sys.stderr)
        return 0 if arguments.depfile is None else write_depfile(arguments, stamp.read_last_time(project, stated))
    from codegen.cli.output import emit
    from codegen.cli.progress import working
    from codegen.commands.build import board_folder, compile_systems, render_systems, what_is_made
    from codegen.diagnostics import Report
    from codegen.project.systems import check_scenarios, files_read, folders_read, output_folder, read_systems

    report = Report()
    with working("reading the specification") as now:
        systems = read_systems(project, report)
        system = systems[0] if systems else None
        check_scenarios(project, systems, report)
        now("rendering what is generated")
        output = None if system is None or report.has_errors else render_systems(systems)
    if system is None or output is None:
        return emit(None, "", arguments, report)
    folder = output_folder(system)
    code = emit(output.files, folder, arguments, report, output.vacated)
    read, beside = files_read(systems), folders_read(systems)
    if folder == stated and not list(report):
        stamp.keep(project, started, read, folder, output.files, beside)
    if arguments.mpy is not None and not code:
        compiled = Report()
        with working(f"compiling the firmware for {arguments.mpy}"):
            boards = compile_systems(systems, arguments.mpy, compiled)
        code = emit(boards, board_folder(system, arguments.mpy), arguments, compiled, ("",))
    if not code and not (arguments.check or arguments.diff or arguments.dry_run):
        print("".join(f"{line}\n" for line in what_is_made(systems)), end="", file=sys.stderr)
    if arguments.depfile is None or code:
        return code
    return write_depfile(arguments, stamp.everything_read(project, read, beside))
