"""Takes from a project all that importing needs: its sources of values, and the answers of its tables."""

import os
import re

from codegen.importing.answer import Sources, Target
from codegen.importing.comparison import Number, TableAnswer, table_answers
from codegen.model.dialect.dialect import Dialect
from codegen.model.system import PopulatedMessage, System


def sources_of(dialect: Dialect, system: System | None, for_each: str | None = None) -> Sources:
    """The dialect, and the quantities and parameters of a project, if there is one."""
    if system is None:
        return Sources(dialect, for_each=for_each)
    units = {
        quantity.path: quantity.unit
        for component in system.components.values()
        for quantity in component.quantities.values()
    }
    return Sources(dialect, units, frozenset(system.parameters), for_each)


def mentioned_stream(text: str, system: System) -> str | None:
    """The one stream whose parameter a document names; None if it names none, or several."""
    found = {
        name
        for name, stream in system.streams.items()
        if stream.parameter is not None and re.search(rf"\b{re.escape(stream.parameter.name)}\b", text)
    }
    return found.pop() if len(found) == 1 else None


def schema_path(system: System, file: str) -> str:
    """The path of the JSON Schema of population tables, from a file, which may be relative to the specification."""
    folder = system.spec.folder
    schemas = os.path.join(folder, system.spec.project.output, "schemas", "message.schema.json")
    return os.path.relpath(schemas, os.path.dirname(os.path.join(folder, file))).replace(os.sep, "/")


def answers_of(message: PopulatedMessage) -> tuple[TableAnswer, ...]:
    """The answers of a message's table, with the numbers of those that are known now."""
    fields = message.population.fields
    fixed: dict[str, tuple[Number | str, ...]] = {}
    for answer in message.answers:
        if answer.always is not None:
            fixed |= {key: answer.always for key, written in fields.items() if written is answer.covers.written}
    others = (
        TableAnswer(
            Target(message.wire, covers.field, covers.first, covers.count),
            covers.written,
            answer.always,
            by_others=True,
        )
        for answer in message.answers
        for covers in [answer.covers]
        if covers.by_others
    )
    return (*table_answers(message.wire, fields, fixed), *others)
