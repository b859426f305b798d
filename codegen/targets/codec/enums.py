"""enums.py: the constants of the enums that messages refer to."""

import keyword
from collections.abc import Iterable

from codegen.model.dialect.dialect import Dialect, EnumDefinition, WireMessage
from codegen.tool.template_files import filled

WIDTH = 118
"""Columns of a line with its comment."""


def enums_of(messages: Iterable[WireMessage], dialect: Dialect) -> tuple[EnumDefinition, ...]:
    """The enums that fields of the messages refer to, in the order of their names."""
    names = {field.definition.enum for message in messages for field in message.fields if field.definition.enum}
    return tuple(dialect.enums[name] for name in sorted(names & dialect.enums.keys()))


def enums_text(enums: Iterable[EnumDefinition]) -> str:
    """The module with a constant for each entry: ``NAME = value  # what it means``.

    A name that two enums have stands for the value of the first; that of the other is a comment.
    """
    taken: dict[str, int] = {}
    blocks = []
    for enum in enums:
        lines = [f"# {enum.name}{': bits, to be combined' if enum.is_bitmask else ''}"]
        for entry in enum.entries:
            name = f"{entry.name}_" if keyword.iskeyword(entry.name) else entry.name
            line = _line(name, entry.value, entry.description)
            lines.append(line if taken.setdefault(name, entry.value) == entry.value else f"# {line}")
        blocks.append("\n".join(lines))
    return filled(
        "codec/enums.py.in", {"enums": "\n\n".join(blocks) or "# The fields of these messages refer to none."}
    )


def _line(name: str, value: int, description: str) -> str:
    line = f"{name} = {value}"
    room = WIDTH - len(line) - 3
    if not description or room < 20:
        return line
    if len(description) > room:
        description = f"{description[: room - 3].rsplit(' ', 1)[0]} ..."
    return f"{line}  # {description}"
