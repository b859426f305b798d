"""Finds drift between tables in the project's own documents and its population tables, or the dialect."""

import os
from collections.abc import Iterable, Iterator, Sequence

from codegen.diagnostics import Diagnostic, Report, Rule, Severity
from codegen.importing.columns import Role
from codegen.importing.comparison import Compared, Verdict, compare, place_of
from codegen.importing.existing import senders
from codegen.importing.of_system import answers_of, sources_of
from codegen.importing.proposal import check_declarations, propose, report_unread
from codegen.importing.stated import FieldList, StatedFields, columns_of
from codegen.importing.subject import coverage, is_example, subjects
from codegen.model.system import PopulatedMessage, System

DOCUMENT_DRIFT = Rule(
    "document-drift",
    "A document and the population table answer differently for a field. One of them is out of date: correct it, so "
    "that reviewers of the document see what the firmware sends.",
)
DOCUMENT_ROW_MISSING = Rule(
    "document-row-missing",
    "A document has a table of most fields of a message, but the population table answers for one that it leaves out.",
    Severity.WARNING,
)


def drift(stated: StatedFields, systems: Sequence[System]) -> Iterator[Diagnostic]:
    """The findings about one document of a project, whose programs are ``systems``, the main one first.

    A document has to be true of each program that it is about. Of messages that none of them populates only the columns
    of types, units and sentinels are looked at.
    """
    report = Report()
    dialect = systems[0].dialect
    lists: dict[str, list[FieldList]] = {}
    read: set[str] = set()
    for fields in stated.lists:
        about = subjects(fields, dialect)
        if len(about) == 1:
            lists.setdefault(about[0].name, []).append(fields)
    for name, found in lists.items():
        for fields in found:
            check_declarations(fields, dialect.messages[name], report)
        answered = [fields for fields in found if Role.VALUE in fields.roles and not is_example(fields)]
        if answered:
            read.add(name)
            report.extend(_of_programs(name, answered, systems))
            report_unread(stated.others, dialect.messages[name], report)
    _report_tables_of_others(stated, systems, read, report)
    yield from report


def _report_tables_of_others(stated: StatedFields, systems: Sequence[System], read: set[str], report: Report) -> None:
    """Report the tables of most fields of a message that is sent, of which the document has no table that is read."""
    for table, context in zip(stated.others, stated.other_contexts, strict=True):
        for fields in columns_of(table, context):
            about = subjects(fields, systems[0].dialect)
            if len(about) != 1 or about[0].name in read or is_example(fields):
                continue
            is_sent = any(system.tables(about[0].name) for system in systems)
            if is_sent and 2 * coverage(fields, about[0]) > len(about[0].fields):
                report_unread([table], about[0], report)


def _of_programs(name: str, answered: Sequence[FieldList], systems: Sequence[System]) -> Iterator[Diagnostic]:
    """Return what the lists say of a message otherwise than the programs; what is found for several is told once."""
    told = set()
    for sender in senders(name, systems, answered[0].place.file):
        for finding in _fewest(_differences(answered, table, sender.system) for table in sender.tables):
            said = finding.place, finding.rule.id, finding.message, finding.related
            if said not in told:
                told.add(said)
                yield finding


def _fewest(found: Iterable[list[Diagnostic]]) -> list[Diagnostic]:
    return min(found, key=len)


def _differences(lists: Sequence[FieldList], message: PopulatedMessage, system: System) -> list[Diagnostic]:
    """Return what the lists say otherwise than a table.

    Of several tables they are about the one that is most like them.
    """
    report = Report()
    sources = sources_of(system.dialect, system, message.component.name if message.component else None)
    proposal = propose(lists, message.wire, sources, report)
    covered = max(coverage(fields, message.wire) for fields in lists)
    is_whole = 2 * covered > len(message.wire.fields)
    table, way = _called(message, system)
    for row in compare(proposal, answers_of(message), sources):
        if row.verdict is Verdict.DIFFERENT and row.document is not None:
            report.extend([_difference(row, table, way)])
        elif row.verdict is Verdict.ONLY_TABLE and is_whole and not all(one.by_others for one in row.table):
            text = f"the table leaves out {row.target.name}, which {table} answers"
            related = [(place, "it is answered here")] if (place := place_of(row)) else []
            report.add(DOCUMENT_ROW_MISSING, proposal.place, text, f"add a row: {row.tabled}", related)
    return list(report)


def _called(message: PopulatedMessage, system: System) -> tuple[str, str]:
    """Return how a table is called, and what else than a correction there is to do: of one of a further program."""
    spec = system.spec
    if not spec.program or not message.population.place.file.startswith(spec.own_folder + os.sep):
        return "the population table", ""
    folder = os.path.basename(spec.own_folder)
    way = f", or let the table of {spec.program} cite a document of its own in {folder}/requirements"
    return f"the population table of {spec.program}", way


def _difference(row: Compared, table: str, way: str) -> Diagnostic:
    assert row.document is not None
    message = f"{row.target.name} is {row.stated} here, but {row.tabled} in {table}"
    place = place_of(row)
    related = ((place, "the population table answers here"),) if place else ()
    hint = f"correct the one that is out of date{way}"
    return Diagnostic(row.document.place, DOCUMENT_DRIFT, message, hint, related)
