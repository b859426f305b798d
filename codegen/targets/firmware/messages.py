"""View of messages.py: the layout of each populated message."""

from dataclasses import dataclass

from codegen.model.dialect import Kind, WireField, WireMessage
from codegen.model.system import System
from codegen.targets.naming import class_name


@dataclass(frozen=True, slots=True)
class FieldView:
    """A field in wire order: its ``struct`` code, ``count`` 0 for a scalar, unit and enum as the comment."""

    name: str
    code: str
    offset: int
    count: int
    comment: str


@dataclass(frozen=True, slots=True)
class MessageView:
    """One message class."""

    name: str
    class_name: str
    id: int
    crc_extra: int
    base_length: int
    length: int
    fields: tuple[FieldView, ...]


def message_views(system: System) -> tuple[MessageView, ...]:
    """The classes of the populated messages, in order of id."""
    return tuple(_message(message.wire) for message in system.messages)


def _message(wire: WireMessage) -> MessageView:
    return MessageView(
        name=wire.name,
        class_name=class_name(wire.name),
        id=wire.id,
        crc_extra=wire.crc_extra,
        base_length=wire.base_length,
        length=wire.length,
        fields=tuple(_field(field) for field in wire.fields),
    )


def _field(field: WireField) -> FieldView:
    definition = field.definition
    is_text = field.type.kind is Kind.CHAR
    notes = [note for note in (definition.units, definition.enum) if note]
    if definition.is_extension:
        notes.append("extension")
    return FieldView(
        name=field.name,
        code="s" if is_text else field.type.code,
        offset=field.offset,
        count=definition.length or 0,
        comment=", ".join(notes),
    )
