"""``codegen explain``: the whole story of one message, field, parameter or rule, or of the main loop."""

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
        "rule (sentinel-contradiction), or loop: what the main loop leaves to control() on the board",
    )
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print the story to stdout, or why there is none, and return the exit code."""
    from codegen import pipeline
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.diagnostics import Report
    from codegen.explain import explain

    # Whoever asks what a rule means often has a specification that breaks it, so a broken one still gets an answer.
    project = project_file(arguments)
    reading, report = Report(), Report()
    systems = () if project is None else pipeline.read_systems(project, reading)
    system = systems[0] if systems else None
    story = explain(arguments.topic, system, report)
    for program in systems[1:]:
        told = explain(arguments.topic, program, Report())
        if told is not None and told != story:
            heading = f"In the program {program.spec.program}:\n{told}"
            story = heading if story is None else f"{story}\n{heading}"
    if story is not None:
        print(story.rstrip("\n"))
        return 0
    if project is None:
        return report_no_project()
    if system is None:
        report.extend(reading)
    print_findings(report)
    if report.has_errors:
        return report.exit_code
    print(f"codegen: there is nothing to tell about {arguments.topic!r}", file=sys.stderr)
    return 2
