"""The enum modules: one for each enum, so that a board pays only for those that it imports."""

from collections.abc import Iterable

from codegen.model.dialect import Dialect, EnumDefinition, WireMessage
from codegen.template_files import filled

WIDTH = 118
"""Columns of a line with its comment."""


def enums_of(messages: Iterable[WireMessage], dialect: Dialect) -> tuple[EnumDefinition, ...]:
    """The enums that fields of the messages refer to, in the order of their names."""
    names = {field.definition.enum for message in messages for field in message.fields if field.definition.enum}
    return tuple(dialect.enums[name] for name in sorted(names & dialect.enums.keys()))


def module_name(enum: EnumDefinition) -> str:
    """The module of an enum, below ``enums``."""
    return enum.name.lower()


def enum_text(enum: EnumDefinition) -> str:
    """The module of an enum: ``NAME = value  # what it means``."""
    values = {
        "name": enum.name,
        "kind": "bits, to be combined" if enum.is_bitmask else "values",
        "lines": "\n".join(_line(entry.name, entry.value, entry.description) for entry in enum.entries),
    }
    return filled("codec/enum.py.in", values)


def _line(name: str, value: int, description: str) -> str:
    line = f"{name} = {value}"
    room = WIDTH - len(line) - 3
    if not description or room < 20:
        return line
    if len(description) > room:
        description = f"{description[: room - 3].rsplit(' ', 1)[0]} ..."
    return f"{line}  # {description}"
