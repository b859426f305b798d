"""Applies one correction: to attributes of a message, of a field, or of an enum's entry."""

from collections.abc import Callable, Iterable, Set
from dataclasses import field, replace
from typing import TYPE_CHECKING, Any

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.frozen import dataclass
from codegen.measure import UNKNOWN_UNIT
from codegen.model.dialect.dialect import (
    MAX_MESSAGE_ID,
    AttributeCorrection,
    EnumDefinition,
    EnumEntry,
    FieldDefinition,
    MessageDefinition,
)
from codegen.model.dialect.literals import boolean, bounded_number, entry_value, type_and_length
from codegen.model.dialect.wire_types import MAX_ARRAY_LENGTH, VERSION_TYPE, WIRE_TYPES
from codegen.model.units.nearest_unit import nearest_unit
from codegen.model.units.unit import Unit
from codegen.source import Place

if TYPE_CHECKING:
    from codegen.model.spec.spec import Correction

CORRECTION_UNKNOWN = Rule(
    "correction-unknown",
    "The message, field, enum or entry that is to be corrected is not in the dialect. Correct the name; if the dialect "
    "no longer has it, remove the correction.",
    remedy="write the name as the dialect has it; if it is gone from there, remove the correction",
)
CORRECTION_ATTRIBUTE = Rule(
    "correction-attribute",
    "A correction sets id, description or wip of a message; invalid, units, enum, display, instance, multiplier, "
    "minValue, maxValue, increment, default, unchanged, unknown, print_format, description or type of a field; or the "
    "value of an entry; of a parameter of one label, units, minValue, maxValue, increment, enum, default or "
    "description. id and type only of a message that an overlay adds: the other messages have receivers, and none "
    "would accept a message with another CRC_EXTRA.",
    remedy="set an attribute that the XML of the dialect has there, such as units or invalid",
)
CORRECTION_VALUE = Rule(
    "correction-value",
    "The attribute cannot have this value: an id is a number of 24 bits, a type one of the wire's, instance is true or "
    "false, display is bitmask or empty, wip is empty, an enum is one of the dialect, an entry's value is a number "
    "that no other entry has.",
    remedy="write an enum that the dialect has, or add it with an overlay",
)
OBSOLETE_CORRECTION = Rule(
    "obsolete-correction",
    "The dialect already says what the correction sets. Remove it.",
    Severity.WARNING,
    remedy="remove it",
)


@dataclass(frozen=True, slots=True)
class Corrected:
    """Definitions while corrections are applied to them, and after that.

    ``added`` names the messages of overlays; ``places``: by message, field and attribute, where a new text is stated;
    ``of_attributes``: what the corrections changed in messages, fields, entries and parameters of commands;
    ``moving``: the enums and entries that corrections give another value which has not been applied yet.
    """

    messages: dict[str, MessageDefinition]
    enums: dict[str, EnumDefinition]
    added: Set[str]
    places: dict[tuple[str, str, str], Place] = field(default_factory=dict)
    of_attributes: list[AttributeCorrection] = field(default_factory=list)
    moving: set[tuple[str, str]] = field(default_factory=set)


def correct_message(correction: "Correction", result: Corrected, report: Report) -> None:
    """Set attributes of the message itself."""
    message = _message(correction, result, report)
    if message is None:
        return
    for attribute, text in correction.set.items():
        written = " ".join(text.split())
        change = _message_change(correction, message, attribute, written, result.added, report)
        if change is not None:
            before = _message_text(message, attribute)
            result.of_attributes.append(as_stated(correction, (message.name, ""), attribute, written, before))
            message = replace(message, **change)
    result.messages[message.name] = message


def correct_field(correction: "Correction", result: Corrected, report: Report) -> None:
    """Set attributes of a field."""
    message = _message(correction, result, report)
    if message is None:
        return
    name = message.name
    index = next((i for i, field in enumerate(message.fields) if field.name == correction.field), None)
    if index is None:
        hint = did_you_mean(correction.field or "", [field.name for field in message.fields])
        report.add(CORRECTION_UNKNOWN, correction.at("field"), f"{name} has no field {correction.field}", hint)
        return
    new = message.fields[index]
    for attribute, text in correction.set.items():
        written = " ".join(text.split())
        change = _field_change(correction, new, attribute, written, result, report)
        if change is None:
            continue
        before = attribute_text(new, attribute)
        result.of_attributes.append(as_stated(correction, (name, new.name), attribute, written, before))
        new = new._replace(**change)
        result.places[name, new.name, attribute] = correction.place if attribute == "invalid" else correction.at("set")
    fields = (*message.fields[:index], new, *message.fields[index + 1 :])
    result.messages[name] = replace(message, fields=fields)


def as_stated(
    correction: "Correction", corrected: tuple[str, str], attribute: str, text: str, before: str | None
) -> AttributeCorrection:
    """Return what a correction of the project changes in an attribute of ``corrected``, the owner and its part."""
    return AttributeCorrection(
        *corrected,
        attribute=attribute,
        text=text,
        before=before,
        grounds=" ".join(correction.reason.split()),
        place=correction.place,
        source=" ".join(correction.source.split()),
    )


