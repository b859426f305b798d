"""A population table that exists already, as it is compared with a document."""

from collections.abc import Sequence

from codegen.decode.record import decode_record
from codegen.diagnostics import Report, Rule
from codegen.frozen import dataclass
from codegen.importing.comparison import TableAnswer, table_answers
from codegen.importing.of_system import answers_of
from codegen.load.yaml_tree import parse_yaml
from codegen.model.dialect import WireMessage
from codegen.model.population_spec import PopulationSpec
from codegen.model.system import PopulatedMessage, System

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
    return ExistingTable(path, text, table_answers(message, table.fields, {}), table)


def sender(name: str, systems: Sequence[System]) -> System | None:
    """The first of the programs that sends a message called ``name``."""
    return next((system for system in systems if any(message.name == name for message in system.messages)), None)


def populated(name: str, systems: Sequence[System]) -> PopulatedMessage | None:
    """The message of that program."""
    return next((message for system in systems for message in system.messages if message.name == name), None)


def table_of_project(text: str, message: PopulatedMessage) -> ExistingTable:
    """The table of a message of the project, with the numbers that it settles; ``text`` is that of its file."""
    return ExistingTable(message.population.place.file, text, answers_of(message), message.population)
