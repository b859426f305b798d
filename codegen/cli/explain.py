"""``codegen explain``: the whole story of one message, field, parameter or rule, of the main loop, or of the heap."""

import argparse
import sys
from typing import Any


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "explain",
        parents=[common],
        description="Tell the whole story of one thing: where it is specified, what becomes of it and why.",
    )
    parser.add_argument(
        "topic",
        metavar="TOPIC",
        help="a message (GPS_RAW_INT) or its field (GPS_RAW_INT.eph), a table by its own name, a component (gps) or "
        "its quantity (gps.latitude), a parameter, a stream, a requirement or its criterion (FR-1.3), the id of a "
        "rule (sentinel-contradiction), loop: what the main loop leaves to control() on the board, or heap: what the "
        "program takes of its memory",
    )
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print the story to stdout, or why there is none, and return the exit code."""
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.commands.explain import story_of
    from codegen.diagnostics import Report

    project = project_file(arguments)
    report = Report()
    story = story_of(arguments.topic, project, report)
    if story is not None:
        print(story.rstrip("\n"))
        return 0
    if project is None:
        return report_no_project()
    print_findings(report)
    if report.has_errors:
        return report.exit_code
    print(f"codegen: there is nothing to tell about {arguments.topic!r}", file=sys.stderr)
    return 2
