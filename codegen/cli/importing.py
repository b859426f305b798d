"""``codegen import``: from a requirement document to a population table, or from another tool to documents."""

import argparse
import os
import sys
from collections.abc import Sequence
from contextlib import redirect_stdout
from typing import TYPE_CHECKING, Any

from codegen.cli import importing_requirements

if TYPE_CHECKING:
    from codegen.diagnostics import Report
    from codegen.importing.answer import Sources
    from codegen.importing.comparison import Compared
    from codegen.importing.existing import ExistingTable
    from codegen.importing.proposal import Proposal
    from codegen.importing.table_text import Heading
    from codegen.model.dialect.dialect import Dialect, WireMessage
    from codegen.model.system import System


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
    from codegen.diagnostics import Report
    from codegen.importing.document import find_fields
    from codegen.importing.existing import sender
    from codegen.importing.of_system import sources_of
    from codegen.importing.proposal import check_declarations, propose
    from codegen.load.text import read_text

    report = Report()
    path = os.path.abspath(arguments.document)
    text = read_text(path, report)
    systems, dialect = _surroundings(arguments, report)
    if text is None or dialect is None:
        return _finish(report)
    fault = _unknown_name(arguments, systems)
    if fault:
        return _usage(fault)
    wanted = None if arguments.message is None else arguments.message.upper()
    found = find_fields(text, path, wanted, dialect, report)
    if found is None:
        return _finish(report)
    table_path = _table_path(arguments, found.message, systems)
    table = None if table_path is None else _existing(table_path, found.message, systems, report)
    if table_path is not None and table is None:
        return _finish(report)
    if table is None and (arguments.compare or (arguments.merge and arguments.out == "-")):
        return _usage(f"there is no table of {found.message.name} yet; name a file with --out FILE")
    for_each = arguments.for_each or (table.spec.for_each if table else None)
    system = sender(found.message.name, systems) or (systems[0] if systems else None)
    sources = sources_of(dialect, system, for_each)
    proposal = propose(found.lists, found.message, sources, report)
    for fields in found.lists:
        check_declarations(fields, found.message, report)
    heading = _heading(arguments, text, for_each, found.message, table, systems)
    return _deliver(arguments, proposal, heading, table, sources, report)


def _deliver(
    arguments: argparse.Namespace,
    proposal: "Proposal",
    heading: "Heading",
    table: "ExistingTable | None",
    sources: "Sources",
    report: "Report",
) -> int:
    """Compare, merge, write or print, and then the findings."""
    from codegen.importing.comparison import Verdict, compare, comparison_text, summary
    from codegen.importing.proposal import not_answered_by, report_unmentioned
    from codegen.importing.table_text import table_text

    answered = [answer.target for answer in table.answers] if table else []
    report_unmentioned(not_answered_by(proposal, answered), proposal.place, report)
    rows = compare(proposal, table.answers, sources) if table else ()
    if table is not None and arguments.merge:
        _merge(table, proposal, rows, heading, report)
    if table is not None and (arguments.compare or arguments.merge):
        print(f"{proposal.message.name}: {_shown(proposal.place.file)} beside {_shown(table.path)}")
        print(comparison_text(rows))
        return max(_finish(report), int(any(row.verdict is Verdict.DIFFERENT for row in rows)))
    from codegen.emit.file import write_file

    written = table_text(proposal, heading)
    if arguments.out != "-":
        write_file(arguments.out, written, report)
        return _finish(report)
    print(written, end="", flush=True)
    # Whoever pipes the table into a file wants to see the findings, and not in the file.
    with redirect_stdout(sys.stderr):
        code = _finish(report)
    if table is not None:
        print(f"{_shown(table.path)} has a table: {summary(rows)}; --compare lists them", file=sys.stderr)
    return code


