"""messages.py and message_fields.py: the layout of each message, and its fields in the words of the dialect."""

import math
from collections.abc import Iterable

from codegen.model.dialect.dialect import Kind, Sentinel, SentinelForm, WireField, WireMessage
from codegen.model.dialect.wire_types import VERSION_TYPE
from codegen.targets.naming import class_names, prose
from codegen.targets.origin import Origin, headed
from codegen.tool.template_files import filled

WIDTH = 104
"""Columns of a literal with field words, without indentation and quotes."""


def message_files(folder: str, messages: Iterable[WireMessage], version: int, origin: Origin) -> dict[str, str]:
    """The classes of the messages, and, in a module of their own, their fields: most programs do without names."""
    known = tuple(messages)
    return {
        f"{folder}messages.py": headed(messages_text(known, version), origin),
        f"{folder}message_fields.py": headed(fields_text(known), origin),
    }


def fields_text(messages: Iterable[WireMessage]) -> str:
    """The module with the field words of each of the messages."""
    words = [(wire.id, _literal([field_word(field) for field in wire.fields])) for wire in messages]
    return filled("codec/message_fields.py.in", {"fields": "".join(f"    {at}: {text},\n" for at, text in words)})


def messages_text(messages: Iterable[WireMessage], version: int) -> str:
    """The module with a class for each of the messages, in the order given; ``version`` is that of their dialect."""
    known = tuple(messages)
    classes = class_names(wire.name for wire in known)
    listed = "".join(f"    {name},\n" for name in classes.values())
    everything = f"(\n{listed})" if len(classes) > 1 else f"({', '.join(classes.values())},)" if classes else "()"
    bodies = "".join(_class(wire, classes[wire.name], version) for wire in known)
    return filled("codec/messages.py.in", {"classes": bodies, "all": everything})


def _class(wire: WireMessage, class_name: str, version: int) -> str:
    versions = [field.name for field in wire.fields if field.definition.type == VERSION_TYPE]
    values = {
        "name": wire.name,
        "class_name": class_name,
        "id": wire.id,
        "crc_extra": wire.crc_extra,
        "base_length": wire.base_length,
        "length": wire.length,
        "lines": "\n".join(f"    {_line(field)}" for field in wire.fields),
        "defaults": "".join(f'    DEFAULTS = {{"{name}": {version}}}\n' for name in versions[:1]),
        "targets": _targets(wire),
    }
    return filled("codec/message_class.py.in", values)


def field_word(field: WireField) -> str:
    """A field as message_fields.py has it: ``voltages:10H=65535`` (templates/codec/fields.py reads it)."""
    code = "s" if field.type.kind is Kind.CHAR else field.type.code
    unknown = "" if field.sentinel is None else f"={_sentinel_text(field, field.sentinel)}"
    return f"{field.name}:{field.count if field.is_array else ''}{code}{unknown}"


def _targets(wire: WireMessage) -> str:
    """The line that says where the payload has its target system and component; nothing where it has none."""
    return f"    TARGETS = {wire.targets}\n" if wire.targets else ""


def type_text(field: WireField) -> str:
    """The type as people write it: ``uint16[10]``."""
    name = field.type.name.removesuffix("_t")
    return f"{name}[{field.count}]" if field.is_array else name


def unknown_text(field: WireField) -> str:
    """Return what means unknown in a field, in words; empty without a sentinel."""
    sentinel = field.sentinel
    if sentinel is None:
        return ""
    shown = _sentinel_text(field, sentinel)
    if field.type.kind is Kind.CHAR:
        return "empty text" if not any(sentinel.values) else f"characters {shown}"
    if sentinel.form is SentinelForm.FIRST:
        return f"{shown[:-1]} in element 0"
    if sentinel.form is SentinelForm.POSITIONS:
        return f"{shown} by element"
    if shown.endswith("*"):
        return f"{shown[:-1]} in all elements"
    return f"{shown} in an element" if field.is_array else shown


def _sentinel_text(field: WireField, sentinel: Sentinel) -> str:
    if sentinel.form is SentinelForm.POSITIONS:
        return ",".join("" if value is None else _number(value) for value in sentinel.values)
    shown = _number(sentinel.values[0] or 0)
    if sentinel.form is SentinelForm.VALUE and field.is_array and field.type.kind is not Kind.CHAR:
        return f"{shown}*"
    return f"{shown}:" if sentinel.form is SentinelForm.FIRST else shown


def _number(value: float) -> str:
    if math.isnan(value):
        return "nan"
    return str(int(value)) if value == int(value) else repr(value)


def _line(field: WireField) -> str:
    definition = field.definition
    notes = [type_text(field)]
    notes += [prose(note) for note in (field.unit_text, definition.enum) if note]
    if field.sentinel is not None:
        notes.append(f"unknown: {unknown_text(field)}")
    if definition.is_extension:
        notes.append("extension")
    return f"{field.name}: {', '.join(notes)}"


def _literal(words: list[str]) -> str:
    """The words as one text literal, in lines that stay readable."""
    lines = [""]
    for word in words:
        if lines[-1] and len(lines[-1]) + len(word) > WIDTH:
            lines.append("")
        lines[-1] += word + " "
    lines[-1] = lines[-1].rstrip()
    if len(lines) == 1:
        return f'"{lines[0]}"'
    return "(\n" + "".join(f'        "{line}"\n' for line in lines) + "    )"
