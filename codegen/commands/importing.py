"""The way of the data for ``codegen import``: from a document to a proposal, beside the table that there is."""

import os
from collections.abc import Collection, Sequence

from codegen.commands.codec import read_codec_dialect
from codegen.diagnostics import Report, did_you_mean
from codegen.emit.file import write_file
from codegen.frozen import dataclass
from codegen.importing.comparison import Compared, Verdict, compare
from codegen.importing.document import document_id, find_fields
from codegen.importing.existing import ExistingTable, senders, table_of, table_of_project
from codegen.importing.merging import merge
from codegen.importing.of_system import mentioned_stream, schema_path, sources_of
from codegen.importing.proposal import (
    Proposal,
    check_declarations,
    not_answered_by,
    propose,
    report_unmentioned,
    report_unread,
)
from codegen.importing.table_text import Heading, table_text
from codegen.load.files import DISK
from codegen.model.dialect.dialect import Dialect, WireMessage
from codegen.model.system import System
from codegen.project.systems import read_systems


@dataclass(frozen=True, slots=True)
class Wanted:
    """A request to import from ``document`` (a path as the user wrote it); None: the user did not state it.

    ``table`` is the file of the table, where the project's own is not meant; ``needs_table`` says that there has to be
    one already, to be compared or merged with.
    """

    document: str
    message: str | None
    for_each: str | None
    stream: str | None
    requirement: str | None
    table: str | None
    needs_table: bool


@dataclass(frozen=True, slots=True)
class Imported:
    """An imported proposal with its heading, and its differences from the existing ``table``, if there is one."""

    proposal: Proposal
    heading: Heading
    table: ExistingTable | None
    rows: Sequence[Compared]

    @property
    def text(self) -> str:
        """The population table that the document proposes."""
        return table_text(self.proposal, self.heading)

    @property
    def differs(self) -> bool:
        """Return whether a field is answered otherwise by the table."""
        return any(row.verdict is Verdict.DIFFERENT for row in self.rows)

    @property
    def lacks(self) -> bool:
        """Return whether the table does not answer for a field that the document answers for."""
        return any(row.verdict is Verdict.ONLY_DOCUMENT for row in self.rows)


@dataclass(frozen=True, slots=True)
class NoTable:
    """The refusal where no table exists yet for the message that a document is about."""

    message: str


def surroundings(project: str | None, dialect: str | None, report: Report) -> tuple[tuple[System, ...], Dialect | None]:
    """Return the programs of the project, if there is one, and its dialect or the one that is named.

    No dialect after a finding, such as a population table that cannot be read: it may be the one of the message. What
    else is wrong with the project is for ``check`` to say: a table that is imported may be what is missing.
    """
    if project is None:
        return (), read_codec_dialect(dialect or "common", report)
    reading = Report()
    systems = read_systems(project, reading)
    if not systems:
        report.extend(reading)
        return (), None
    tables = {table.place.file for system in systems for table in system.spec.populations}
    unread = [finding for finding in reading if finding.is_error and _is_other_table(finding.place.file, tables)]
    report.extend(unread)
    return ((), None) if unread else (systems, systems[0].dialect)


def _is_other_table(file: str, read: Collection[str]) -> bool:
    """Return whether a file is a population table, other than those that are ``read``."""
    return os.path.basename(os.path.dirname(file)) == "messages" and file not in read


def unknown_name(wanted: Wanted, systems: Sequence[System]) -> str | None:
    """Return in words what is named that the project does not have."""
    if not systems:
        return None
    for kind, name, known in (
        ("component", wanted.for_each, systems[0].components),
        ("stream", wanted.stream, systems[0].streams),
    ):
        if name is not None and name not in known:
            return f"the project has no {kind} {name}; {did_you_mean(name, known) or 'it has none'}"
    return None


def read_document(wanted: Wanted, report: Report) -> str | None:
    """Return the text of the document; None after a finding."""
    return DISK.read_text(os.path.abspath(wanted.document), report)


