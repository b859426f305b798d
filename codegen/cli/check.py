"""``codegen check``: what is wrong with the specification."""

import argparse
from typing import Any


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "check",
        parents=[common],
        help="check the specification against the dialect and the documents",
        description="Check the specification against the dialect and the requirement documents.",
    )
    parser.add_argument(
        "--format",
        choices=("text", "json", "github", "sarif"),
        default="text",
        help="how findings are printed: for people, as JSON, as annotations of GitHub, as SARIF 2.1.0",
    )
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print what was found, and return the exit code."""
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.diagnostics import Report

    project = project_file(arguments)
    if project is None:
        return report_no_project()
    from codegen import pipeline
    from codegen.cli.waived import waivers_of, with_waivers

    report = Report()
    systems = pipeline.read_systems(project, report)
    pipeline.check_scenarios(project, systems, report)
    pipeline.check_documents(systems, report)
    report = with_waivers(report, waivers_of(project), (), ())
    print_findings(report, arguments.format)
    return report.exit_code
