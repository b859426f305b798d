"""Corrections of a dialect: attributes that its XML states wrongly, or only in a description."""

from collections.abc import Mapping, Set
from typing import TYPE_CHECKING

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.carried_entries import is_beyond, widest, words
from codegen.model.dialect.dialect import EnumDefinition, MessageDefinition, Standing
from codegen.resolve.dialect.corrected import (
    CORRECTION_ATTRIBUTE,
    CORRECTION_VALUE,
    Corrected,
    correct_as_shipped,
    correct_entry,
    correct_field,
    correct_message,
    note_moving,
)
from codegen.resolve.dialect.corrected_parameter import correct_parameter
from codegen.resolve.dialect.patterns import expanded
from codegen.resolve.dialect.shipped import shipped_corrections
from codegen.source import Place

if TYPE_CHECKING:
    from codegen.model.spec.spec import Correction, Refusal, ShippedCorrection

CORRECTION_TARGET = Rule(
    "correction-target",
    "A correction names a message, a message and a field of it (or fields, a pattern), or an enum and an entry of it, "
    "of which param is a parameter.",
)
CORRECTED_TWICE = Rule(
    "corrected-twice",
    "Two corrections set the same attribute of the same message, field or entry. Keep the one that is right.",
    remedy="keep the one that is right",
)
CORRECTION_UNFOUNDED = Rule(
    "correction-unfounded",
    "Whoever reads the specification has to be able to check a correction: state the reason and the source.",
    remedy="write why the dialect is wrong, and where that can be looked up",
)


def apply_corrections(
    messages: Mapping[str, MessageDefinition],
    enums: Mapping[str, EnumDefinition],
    corrections: "tuple[Correction, ...]",
    report: Report,
    added: Set[str] = frozenset(),
    shipped: "tuple[ShippedCorrection, ...]" = (),
    refusals: "tuple[Refusal, ...]" = (),
) -> Corrected:
    """``messages`` and ``enums`` with the corrections applied in their order, those that come with codegen first.

    A correction with an error, or each single attribute that has one, is reported at its place and left out. The empty
    text removes an attribute. ``added`` are the messages of overlays: only of these the id and types can be corrected.
    ``shipped`` come with codegen; ``refusals`` are those of the project.
    """
    result = Corrected(dict(messages), dict(enums), added)
    for correction in corrections:
        _check_grounds(correction, report)
    corrections = expanded(corrections, messages, report)
    _check_unique(corrections, report)
    own = {(each.message, each.field, attribute) for each in corrections for attribute in each.set}
    for of_attribute in shipped_corrections(messages, shipped, own, refusals, report):
        result.of_attributes.append(of_attribute)
        if of_attribute.standing is Standing.APPLIED:
            correct_as_shipped(of_attribute, result)
    note_moving(corrections, result)
    for correction in corrections:
        written = (correction.message, correction.field, correction.fields, correction.enum, correction.entry)
        match tuple(name is not None for name in written):
            case (True, True, False, False, False) | (True, False, True, False, False):
                correct_field(correction, result, report)
            case (True, False, False, False, False):
                correct_message(correction, result, report)
            case (False, False, False, True, True) if correction.param is not None:
                correct_parameter(correction, result, report)
            case (False, False, False, True, True):
                correct_entry(correction, result, report)
            case _:
                hint = "write message, message and field or fields, or enum and entry, and param for one of a command"
                report.add(CORRECTION_TARGET, correction.place, "it is not clear what is to be corrected", hint)
    for correction in corrections:
        _check_carried(correction, result, report)
    return result


def _check_unique(corrections: "tuple[Correction, ...]", report: Report) -> None:
    """Two corrections of one attribute contradict each other, or one of them says nothing."""
    places: dict[tuple[str | None, ...], Place] = {}
    for correction in corrections:
        for attribute in correction.set:
            entry = (correction.enum, correction.entry, correction.param)
            target = (correction.message, correction.field, *entry, attribute)
            first = places.setdefault(target, correction.place)
            if first is not correction.place:
                related = [(first, "the first correction is here")]
                report.add(CORRECTED_TWICE, correction.place, f"{attribute} is corrected twice", None, related)


def _check_carried(correction: "Correction", result: Corrected, report: Report) -> None:
    """Report the number of an entry that no field carries, once all types are corrected."""
    enum = result.enums.get(correction.enum or "")
    entry = enum.entry(correction.entry or "") if enum else None
    if enum is None or entry is None or correction.param is not None or "value" not in correction.set:
        return
    carrier = widest(enum.name, result.messages.values(), result.enums)
    if carrier is not None and is_beyond(entry, carrier):
        report.add(CORRECTION_VALUE, correction.at("set"), *words(entry, enum.name, carrier))


def _check_grounds(correction: "Correction", report: Report) -> None:
    for key, text in (("reason", correction.reason), ("source", correction.source)):
        if not text.strip():
            report.add(CORRECTION_UNFOUNDED, correction.at(key), f"the {key} is empty")
    if not correction.set:
        report.add(
            CORRECTION_ATTRIBUTE,
            correction.at("set"),
            "the correction sets nothing",
            hint="set: {attribute: value}, or remove it",
        )