def correct_as_shipped(shipped: AttributeCorrection, result: Corrected) -> None:
    """Set the attribute that a correction states which comes with codegen, and which holds."""
    message = result.messages[shipped.owner]
    key, read = _READ[shipped.attribute]
    change = {key: read(shipped.text)}
    fields = (each._replace(**change) if each.name == shipped.part else each for each in message.fields)
    result.places[shipped.owner, shipped.part, shipped.attribute] = shipped.place
    result.messages[shipped.owner] = replace(message, fields=tuple(fields))


def correct_entry(correction: "Correction", result: Corrected, report: Report) -> None:
    """Set the value of an enum's entry."""
    found = entry_to_correct(correction, result, report)
    if found is None:
        return
    enum, entry = found
    place = correction.at("set")
    for attribute, text in correction.set.items():
        value = entry_value(text)
        if attribute != "value":
            report.add(CORRECTION_ATTRIBUTE, place, f"{entry.name}: {attribute} cannot be corrected", "set value")
        elif value is None:
            report.add(
                CORRECTION_VALUE,
                place,
                f"{entry.name}: the value cannot be {text!r}",
                hint="write a whole number, such as 7 or 0x10",
            )
        elif value == entry.value:
            report.add(OBSOLETE_CORRECTION, place, f"the dialect already has the value {text} for {entry.name}")
        elif holder := _holder(enum, value, result):
            related = [(holder.place, "the other entry")]
            report.add(
                CORRECTION_VALUE,
                place,
                f"{entry.name}: {holder.name} has the value {value}",
                related=related,
                hint="take a number that no other entry has, or correct that one, too",
            )
        else:
            result.moving.discard((enum.name, entry.name))
            before = str(entry.value)
            result.of_attributes.append(as_stated(correction, (enum.name, entry.name), attribute, str(value), before))
            new = entry._replace(value=value, is_implicit=False)
            entries = tuple(new if other is entry else other for other in enum.entries)
            result.enums[enum.name] = replace(enum, entries=entries)


def note_moving(corrections: "Iterable[Correction]", result: Corrected) -> None:
    """Note which entries will have another value than they have, so that two can exchange theirs."""
    for correction in corrections:
        enum = result.enums.get(correction.enum or "")
        entry = enum.entry(correction.entry or "") if enum else None
        text = None if correction.param else correction.set.get("value")
        if enum is not None and entry is not None and text is not None and entry_value(text) != entry.value:
            result.moving.add((enum.name, entry.name))


def _holder(enum: EnumDefinition, value: int, result: Corrected) -> EnumEntry | None:
    """The entry that has a value and keeps it."""
    staying = (each for each in enum.entries if (enum.name, each.name) not in result.moving)
    return next((each for each in staying if each.value == value), None)


def entry_to_correct(
    correction: "Correction", result: Corrected, report: Report
) -> tuple[EnumDefinition, EnumEntry] | None:
    """The enum and the entry that a correction names; None after a finding."""
    name = correction.enum or ""
    enum = result.enums.get(name)
    if enum is None:
        hint = did_you_mean(name, result.enums)
        report.add(CORRECTION_UNKNOWN, correction.at("enum"), f"the dialect has no enum {name}", hint)
        return None
    entry = enum.entry(correction.entry or "")
    if entry is None:
        hint = did_you_mean(correction.entry or "", [entry.name for entry in enum.entries])
        report.add(CORRECTION_UNKNOWN, correction.at("entry"), f"{enum.name} has no entry {correction.entry}", hint)
        return None
    return enum, entry


def _message(correction: "Correction", result: Corrected, report: Report) -> MessageDefinition | None:
    name = correction.message or ""
    message = result.messages.get(name)
    if message is None:
        hint = did_you_mean(name, result.messages)
        report.add(CORRECTION_UNKNOWN, correction.at("message"), f"the dialect has no message {name}", hint)
    return message


def _message_change(
    correction: "Correction", message: MessageDefinition, attribute: str, text: str, added: Set[str], report: Report
) -> dict[str, Any] | None:
    """Return what changes in the definition, by attribute; None where nothing does, after a diagnostic."""
    number = bounded_number(text, MAX_MESSAGE_ID)
    change: dict[str, Any]
    match attribute:
        case "id" if message.name in added:
            change = {"id": number, "written_id": None, "id_place": correction.place}
            is_possible, is_new = number is not None, number != message.id
        case "description":
            change = {"description": text}
            is_possible, is_new = True, text != message.description
        case "wip":
            change = {"lifecycle": replace(message.lifecycle, wip=False)}
            is_possible, is_new = not text, message.lifecycle.wip
        case _:
            _cannot(correction, message.name, attribute, ("id", "description", "wip"), report)
            return None
    return change if _is_accepted(correction, message.name, attribute, text, is_possible, is_new, report) else None


