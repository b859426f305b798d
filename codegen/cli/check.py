"""``codegen check``: what is wrong with the specification, and with what documents claim."""

import argparse
import sys
from typing import TYPE_CHECKING, Any

from codegen.cli.output import add_format_option

if TYPE_CHECKING:
    from codegen.claims.own.worked.listing import Number
    from codegen.diagnostics import Report


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "check",
        parents=[common],
        description="Check the specification against the dialect, and recompute what the requirement documents claim: "
        "sizes, rates, ids, worked examples, structs, XML, sentinels. With DOC only the claims of these documents are "
        "checked, Markdown whatever they end in, against the project if there is one.",
    )
    parser.add_argument("documents", metavar="DOC", nargs="*", help="a document whose claims are checked")
    parser.add_argument(
        "--dialect",
        metavar="NAME|FILE",
        help="compare DOC with this dialect: one that pymavlink ships, or an XML file (default: the project's; common "
        "without a project)",
    )
    add_format_option(parser)
    parser.add_argument("--waived", action="store_true", help="print waived findings, too, and not only their number")
    parser.add_argument(
        "--examples",
        action="store_true",
        help="list the numbers of worked examples that nothing computes: those that could be others without a finding",
    )
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print what was found, and return the exit code."""
    from codegen.cli.project import project_file, report_no_project
    from codegen.commands.check import check_project, claim_rules

    project = project_file(arguments)
    if arguments.dialect is not None and not arguments.documents:
        print("codegen check: --dialect goes with documents; a project names its own", file=sys.stderr)
        return 2
    if arguments.examples and arguments.format != "text":
        print("codegen check: --examples is a list for people; it does not go with --format", file=sys.stderr)
        return 2
    if project is None and not arguments.documents:
        return report_no_project(arguments.format)
    from codegen.cli.findings import print_findings
    from codegen.cli.progress import working
    from codegen.decode.reach import within
    from codegen.diagnostics import Report
    from codegen.load.files import DISK

    report = Report()
    listed: list[Number] = []
    with working("reading and checking"):
        if arguments.documents:
            files = _check_documents(arguments, project, report, listed)
        else:
            assert project is not None
            files = check_project(project, report, listed if arguments.examples else None)
        if project is not None:
            from codegen.commands.waived import waivers_of, with_waivers

            waivers = waivers_of(project)
            report = with_waivers(report, waivers, claim_rules() if waivers else (), files, within(project, DISK))
    print_findings(report, arguments.format, shows_waived=arguments.waived)
    if arguments.examples:
        _print_examples(listed)
    return report.exit_code


def _check_documents(
    arguments: argparse.Namespace, project: str | None, report: "Report", listed: "list[Number]"
) -> list[str]:
    """Report on the claims of the documents that the arguments name; returns those that could be read."""
    from codegen.commands import documents
    from codegen.commands.check import documents_of, reference_for

    reference = reference_for(arguments.dialect, project, report)
    if reference is None:
        return []
    paths = documents_of(arguments.documents, reference, report)
    if arguments.examples:
        listed.extend(documents.example_numbers(paths, reference))
    return documents.check_documents(paths, reference, report)


def _print_examples(listed: "list[Number]") -> None:
    """Print the numbers that nothing computes, those of a row or a sentence on one line, and how many there are."""
    from itertools import groupby

    from codegen.findings.text import printable

    unknown = [each for each in listed if not each.is_computed]
    for _, run in groupby(unknown, lambda each: (each.place.file, each.place.line)):
        row = list(run)
        written = ", ".join(f"{each.amount.written} {each.amount.unit.name}".strip() for each in row)
        print(f"{printable(row[0].place.shown())}: not computable: {printable(written)}")
    computed = len(listed) - len(unknown)
    print(end="", flush=True)
    counted = f"{len(listed)} numbers in worked examples: {computed} recomputed, {len(unknown)} not computable"
    print(counted, file=sys.stderr)
