"""Writing an output folder, or saying what would become of it: the same for every command that generates."""

import argparse
import sys
from collections.abc import Mapping

TYPE_CHECKING = False  # typing takes longer to import than --help may take
if TYPE_CHECKING:
    from codegen.diagnostics import Report
    from codegen.emit.plan import Plan

ARCHITECTURES = ("bytecode", "armv6m", "armv7m", "armv7emsp", "armv7emdp", "xtensawin", "rv32imc", "x64")
"""Targets of ``--mpy``: names of mpy-cross, and "bytecode" for every board.

An RP2040 takes armv6m, an RP2350 that or armv7emsp.
"""


def add_output_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that say what happens to the files of the output folder."""
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if anything would change")
    parser.add_argument("--diff", action="store_true", help="write nothing; print what would change as a patch")
    parser.add_argument("--dry-run", action="store_true", help="write nothing; list the files that would be written")
    parser.add_argument("--force", action="store_true", help="overwrite files that were edited by hand or are foreign")
    parser.add_argument("--clean", action="store_true", help="remove files that are no longer generated")
    add_format_option(parser)


def add_format_option(parser: argparse.ArgumentParser) -> None:
    """Add the option that says how findings are printed."""
    parser.add_argument(
        "--format",
        choices=("text", "json", "github", "sarif", "junit", "gitlab"),
        default="text",
        help="how findings are printed: for people, as JSON, as annotations of GitHub, as SARIF 2.1.0, as JUnit, for "
        "GitLab",
    )


def nonsense(arguments: argparse.Namespace) -> str | None:
    """Return why the options of add_output_options() cannot go together, or None."""
    if arguments.dry_run and (arguments.check or arguments.diff):
        return "--dry-run lists what would be written; it does not go with --check or --diff"
    if arguments.check and (arguments.force or arguments.clean):
        return "--check compares and never writes; it does not go with --force or --clean"
    if arguments.format != "text" and (arguments.diff or arguments.dry_run or getattr(arguments, "mpy", None)):
        return "--format is for the findings of one build; it does not go with --diff, --dry-run or --mpy"
    return None


def never_written(path: str) -> str | None:
    """Return why a file could not be written in the end, or None: what takes long asks before it begins."""
    import os

    if os.path.isdir(path):
        return f"{path} is a folder"
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder) or not os.access(folder, os.W_OK):
        return f"{folder} is not a folder that can be written to"
    return None


def is_plain(arguments: argparse.Namespace) -> bool:
    """Return whether none of the options of add_output_options() was given."""
    given = (arguments.check, arguments.diff, arguments.dry_run, arguments.force, arguments.clean)
    return not any(given) and arguments.format == "text"


def emit(
    rendered: Mapping[str, str | bytes] | None,
    folder: str,
    arguments: argparse.Namespace,
    report: "Report",
    vacated: tuple[str, ...] = (),
) -> int:
    """Do with ``rendered`` what the options ask for, print the findings, and return the exit code.

    Without ``rendered``, or after errors, there are only the findings. ``vacated`` is as plan_output() has it.
    """
    from codegen.cli.findings import print_findings

    plan = None if rendered is None or report.has_errors else _plan(rendered, folder, arguments, report, vacated)
    if plan is None or arguments.check or arguments.diff or arguments.dry_run:
        print_findings(report, arguments.format, shows_waived=False)
        return report.exit_code if plan is None else _show(arguments, plan, report)
    outcome = None
    if not report.has_errors:
        from codegen.emit.write import write_output

        outcome = write_output(plan, report)
    print_findings(report, arguments.format, shows_waived=False)
    if outcome is not None:
        removed = f", {outcome.removed} removed" if outcome.removed else ""
        noun = "file" if outcome.written == 1 else "files"
        done = f"{outcome.written} {noun} written, {outcome.unchanged} unchanged{removed}"
        print(done if outcome.written or removed else up_to_date(outcome.unchanged), file=sys.stderr)
    return report.exit_code


def up_to_date(count: int) -> str:
    """Return what a command says that had nothing to write."""
    return f"up to date: {count} {'file' if count == 1 else 'files'}"


def _plan(
    rendered: Mapping[str, str | bytes],
    folder: str,
    arguments: argparse.Namespace,
    report: "Report",
    vacated: tuple[str, ...],
) -> "Plan | None":
    """The comparison with the disk; None if the folder cannot be used, which is then reported."""
    from codegen.emit.findings import report_refusals, report_stale, report_strays
    from codegen.emit.plan import plan_output

    plan = plan_output(rendered, folder, report, force=arguments.force, clean=arguments.clean, vacated=vacated)
    if plan is None:
        return None
    if arguments.check:
        report_stale(plan, report)
    else:
        report_refusals(plan, report)
    report_strays(plan, report)
    return plan


def _show(arguments: argparse.Namespace, plan: "Plan", report: "Report") -> int:
    """Print what a run would do, after the findings, and return the exit code."""
    from codegen.emit.difference import differences
    from codegen.source import shown_path

    code = report.exit_code
    if arguments.diff:
        for patch in differences(plan):
            print(patch, end="")
            code = code or 1
    elif arguments.dry_run and not report.has_errors:
        for file in plan.writes:
            print(f"write {shown_path(plan.place(file.path).file)} ({file.change.value})")
        for file in plan.removals:
            print(f"remove {shown_path(plan.place(file.path).file)} ({file.change.value})")
    return code