def _merge(
    table: "ExistingTable", proposal: "Proposal", rows: "Sequence[Compared]", heading: "Heading", report: "Report"
) -> None:
    from codegen.emit.file import write_file
    from codegen.importing.merging import merge

    merged = merge(table.text, table.path, proposal.message, rows, heading.document, report)
    if merged is None:
        return
    if merged.added and write_file(table.path, merged.text, report):
        print(f"added to {_shown(table.path)}: {', '.join(merged.added)}", file=sys.stderr)
    elif not merged.added:
        print(f"{_shown(table.path)} lacks none of these answers", file=sys.stderr)


def _nonsense(arguments: argparse.Namespace) -> str | None:
    """Why the options cannot go together, or None."""
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


def _surroundings(arguments: argparse.Namespace, report: "Report") -> "tuple[tuple[System, ...], Dialect | None]":
    """The programs of the project, if there is one, and the dialect; None after a finding."""
    from codegen.cli.progress import working
    from codegen.cli.project import project_file
    from codegen.commands.codec import read_codec_dialect
    from codegen.diagnostics import Report
    from codegen.project.systems import read_systems

    project = None if arguments.dialect is not None else project_file(arguments)
    if project is None:
        return (), read_codec_dialect(arguments.dialect or "common", report)
    # What is wrong with the project is for check to say: a table that is imported may be what is missing.
    reading = Report()
    with working("reading the specification"):
        systems = read_systems(project, reading)
    if not systems:
        report.extend(reading)
        return (), None
    return systems, systems[0].dialect


def _unknown_name(arguments: argparse.Namespace, systems: "tuple[System, ...]") -> str | None:
    """What an option names that the project does not have."""
    from codegen.diagnostics import did_you_mean

    for option, name, known in (
        ("component", arguments.for_each, systems[0].components if systems else None),
        ("stream", arguments.stream, systems[0].streams if systems else None),
    ):
        if name is not None and known is not None and name not in known:
            return f"the project has no {option} {name}; {did_you_mean(name, known) or 'it has none'}"
    return None


def _table_path(arguments: argparse.Namespace, message: "WireMessage", systems: "tuple[System, ...]") -> str | None:
    """The absolute path of the table that there is: that of --out, or of the project."""
    from codegen.importing.existing import populated

    if arguments.out != "-":
        return os.path.abspath(arguments.out) if os.path.lexists(arguments.out) else None
    known = populated(message.name, systems, os.path.abspath(arguments.document))
    return known[0].population.place.file if known else None


def _existing(
    path: str, message: "WireMessage", systems: "tuple[System, ...]", report: "Report"
) -> "ExistingTable | None":
    """The table in a file; None after a finding."""
    from codegen.importing.existing import table_of, table_of_project
    from codegen.load.text import read_text

    text = read_text(path, report)
    if text is None:
        return None
    tables = (table for system in systems for table in system.tables(message.name))
    known = next((table for table in tables if table.population.place.file == path), None)
    return table_of(text, path, message, report) if known is None else table_of_project(text, known)


def _heading(
    arguments: argparse.Namespace,
    text: str,
    for_each: str | None,
    message: "WireMessage",
    table: "ExistingTable | None",
    systems: "tuple[System, ...]",
) -> "Heading":
    """What stands above the fields: what the options say, else as in the table that there is, else the document."""
    from codegen.importing.document import document_id
    from codegen.importing.of_system import mentioned_stream, schema_path
    from codegen.importing.table_text import Heading

    identifier = document_id(text, arguments.document)
    requirement, stream = arguments.requirement or identifier, arguments.stream
    if table is not None:
        stream = stream or table.spec.stream
        if table.spec.requirement.partition(".")[0] == requirement:
            requirement = table.spec.requirement
    if stream is None and systems:
        stream = mentioned_stream(text, systems[0])
    schema = None
    if systems:
        file = f"messages/{message.name.lower()}.yaml" if arguments.out == "-" else os.path.abspath(arguments.out)
        schema = schema_path(systems[0], file)
    name = identifier or os.path.basename(arguments.document)
    return Heading(name, requirement, for_each, stream, schema)


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
