"""``codegen build``: generate the output folder, or say what would become of it."""

import argparse
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from codegen.diagnostics import Report
    from codegen.emit.plan import Plan


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "build",
        parents=[common],
        help="generate the firmware, mocks, tests and documents",
        description="Generate the output folder. Files that are right already are not touched; a generated file that "
        "was edited by hand stops the build before anything is written.",
    )
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if a build would change anything")
    parser.add_argument("--diff", action="store_true", help="write nothing; print what would change as a patch")
    parser.add_argument("--dry-run", action="store_true", help="write nothing; list the files that would be written")
    parser.add_argument("--force", action="store_true", help="overwrite files that were edited by hand or are foreign")
    parser.add_argument("--clean", action="store_true", help="remove files that are no longer generated")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Do what the options ask for, and return the exit code."""
    nonsense = _nonsense(arguments)
    if nonsense:
        print(f"codegen build: {nonsense}", file=sys.stderr)
        return 2
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.diagnostics import Report

    project = project_file(arguments)
    if project is None:
        return report_no_project()
    report = Report()
    plan = _plan(arguments, project, report)
    if plan is None or arguments.check or arguments.diff or arguments.dry_run:
        print_findings(report)
        return report.exit_code if plan is None else _show(arguments, plan, report)
    outcome = None
    if not report.has_errors:
        from codegen.emit.write import write_output

        outcome = write_output(plan, report)
    print_findings(report)
    if outcome is not None:
        removed = f", {outcome.removed} removed" if outcome.removed else ""
        noun = "file" if outcome.written == 1 else "files"
        print(f"{outcome.written} {noun} written, {outcome.unchanged} unchanged{removed}", file=sys.stderr)
    return report.exit_code


def _nonsense(arguments: argparse.Namespace) -> str | None:
    """Why these options cannot go together, or None."""
    if arguments.dry_run and (arguments.check or arguments.diff):
        return "--dry-run lists what would be written; it does not go with --check or --diff"
    if arguments.check and (arguments.force or arguments.clean):
        return "--check compares and never writes; it does not go with --force or --clean"
    return None


def _plan(arguments: argparse.Namespace, project: str, report: "Report") -> "Plan | None":
    """Everything up to the comparison with the disk; None if it does not come so far, which is then reported."""
    from codegen import pipeline
    from codegen.emit.findings import report_refusals, report_stale, report_strays
    from codegen.emit.plan import plan_output

    system = pipeline.read_system(project, report)
    if system is None or report.has_errors:
        return None
    rendered = pipeline.render_system(system)
    folder = pipeline.output_folder(system)
    plan = plan_output(rendered, folder, report, force=arguments.force, clean=arguments.clean)
    if plan is None:
        return None
    if arguments.check:
        report_stale(plan, report)
    else:
        report_refusals(plan, report)
    report_strays(plan, report)
    return plan


def _show(arguments: argparse.Namespace, plan: "Plan", report: "Report") -> int:
    """Print what a build would do, after the findings, and return the exit code."""
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