def imported(
    wanted: Wanted, text: str, systems: Sequence[System], dialect: Dialect, report: Report
) -> Imported | NoTable | None:
    """Return what the text of the document says of the fields of one message; None after a finding."""
    path = os.path.abspath(wanted.document)
    message = None if wanted.message is None else wanted.message.upper()
    found = find_fields(text, path, message, dialect, report)
    if found is None:
        return None
    table_path = _table_path(wanted, found.message, systems)
    table = None if table_path is None else _existing(table_path, found.message, systems, report)
    if table_path is not None and table is None:
        return None
    if table is None and wanted.needs_table:
        return NoTable(found.message.name)
    for_each = wanted.for_each or (table.spec.for_each if table else None)
    sources = sources_of(dialect, _program(found.message, path, table_path, systems), for_each)
    proposal = propose(found.lists, found.message, sources, report)
    report_unread(found.others, found.message, report)
    for fields in found.lists:
        check_declarations(fields, found.message, report)
    heading = _heading(wanted, text, for_each, found.message, table, systems)
    answered = [answer.target for answer in table.answers] if table else []
    report_unmentioned(not_answered_by(proposal, answered), proposal.place, report)
    return Imported(proposal, heading, table, compare(proposal, table.answers, sources) if table else ())


def add_missing(found: Imported, report: Report) -> Sequence[str] | None:
    """Add to the table the answers that it lacks, and return what was added; None after a finding."""
    assert found.table is not None
    table, document = found.table, found.heading.document
    merged = merge(table.text, table.path, found.proposal.message, found.rows, document, report)
    if merged is None or (merged.added and not write_file(table.path, merged.text, report)):
        return None
    return merged.added


def _table_path(wanted: Wanted, message: WireMessage, systems: Sequence[System]) -> str | None:
    """Return the absolute path of the table that there is: the one that is named, or that of the project."""
    if wanted.table is not None:
        return os.path.abspath(wanted.table) if os.path.lexists(wanted.table) else None
    known = senders(message.name, systems, os.path.abspath(wanted.document))
    return known[0].tables[0].population.place.file if known else None


def _program(message: WireMessage, document: str, table: str | None, systems: Sequence[System]) -> System | None:
    """Return the program that a table is of: its own, else the first that the document is about, else the main one."""
    programs = [sender.system for sender in senders(message.name, systems, document)]
    own = (each for each in systems if any(one.population.place.file == table for one in each.tables(message.name)))
    return next(iter((*own, *programs, *systems)), None)


def _existing(path: str, message: WireMessage, systems: Sequence[System], report: Report) -> ExistingTable | None:
    """Return the table in a file; None after a finding."""
    text = DISK.read_text(path, report)
    if text is None:
        return None
    tables = (table for system in systems for table in system.tables(message.name))
    known = next((table for table in tables if table.population.place.file == path), None)
    return table_of(text, path, message, report) if known is None else table_of_project(text, known)


def _heading(
    wanted: Wanted,
    text: str,
    for_each: str | None,
    message: WireMessage,
    table: ExistingTable | None,
    systems: Sequence[System],
) -> Heading:
    """Return what stands above the fields: what is wanted, else as in the table that there is, else the document."""
    identifier = document_id(text, wanted.document)
    requirement, stream = wanted.requirement or identifier, wanted.stream
    if table is not None:
        stream = stream or table.spec.stream
        if table.spec.requirement.partition(".")[0] == requirement:
            requirement = table.spec.requirement
    if stream is None and systems:
        stream = mentioned_stream(text, systems[0])
    schema = None
    if systems:
        file = f"messages/{message.name.lower()}.yaml" if wanted.table is None else os.path.abspath(wanted.table)
        schema = schema_path(systems[0], file)
    name = identifier or os.path.basename(wanted.document)
    return Heading(name, requirement, for_each, stream, schema)
