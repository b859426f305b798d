"""Corrections of a dialect: attributes that its XML states wrongly, or only in a description."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.model.dialect import EnumDefinition, FieldDefinition, MessageDefinition
from codegen.model.literals import boolean, entry_value
from codegen.source import Place

if TYPE_CHECKING:
    from codegen.model.spec import Correction

CORRECTION_TARGET = Rule(
    "correction-target",
    "A correction names a message and a field, or an enum and an entry: exactly one of the two pairs.",
)
CORRECTION_UNKNOWN = Rule(
    "correction-unknown",
    "The message, field, enum or entry that is to be corrected is not in the dialect. Correct the name; if the dialect "
    "no longer has it, remove the correction.",
)
CORRECTION_ATTRIBUTE = Rule(
    "correction-attribute",
    "A correction sets invalid, units, enum, display, instance, multiplier, minValue or maxValue of a field, or the "
    "value of an entry. Types and names cannot be corrected: that would change CRC_EXTRA, and no receiver would accept "
    "the message.",
)
CORRECTED_TWICE = Rule(
    "corrected-twice",
    "Two corrections set the same attribute of the same field or entry. Keep the one that is right.",
)
CORRECTION_VALUE = Rule(
    "correction-value",
    "The attribute cannot have this value: instance is true or false, display is bitmask or empty, an enum is one of "
    "the dialect, an entry's value is a number that no other entry has.",
)
CORRECTION_UNFOUNDED = Rule(
    "correction-unfounded",
    "Whoever reads the specification has to be able to check a correction: state the reason and the source.",
)
OBSOLETE_CORRECTION = Rule(
    "obsolete-correction",
    "The dialect already says what the correction sets. Remove it.",
    Severity.WARNING,
)


@dataclass(frozen=True, slots=True)
class Corrected:
    """Definitions after all corrections; ``sentinel_places``: by message and field, where a new sentinel is stated."""

    messages: dict[str, MessageDefinition]
    enums: dict[str, EnumDefinition]
    sentinel_places: Mapping[tuple[str, str], Place]


def apply_corrections(
    messages: Mapping[str, MessageDefinition],
    enums: Mapping[str, EnumDefinition],
    corrections: "tuple[Correction, ...]",
    report: Report,
) -> Corrected:
    """``messages`` and ``enums`` with the corrections applied in their order.

    A correction with an error, or each single attribute that has one, is reported at its place and left out. The empty
    text removes an attribute.
    """
    new_messages, new_enums = dict(messages), dict(enums)
    sentinel_places: dict[tuple[str, str], Place] = {}
    _check_unique(corrections, report)
    for correction in corrections:
        _check_grounds(correction, report)
        names_field = correction.message is not None and correction.field is not None
        names_entry = correction.enum is not None and correction.entry is not None
        written = [correction.message, correction.field, correction.enum, correction.entry]
        if names_field == names_entry or sum(name is not None for name in written) != 2:
            report.add(CORRECTION_TARGET, correction.place, "write message and field, or enum and entry")
        elif names_field:
            _correct_field(correction, new_messages, new_enums, sentinel_places, report)
        else:
            _correct_entry(correction, new_enums, report)
    return Corrected(new_messages, new_enums, sentinel_places)


def _check_unique(corrections: "tuple[Correction, ...]", report: Report) -> None:
    """Two corrections of one attribute contradict each other, or one of them says nothing."""
    places: dict[tuple[str | None, ...], Place] = {}
    for correction in corrections:
        for attribute in correction.set:
            target = (correction.message, correction.field, correction.enum, correction.entry, attribute)
            first = places.setdefault(target, correction.place)
            if first is not correction.place:
                related = [(first, "the first correction is here")]
                report.add(CORRECTED_TWICE, correction.place, f"{attribute} is corrected twice", None, related)


def _check_grounds(correction: "Correction", report: Report) -> None:
    for key, text in (("reason", correction.reason), ("source", correction.source)):
        if not text.strip():
            report.add(CORRECTION_UNFOUNDED, correction.at(key), f"the {key} is empty")
    if not correction.set:
        report.add(CORRECTION_ATTRIBUTE, correction.at("set"), "the correction sets nothing")


def _correct_field(
    correction: "Correction",
    messages: dict[str, MessageDefinition],
    enums: Mapping[str, EnumDefinition],
    sentinel_places: dict[tuple[str, str], Place],
    report: Report,
) -> None:
    name = correction.message or ""
    message = messages.get(name)
    if message is None:
        hint = did_you_mean(name, messages)
        report.add(CORRECTION_UNKNOWN, correction.at("message"), f"the dialect has no message {name}", hint)
        return
    index = next((i for i, field in enumerate(message.fields) if field.name == correction.field), None)
    if index is None:
        hint = did_you_mean(correction.field or "", [field.name for field in message.fields])
        report.add(CORRECTION_UNKNOWN, correction.at("field"), f"{name} has no field {correction.field}", hint)
        return
    field = message.fields[index]
    for attribute, text in correction.set.items():
        before = field
        field = _with_attribute(correction, before, attribute, text.strip(), enums, report)
        if attribute == "invalid" and field is not before:
            sentinel_places[name, field.name] = correction.place
    fields = (*message.fields[:index], field, *message.fields[index + 1 :])
    messages[name] = replace(message, fields=fields)


def _text(text: str) -> str:
    return text


_READ: dict[str, tuple[str, Callable[[str], Any]]] = {
    "invalid": ("invalid", _text),
    "units": ("units", _text),
    "enum": ("enum", _text),
    "display": ("is_bitmask", {"": False, "bitmask": True}.get),
    "instance": ("is_instance", lambda text: boolean(text or "false")),
    "multiplier": ("multiplier", _text),
    "minValue": ("minimum", _text),
    "maxValue": ("maximum", _text),
}
"""Attribute of the definition, and the function that reads its text (None: not a possible value), by XML attribute."""


def _with_attribute(
    correction: "Correction",
    field: FieldDefinition,
    attribute: str,
    text: str,
    enums: Mapping[str, EnumDefinition],
    report: Report,
) -> FieldDefinition:
    place = correction.at("set")
    target = f"{correction.message}.{correction.field}"
    if attribute not in _READ:
        hint = did_you_mean(attribute, _READ)
        report.add(CORRECTION_ATTRIBUTE, place, f"{target}: {attribute} cannot be corrected", hint)
        return field
    key, read = _READ[attribute]
    value = read(text)
    if value is None:
        report.add(CORRECTION_VALUE, place, f"{target}: {attribute} cannot be {text!r}")
        return field
    if attribute == "enum" and text and text not in enums:
        report.add(CORRECTION_VALUE, place, f"{target}: there is no enum {text}", did_you_mean(text, enums))
        return field
    holder = enums.get(field.enum or "")
    is_flags_already = attribute == "display" and value and holder is not None and holder.is_bitmask
    if (getattr(field, key) or None) == (value or None) or is_flags_already:
        report.add(OBSOLETE_CORRECTION, place, f"the dialect already has {attribute} {text!r} for {target}")
        return field
    change: dict[str, Any] = {key: None if value == "" else value}
    return field._replace(**change)


def _correct_entry(correction: "Correction", enums: dict[str, EnumDefinition], report: Report) -> None:
    name = correction.enum or ""
    enum = enums.get(name)
    if enum is None:
        hint = did_you_mean(name, enums)
        report.add(CORRECTION_UNKNOWN, correction.at("enum"), f"the dialect has no enum {name}", hint)
        return
    entry = enum.entry(correction.entry or "")
    if entry is None:
        hint = did_you_mean(correction.entry or "", [entry.name for entry in enum.entries])
        report.add(CORRECTION_UNKNOWN, correction.at("entry"), f"{name} has no entry {correction.entry}", hint)
        return
    place = correction.at("set")
    for attribute, text in correction.set.items():
        value = entry_value(text)
        if attribute != "value":
            report.add(CORRECTION_ATTRIBUTE, place, f"{entry.name}: {attribute} cannot be corrected", "set value")
        elif value is None:
            report.add(CORRECTION_VALUE, place, f"{entry.name}: the value cannot be {text!r}")
        elif value == entry.value:
            report.add(OBSOLETE_CORRECTION, place, f"the dialect already has the value {text} for {entry.name}")
        elif holder := next((other for other in enum.entries if other.value == value), None):
            related = [(holder.place, "the other entry")]
            report.add(CORRECTION_VALUE, place, f"{entry.name}: {holder.name} has the value {value}", related=related)
        else:
            new = entry._replace(value=value, is_implicit=False)
            enums[name] = replace(enum, entries=tuple(new if other is entry else other for other in enum.entries))