def _message_text(message: MessageDefinition, attribute: str) -> str | None:
    """Return what a message states under one of the attributes that can be corrected; None for nothing."""
    if attribute == "wip":
        return "true" if message.lifecycle.wip else None
    return (message.written_id or str(message.id)) if attribute == "id" else message.description or None


def _text(text: str) -> str:
    return text


def _type(text: str) -> tuple[str, int | None] | None:
    """Element type and array length; None for what a field cannot be."""
    name, written_length = type_and_length(text)
    if name not in WIRE_TYPES or name == VERSION_TYPE:
        return None
    if written_length is None:
        return name, None
    length = bounded_number(written_length, MAX_ARRAY_LENGTH)
    return (name, length) if length else None


_READ: dict[str, tuple[str, Callable[[str], Any]]] = {
    "invalid": ("invalid", _text),
    "units": ("units", _text),
    "enum": ("enum", _text),
    "display": ("is_bitmask", {"": False, "bitmask": True}.get),
    "instance": ("is_instance", lambda text: boolean(text or "false")),
    "multiplier": ("multiplier", _text),
    "minValue": ("minimum", _text),
    "maxValue": ("maximum", _text),
    "increment": ("increment", _text),
    "default": ("default", _text),
    "unchanged": ("unchanged", _text),
    "unknown": ("unknown", _text),
    "print_format": ("print_format", _text),
    "description": ("description", _text),
    "type": ("type", _type),
}
"""Attribute of the definition, and the function that reads its text (None: not a possible value), by XML attribute."""


_VALUES = {
    "id": f"write a number from 0 to {MAX_MESSAGE_ID}",
    "wip": "wip: '' takes it away",
    "display": "write bitmask, or '' for none",
    "instance": "write true or false",
    "type": "write a type such as uint16_t, or char[16]",
}
"""The form of each attribute that cannot be any text."""


def attribute_text(field: FieldDefinition, attribute: str) -> str | None:
    """Return what a definition states under an XML attribute, as text; None where it states nothing."""
    if attribute == "type":
        return field.type if field.length is None else f"{field.type}[{field.length}]"
    value = getattr(field, _READ[attribute][0]) if attribute in _READ else None
    if isinstance(value, bool):
        return {"display": "bitmask"}.get(attribute, "true") if value else None
    return value or None


def is_stated(field: FieldDefinition, attribute: str, text: str) -> bool:
    """Return whether a definition states the text under the attribute already; the empty text is that there is none."""
    return attribute in _READ and (attribute_text(field, attribute) or "") == " ".join(text.split())


def _field_change(
    correction: "Correction", field: FieldDefinition, attribute: str, text: str, result: Corrected, report: Report
) -> dict[str, Any] | None:
    """Return what changes in the definition, by attribute; None where nothing does, after a diagnostic."""
    target = f"{correction.message}.{field.name}"
    if attribute not in _READ or (attribute == "type" and correction.message not in result.added):
        _cannot(correction, target, attribute, _READ, report)
        return None
    key, read = _READ[attribute]
    value = read(text)
    if attribute == "enum" and text and text not in result.enums:
        hint = did_you_mean(text, result.enums)
        report.add(CORRECTION_VALUE, correction.at("set"), f"{target}: there is no enum {text}", hint)
        return None
    if attribute == "units" and text and Unit.parse(text) is None:
        report.add(UNKNOWN_UNIT, correction.at("set"), f"{target}: {text!r} is not a known unit", nearest_unit(text))
        return None
    holder = result.enums.get(field.enum or "")
    is_flags_already = attribute == "display" and value and holder is not None and holder.is_bitmask
    before = (field.type, field.length) if attribute == "type" else getattr(field, key)
    is_new = (before or None) != (value or None) and not is_flags_already
    if not _is_accepted(correction, target, attribute, text, value is not None, is_new, report):
        return None
    if attribute == "type":
        return dict(zip(("type", "length"), value, strict=True))
    return {key: None if value == "" and attribute != "description" else value}


def _cannot(correction: "Correction", target: str, attribute: str, possible: Iterable[str], report: Report) -> None:
    """Report an attribute that does not exist, or that is not to be touched."""
    if attribute in possible:
        hint = "receivers know the message; only what an overlay adds can still change on the wire"
    else:
        hint = did_you_mean(attribute, possible) or ""
    report.add(CORRECTION_ATTRIBUTE, correction.at("set"), f"{target}: {attribute} cannot be corrected", hint)


def _is_accepted(
    correction: "Correction", target: str, attribute: str, text: str, is_possible: bool, is_new: bool, report: Report
) -> bool:
    """Return whether the attribute can have the value and does not have it yet; otherwise that is reported."""
    place = correction.at("set")
    if not is_possible:
        report.add(CORRECTION_VALUE, place, f"{target}: {attribute} cannot be {text!r}", _VALUES.get(attribute))
    elif not is_new:
        report.add(OBSOLETE_CORRECTION, place, f"the dialect already has {attribute} {text!r} for {target}")
    return is_possible and is_new
