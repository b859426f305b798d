"""The codec's page: how to use it, and what is in it, message by message."""

from collections.abc import Callable, Iterable, Mapping, Sequence

from codegen.model.dialect.dialect import EnumDefinition, Kind, WireField, WireMessage
from codegen.targets.codec.layout import type_text, unknown_text
from codegen.targets.codec.runtime import has_doubles
from codegen.targets.naming import class_names
from codegen.tool.template_files import filled


def page_text(dialect: str, messages: Sequence[WireMessage], enums: Sequence[EnumDefinition]) -> str:
    """The page about a codec with at least one message."""
    classes = class_names(message.name for message in messages)
    example, field = _example(messages, _is_simple)
    values = {
        "dialect": dialect,
        "count": f"{len(messages)} message{'' if len(messages) == 1 else 's'}",
        "class_name": classes[example.name],
        "lowered": example.name.lower(),
        "field": field.name,
        "value": '"text"' if field.type.kind is Kind.CHAR else f"[1] * {field.count}" if field.is_array else "1",
        "live": _live(messages, classes),
        "doubles": _doubles(messages),
        "longest": max(message.length for message in messages),
        "enums": _enums(enums),
        "messages": "".join(_message(message, classes[message.name]) for message in messages),
    }
    return filled("codec/README.md.in", values)


def _live(messages: Iterable[WireMessage], classes: Mapping[str, str]) -> str:
    """The section about live fields; empty where no message has a field that can be one."""
    message, field = _example(messages, _is_live)
    if not _is_live(field):
        return ""
    return filled("codec/live_page.md.in", {"class_name": classes[message.name], "field": field.name})


def _doubles(messages: Iterable[WireMessage]) -> str:
    """The section about doubles; empty where no message has one."""
    if not has_doubles(messages):
        return ""
    message, field = _example(messages, _is_double)
    return filled("codec/doubles_page.md.in", {"name": message.name, "field": field.name})


def _is_double(field: WireField) -> bool:
    return field.type.code == "d"


def _is_simple(field: WireField) -> bool:
    return field.type.kind is not Kind.CHAR and not field.is_array


def _is_live(field: WireField) -> bool:
    return field.type.is_integer and field.type.size <= 4 and not field.is_array


def _example(messages: Iterable[WireMessage], fits: Callable[[WireField], bool]) -> tuple[WireMessage, WireField]:
    """A message and a field of it for an example: one that fits, with a unit if there is such."""
    found = [(message, field) for message in messages for field in message.fields]
    found.sort(key=lambda pair: (not fits(pair[1]), not pair[1].definition.units))
    return found[0]


def _enums(enums: Sequence[EnumDefinition]) -> str:
    if not enums:
        return "The fields of these messages refer to no enum."
    listed = "\n".join(f"- `{enum.name}`: {len(enum.entries)}" for enum in enums)
    example = enums[0].entries[0].name if enums[0].entries else "..."
    return (
        f"`from enums import {example}`. Whoever needs only a few of them saves memory by writing them down, or with "
        f"`--enums` when the codec is made. How many entries each has:\n\n{listed}"
    )


def _message(message: WireMessage, class_name: str) -> str:
    lengths = f"{message.base_length} bytes"
    if message.length != message.base_length:
        lengths += f", {message.length} with extensions"
    description = message.definition.description
    values = {
        "name": message.name,
        "class_name": class_name,
        "id": message.id,
        "crc_extra": message.crc_extra,
        "lengths": lengths,
        "description": f" {description}" if description else "",
        "rows": "\n".join(_row(field) for field in message.fields),
    }
    return filled("codec/message_page.md.in", values)


def _row(field: WireField) -> str:
    definition = field.definition
    extension = " (extension)" if definition.is_extension else ""
    unit = field.unit_text
    enum = f"`{definition.enum}`" if definition.enum else ""
    description = definition.description.replace("|", "\\|")
    return f"| {field.name}{extension} | {type_text(field)} | {unit} | {enum} | {unknown_text(field)} | {description} |"
