"""``<message>`` and ``<field>`` of a dialect file."""

from codegen.decode.dialect.element import LIFECYCLE, ElementReader, one_line
from codegen.diagnostics import Rule, Severity, did_you_mean
from codegen.load.xml_tree import XmlElement
from codegen.model.dialect.dialect import MAX_MESSAGE_ID, UNNUMBERED, FieldDefinition, MessageDefinition
from codegen.model.dialect.literals import bounded_number, type_and_length
from codegen.model.dialect.wire_types import MAX_ARRAY_LENGTH, VERSION_TYPE, WIRE_TYPES

MAX_FIELDS = 64

FIELD_COUNT = Rule(
    "message-field-count",
    "A message has 1 to 64 fields; generators and receivers are built for no more.",
    remedy="give the message 1 to 64 fields, or make two messages of it",
)
REPEATED_EXTENSIONS = Rule(
    "message-extensions-repeated",
    "One <extensions/> divides the base fields from the extensions; a second one has no meaning. Remove it.",
    remedy="remove it: what follows the first one are extensions",
)
DUPLICATE_FIELD = Rule(
    "field-duplicate",
    "Two fields of a message have the same name, be it in capitals or in small letters: constants are called by it. "
    "Rename or remove one; the second is not read.",
    remedy="rename the field, or remove one of the two",
)
UNKNOWN_FIELD_TYPE = Rule(
    "field-type",
    "The type of a field is one of MAVLink's element types, for an array with its length: uint16_t, char[16].",
    remedy="write a type such as uint16_t, or char[16] for a text",
)
BAD_ARRAY_LENGTH = Rule(
    "field-array-length",
    "An array has 1 to 255 elements: its length is one byte of CRC_EXTRA, and a payload holds 255 bytes.",
)
UNKNOWN_DISPLAY = Rule(
    "field-display",
    "The only value of display that has a meaning is bitmask.",
    Severity.WARNING,
)

_MESSAGE_ATTRIBUTES = frozenset({"id", "name"})
_MESSAGE_CHILDREN = frozenset({*LIFECYCLE, "description", "field", "extensions"})
_FIELD_ATTRIBUTES = frozenset(
    {
        "type",
        "name",
        "print_format",
        "enum",
        "display",
        "units",
        "increment",
        "minValue",
        "maxValue",
        "multiplier",
        "default",
        "instance",
        "invalid",
    }
)
_FIELD_CHILDREN = frozenset({"description"})


def decode_message(element: XmlElement, read: ElementReader) -> MessageDefinition | None:
    """The message, without the fields that cannot be read; None if it has no usable name, or no id at all.

    An id that is no number is not reported yet: a correction may state one.
    """
    read.expect(element, _MESSAGE_ATTRIBUTES, _MESSAGE_CHILDREN)
    name = read.name(element)
    written_id = read.required(element, "id")
    lifecycle = read.lifecycle(element)
    fields = _fields(element, name, read)
    if name is None or written_id is None:
        return None
    number = bounded_number(written_id, MAX_MESSAGE_ID)
    return MessageDefinition(
        id=UNNUMBERED if number is None else number,
        name=name,
        fields=fields,
        description=read.description(element),
        place=read.place(element),
        lifecycle=lifecycle,
        written_id=written_id if number is None else None,
    )


def _fields(message: XmlElement, name: str | None, read: ElementReader) -> tuple[FieldDefinition, ...]:
    shown = name or "the message"
    fields: dict[str, FieldDefinition] = {}
    is_extension = False
    written = 0
    for child in message.children:
        if child.tag == "extensions":
            if is_extension:
                read.report.add(REPEATED_EXTENSIONS, read.place(child), f"{shown} has a second <extensions/>")
            is_extension = True
        elif child.tag == "field":
            written += 1
            field = _field(child, is_extension, read)
            if field is None:
                continue
            first = fields.setdefault(field.name.lower(), field)
            if first is not field:
                related = [(first.place, "the first one")]
                problem = f"{shown} has a second field {field.name}"
                problem += "" if first.name == field.name else f", as {first.name}"
                read.report.add(DUPLICATE_FIELD, field.place, problem, related=related)
    if not 1 <= written <= MAX_FIELDS:
        read.report.add(FIELD_COUNT, read.place(message), f"{shown} has {written or 'no'} fields")
    return tuple(fields.values())


def _field(element: XmlElement, is_extension: bool, read: ElementReader) -> FieldDefinition | None:
    read.expect(element, _FIELD_ATTRIBUTES, _FIELD_CHILDREN)
    attributes = element.attributes
    name = read.name(element)
    wire_type = _type(element, read)
    is_instance = read.boolean(element, "instance")
    display = attributes.get("display")
    if display not in (None, "", "bitmask"):
        message = f"display {display!r} has no meaning"
        read.report.add(UNKNOWN_DISPLAY, read.place(element), message, 'write display="bitmask" or leave it out')
    if name is None or wire_type is None:
        return None
    return FieldDefinition(
        name=name,
        type=wire_type[0],
        length=wire_type[1],
        is_extension=is_extension,
        place=read.place(element),
        units=one_line(attributes.get("units", "")) or None,
        enum=attributes.get("enum"),
        is_bitmask=display == "bitmask",
        is_instance=is_instance,
        multiplier=attributes.get("multiplier"),
        minimum=attributes.get("minValue"),
        maximum=attributes.get("maxValue"),
        invalid=attributes.get("invalid"),
        print_format=attributes.get("print_format"),
        increment=attributes.get("increment"),
        default=attributes.get("default"),
        description=one_line(element.text) or read.description(element),
    )


def _type(element: XmlElement, read: ElementReader) -> tuple[str, int | None] | None:
    """Element type and array length (None for a scalar) of a field, or None after a diagnostic."""
    text = read.required(element, "type")
    if text is None:
        return None
    name, written_length = type_and_length(text)
    if name not in WIRE_TYPES or (written_length is not None and name == VERSION_TYPE):
        hint = did_you_mean(name, WIRE_TYPES)
        read.report.add(UNKNOWN_FIELD_TYPE, read.place(element), f"there is no field type {text!r}", hint)
        return None
    if written_length is None:
        return name, None
    length = bounded_number(written_length, MAX_ARRAY_LENGTH)
    if not length:
        message = f"{written_length!r} cannot be the length of an array"
        read.report.add(BAD_ARRAY_LENGTH, read.place(element), message, f"use 1 to {MAX_ARRAY_LENGTH}")
        return None
    return name, length
