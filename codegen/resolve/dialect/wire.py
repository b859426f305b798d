"""The layout of a message on the wire: order, offsets and lengths of its fields, and its CRC_EXTRA."""

from binascii import crc_hqx
from collections.abc import Iterable, Mapping

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.dialect import EnumDefinition, FieldDefinition, MessageDefinition, WireField, WireMessage
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.resolve.dialect.field_numbers import field_multiplier
from codegen.resolve.dialect.sentinel import sentinel_of
from codegen.source import Place

__all__ = ["MAX_PAYLOAD", "PAYLOAD_TOO_LONG", "WIRE_TYPES", "crc_extra", "crc_mcrf4xx", "wire_message", "wire_order"]

MAX_PAYLOAD = 255

PAYLOAD_TOO_LONG = Rule(
    "message-payload",
    "The payload of a message has at most 255 bytes, because its length is one byte of the frame. Shorten an array, "
    "use smaller types, or divide the message.",
)


_REVERSED = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))
"""Each byte with its bits in the other order."""


def crc_mcrf4xx(data: bytes, crc: int = 0xFFFF) -> int:
    """CRC-16/MCRF4XX of ``data`` (reflected polynomial 0x8408), continued from ``crc``; 16 bits.

    That of Python's own library goes through bits in the other order.
    """
    return _reversed(crc_hqx(data.translate(_REVERSED), _reversed(crc)))


def _reversed(crc: int) -> int:
    return _REVERSED[crc & 0xFF] << 8 | _REVERSED[crc >> 8]


def crc_extra(name: str, base_fields: Iterable[FieldDefinition]) -> int:
    """The byte that ties a frame to the definition of its message: ``base_fields`` in wire order, no extensions.

    Low byte XOR high byte of the CRC over the name and, for each field, type, name and array length (MAVLink guide,
    serialization).
    """
    text = bytearray(f"{name} ".encode())
    for field in base_fields:
        text += f"{WIRE_TYPES[field.type].name} {field.name} ".encode()
        if field.length is not None:
            text.append(field.length)
    crc = crc_mcrf4xx(bytes(text))
    return (crc & 0xFF) ^ (crc >> 8)


def wire_order(fields: Iterable[FieldDefinition]) -> tuple[list[FieldDefinition], list[FieldDefinition]]:
    """Base fields, stably sorted by element size with the largest first, and extensions in XML order."""
    base: list[FieldDefinition] = []
    extensions: list[FieldDefinition] = []
    for field in fields:
        (extensions if field.is_extension else base).append(field)
    base.sort(key=lambda field: -WIRE_TYPES[field.type].size)
    return base, extensions


def wire_message(
    definition: MessageDefinition,
    enums: Mapping[str, EnumDefinition],
    places: Mapping[tuple[str, str, str], Place],
    report: Report,
) -> WireMessage:
    """The message with every field's place in the payload and its sentinel.

    ``places`` has, by message, field and attribute, the places of what a correction states. A payload of more than
    255 bytes is reported and computed all the same.
    """
    base, extensions = wire_order(definition.fields)
    fields: list[WireField] = []
    offset = base_length = 0
    for field in (*base, *extensions):
        wire_type = WIRE_TYPES[field.type]
        count = 1 if field.length is None else field.length
        sentinel = None
        if field.invalid:
            place = places.get((definition.name, field.name, "invalid"), field.place)
            sentinel = sentinel_of(field, wire_type, enums.get(field.enum or ""), place, report)
        multiplier = field_multiplier(definition.name, field, places, report)
        fields.append(WireField(field, wire_type, offset, count, sentinel, multiplier))
        offset += wire_type.size * count
        if not field.is_extension:
            base_length = offset
    if offset > MAX_PAYLOAD:
        message = f"{definition.name} has a payload of {offset} bytes"
        report.add(PAYLOAD_TOO_LONG, definition.place, message, f"a payload has at most {MAX_PAYLOAD}")
    return WireMessage(definition, tuple(fields), crc_extra(definition.name, base), base_length, offset)
