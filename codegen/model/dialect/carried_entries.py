"""The fields that carry the entries of an enum."""

from collections.abc import Iterable, Mapping

from codegen.model.dialect.dialect import EnumDefinition, EnumEntry, FieldDefinition, MessageDefinition
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.source import Place

Carrier = tuple[MessageDefinition, FieldDefinition]


def widest(enum: str, messages: Iterable[MessageDefinition], enums: Mapping[str, EnumDefinition]) -> Carrier | None:
    """Return the widest field that has an enum.

    None where nothing has the enum, and where a float does: that carries any number, as parameters of commands do.
    """
    carriers = [(message, each) for message in messages for each in message.fields if each.enum == enum]
    if not carriers or not all(WIRE_TYPES[field.type].is_integer for _, field in carriers):
        return None
    parameters = (each for other in enums.values() for command in other.entries for each in command.parameters)
    if any(dict(parameter.attributes).get("enum") == enum for parameter in parameters):
        return None
    return max(carriers, key=lambda each: WIRE_TYPES[each[1].type].maximum)


def is_beyond(entry: EnumEntry, carrier: Carrier) -> bool:
    """Return whether a field does not carry the value of an entry."""
    return entry.value > WIRE_TYPES[carrier[1].type].maximum


def words(entry: EnumEntry, enum: str, carrier: Carrier) -> tuple[str, str, tuple[tuple[Place, str]]]:
    """Return message, hint and related place of a finding about an entry that even the widest carrier does not hold."""
    message, field = carrier
    name = f"{message.name}.{field.name}"
    text = f"{entry.name}: no field with {enum} carries {entry.value}: {name} is {field.type}"
    hint = f"take a number up to {WIRE_TYPES[field.type].maximum}"
    return text, hint, ((field.place, f"{name} is declared here"),)
