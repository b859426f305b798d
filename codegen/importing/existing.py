"""A population table that exists already, as it is compared with a document."""

from collections.abc import Iterator, Sequence

from codegen.decode.record import decode_record
from codegen.diagnostics import Report, Rule
from codegen.frozen import dataclass
from codegen.importing.answer import Target
from codegen.importing.comparison import TableAnswer, table_answers
from codegen.importing.of_system import answers_of
from codegen.load.yaml_tree import parse_yaml
from codegen.model.dialect.dialect import WireMessage
from codegen.model.spec.population import FieldAnswer, PopulationSpec
from codegen.model.system import PopulatedMessage, System
from codegen.resolve.population.elements import other_ranges

MERGE_MESSAGE = Rule("merge-message", "A population table is to be merged with a document about another message.")


@dataclass(frozen=True, slots=True)
class ExistingTable:
    """A table: its absolute path, its text, its answers, and the record that it was read into."""

    path: str
    text: str
    answers: tuple[TableAnswer, ...]
    spec: PopulationSpec


def table_of(text: str, path: str, message: WireMessage, report: Report) -> ExistingTable | None:
    """The table that a text states; None, after a finding, if it is none of ``message``."""
    found = Report()
    node = parse_yaml(text, path, found)
    table = None if node is None else decode_record(node, PopulationSpec, found)
    report.extend(found)
    if table is None or found.has_errors:
        return None
    if table.message != message.name:
        wrong = f"the table is of {table.message}, the document about {message.name}"
        report.add(MERGE_MESSAGE, table.at("message"), wrong, "name the table of that message")
        return None
    answers = table_answers(message, table.fields, {})
    return ExistingTable(path, text, (*answers, *_others(table, answers, message)), table)


def _others(table: PopulationSpec, answers: Sequence[TableAnswer], message: WireMessage) -> Iterator[TableAnswer]:
    """Yield what a table says of the elements that it does not list."""
    if table.others is None:
        return
    listed = [(each.target.field, each.target.first, each.target.count) for each in answers]
    for field, first, count in other_ranges(listed, message):
        target = Target(message, field, first, count)
        fixed = None if target.sentinel is None else (target.sentinel,)
        yield TableAnswer(target, FieldAnswer(place=table.at("others"), unknown=True), fixed, by_others=True)


@dataclass(frozen=True, slots=True)
class Sender:
    """A program that sends a message, and those of its tables of it that a document may be about."""

    system: System
    tables: tuple[PopulatedMessage, ...]


def senders(name: str, systems: Sequence[System], document: str) -> tuple[Sender, ...]:
    """The programs whose tables of a message the document with this path is about, in the order of the programs.

    A document that is in the specification of some of them is about these: one in the folder of a further program is
    about that program alone, one that such a program has replaced is not about it. Of the tables those are meant that
    cite the document, where any does: a program with a table that cites another one has said what is true of it.
    """
    readers = tuple(system for system in systems if system.has_document(document)) or tuple(systems)
    found = tuple(Sender(system, tables) for system in readers if (tables := system.tables(name)))
    asked = tuple(
        Sender(each.system, tables)
        for each in found
        if (tables := tuple(table for table in each.tables if table.citation.requirement.place.file == document))
    )
    return asked or found


def table_of_project(text: str, message: PopulatedMessage) -> ExistingTable:
    """The table of a message of the project, with the numbers that it settles; ``text`` is that of its file."""
    return ExistingTable(message.population.place.file, text, answers_of(message), message.population)
