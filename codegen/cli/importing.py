"""``codegen import``: from a requirement document to a population table, or from another tool to documents."""

import argparse
import os
import sys
from contextlib import redirect_stdout
from typing import TYPE_CHECKING, Any

from codegen.cli import importing_requirements

if TYPE_CHECKING:
    from codegen.commands.importing import Imported
    from codegen.diagnostics import Report
    from codegen.importing.existing import ExistingTable


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "import",
        parents=[common],
        description="Read the tables and lists of a Markdown document that say what goes into the fields of a message, "
        "and print the population table. What is ambiguous is reported with a proposal and stands in a comment. Works "
        "in a project, or without one on a dialect. Of a FILE.reqif or needs.json it makes requirement documents "
        "instead.",
    )
    parser.add_argument("document", metavar="DOC", help="the document, of any ending")
    parser.add_argument("--message", metavar="NAME", help="the message (default: the one that the document names)")
    parser.add_argument(
        "--dialect", metavar="X", help="a dialect that pymavlink ships, or an XML file, in place of the project's"
    )
    parser.add_argument("--for-each", metavar="COMPONENT", help="the component of which each has a message of its own")
    parser.add_argument("--stream", metavar="NAME", help="the stream (default: the one whose parameter is mentioned)")
    parser.add_argument("--requirement", metavar="ID", help="what the table cites (default: the id of the document)")
    parser.add_argument("--out", metavar="FILE", default="-", help="write to a new file (default: -, print)")
    parser.add_argument(
        "--merge",
        action="store_true",
        help="add the missing answers to the table of --out, or of the project; nothing else in it changes",
    )
    parser.add_argument(
        "--compare",
        action="store_true",
        help="print how document and existing table differ, field by field (of several tables of the message: that of "
        "--out, or the one that cites the document)",
    )
    importing_requirements.add_arguments(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Do what the options ask for, and return the exit code."""
    if arguments.document.lower().endswith(importing_requirements.ENDINGS):
        return importing_requirements.import_requirements(arguments)
    fault = _nonsense(arguments)
    if fault:
        return _usage(fault)
    from codegen.cli.progress import working
    from codegen.cli.project import project_file
    from codegen.commands.importing import NoTable, Wanted, imported, read_document, surroundings, unknown_name
    from codegen.diagnostics import Report

    report = Report()
    wanted = Wanted(
        document=arguments.document,
        message=arguments.message,
        for_each=arguments.for_each,
        stream=arguments.stream,
        requirement=arguments.requirement,
        table=None if arguments.out == "-" else arguments.out,
        needs_table=arguments.compare or (arguments.merge and arguments.out == "-"),
    )
    text = read_document(wanted, report)
    project = None if arguments.dialect is not None else project_file(arguments)
    with working("reading the specification"):
        systems, dialect = surroundings(project, arguments.dialect, report)
    if text is None or dialect is None:
        return _finish(report)
    fault = unknown_name(wanted, systems)
    if fault:
        return _usage(fault)
    found = imported(wanted, text, systems, dialect, report)
    if found is None:
        return _finish(report)
    if isinstance(found, NoTable):
        return _usage(f"there is no table of {found.message} yet; name a file with --out FILE")
    return _deliver(arguments, found, report)


def _deliver(arguments: argparse.Namespace, found: "Imported", report: "Report") -> int:
    """Compare, merge, write or print, and then the findings."""
    from codegen.emit.file import write_file
    from codegen.importing.comparison import comparison_text, summary

    table, proposal = found.table, found.proposal
    if table is not None and arguments.merge:
        _merge(found, table, report)
    if table is not None and (arguments.compare or arguments.merge):
        print(f"{proposal.message.name}: {_shown(proposal.place.file)} beside {_shown(table.path)}")
        print(comparison_text(found.rows))
        return max(_finish(report), int(found.differs or (arguments.compare and found.lacks)))
    if arguments.out != "-":
        write_file(arguments.out, found.text, report)
        return _finish(report)
    print(found.text, end="", flush=True)
    # Whoever pipes the table into a file wants to see the findings, and not in the file.
    with redirect_stdout(sys.stderr):
        code = _finish(report)
    if table is not None:
        print(f"{_shown(table.path)} has a table: {summary(found.rows)}; --compare lists them", file=sys.stderr)
    return code


def _merge(found: "Imported", table: "ExistingTable", report: "Report") -> None:
    from codegen.commands.importing import add_missing

    added = add_missing(found, report)
    if added:
        print(f"added to {_shown(table.path)}: {', '.join(added)}", file=sys.stderr)
    elif added is not None:
        print(f"{_shown(table.path)} lacks none of these answers", file=sys.stderr)


def _nonsense(arguments: argparse.Namespace) -> str | None:
    """Return why the options cannot go together, or None."""
    foreign = next((name for name in importing_requirements.OPTIONS if getattr(arguments, name)), None)
    if foreign is not None:
        return f"--{foreign} belongs to the import of a FILE.reqif or needs.json"
    if arguments.merge and arguments.compare:
        return "--compare writes nothing; it does not go with --merge"
    if arguments.dialect is not None and getattr(arguments, "project", None) is not None:
        return "--dialect works without a project; it does not go with --project"
    if arguments.out != "-" and os.path.lexists(arguments.out) and not (arguments.merge or arguments.compare):
        return f"{arguments.out} exists; --merge adds what is missing, --compare shows how it differs"
    return None


def _shown(path: str) -> str:
    from codegen.source import shown_path

    return shown_path(path)


def _finish(report: "Report") -> int:
    from codegen.cli.findings import print_findings

    print_findings(report)
    return report.exit_code


def _usage(fault: str) -> int:
    print(f"codegen import: {fault}", file=sys.stderr)
    return 2
