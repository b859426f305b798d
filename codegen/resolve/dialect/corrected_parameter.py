"""Applies one correction to attributes of a parameter of a command, an entry of MAV_CMD."""

from dataclasses import replace
from typing import TYPE_CHECKING

from codegen.diagnostics import Report, did_you_mean
from codegen.measure import UNKNOWN_UNIT
from codegen.model.dialect.dialect import AttributeCorrection, CommandParameter
from codegen.model.dialect.literals import exact_number
from codegen.model.units.nearest_unit import nearest_unit
from codegen.model.units.unit import Unit, decimal
from codegen.resolve.dialect.corrected import (
    CORRECTION_ATTRIBUTE,
    CORRECTION_UNKNOWN,
    CORRECTION_VALUE,
    OBSOLETE_CORRECTION,
    Corrected,
    as_stated,
    entry_to_correct,
)

if TYPE_CHECKING:
    from codegen.model.spec.spec import Correction

_NUMBERS = ("minValue", "maxValue", "increment")
_ATTRIBUTES = ("label", "units", *_NUMBERS, "enum", "default", "description")


def correct_parameter(correction: "Correction", result: Corrected, report: Report) -> None:
    """Set attributes of a parameter; the empty text removes one."""
    found = entry_to_correct(correction, result, report)
    if found is None:
        return
    enum, entry = found
    parameter = next((each for each in entry.parameters if each.number == correction.param), None)
    if parameter is None:
        known = ", ".join(each.number for each in entry.parameters)
        message = f"{entry.name} has no parameter {correction.param}"
        report.add(CORRECTION_UNKNOWN, correction.at("param"), message, f"it has {known}" if known else None)
        return
    new, stated = parameter, list[AttributeCorrection]()
    for attribute, text in correction.set.items():
        written, before = " ".join(text.split()), _text(new, attribute)
        changed = _corrected(correction, new, attribute, written, result, report)
        if changed is not new:
            target = entry.name, parameter.number
            stated.append(as_stated(correction, target, attribute, written, before or None))
        new = changed
    if new is parameter or _is_refused(correction, new, report):
        return
    result.of_attributes.extend(stated)
    parameters = tuple(new if each is parameter else each for each in entry.parameters)
    corrected = entry._replace(parameters=parameters)
    entries = tuple(corrected if other is entry else other for other in enum.entries)
    result.enums[enum.name] = replace(enum, entries=entries)


def _corrected(
    correction: "Correction",
    parameter: CommandParameter,
    attribute: str,
    text: str,
    result: Corrected,
    report: Report,
) -> CommandParameter:
    """The parameter with an attribute set; as it was after a diagnostic."""
    place, target = correction.at("set"), f"{correction.entry} {parameter.number}"
    stated = dict(parameter.attributes)
    if attribute not in _ATTRIBUTES:
        hint = did_you_mean(attribute, _ATTRIBUTES)
        report.add(CORRECTION_ATTRIBUTE, place, f"{target}: {attribute} cannot be corrected", hint)
    elif attribute in _NUMBERS and text and exact_number(text) is None:
        report.add(
            CORRECTION_VALUE, place, f"{target}: {attribute} cannot be {text!r}", "write a number, or '' for none"
        )
    elif attribute == "units" and text and Unit.parse(text) is None:
        report.add(UNKNOWN_UNIT, place, f"{target}: {text!r} is not a known unit", nearest_unit(text))
    elif attribute == "enum" and text and text not in result.enums:
        hint = did_you_mean(text, result.enums)
        report.add(CORRECTION_VALUE, place, f"{target}: there is no enum {text}", hint)
    elif text == _text(parameter, attribute):
        report.add(OBSOLETE_CORRECTION, place, f"the dialect already has {attribute} {text!r} for {target}")
    elif attribute == "description":
        return parameter._replace(description=text)
    else:
        stated.pop(attribute, None)
        more = {attribute: text} if text else {}
        return parameter._replace(attributes=tuple((stated | more).items()))
    return parameter


def _is_refused(correction: "Correction", parameter: CommandParameter, report: Report) -> bool:
    """Return whether numbers that a correction sets leave no value, or no step; a finding then."""
    stated = {key: exact_number(text) for key, text in parameter.attributes if key in _NUMBERS}
    low, high, step = (stated.get(key) for key in _NUMBERS)
    message = ""
    if low is not None and high is not None and low > high and not correction.set.keys().isdisjoint(_NUMBERS[:2]):
        message = f"minValue {decimal(low)} is above maxValue {decimal(high)}, so that no value is left"
        hint = "swap them, or set one of them to ''"
    elif step is not None and step <= 0 and "increment" in correction.set:
        message, hint = f"increment cannot be {decimal(step)}", "a step is a number above 0"
    if message:
        target = f"{correction.entry} {parameter.number}"
        report.add(CORRECTION_VALUE, correction.at("set"), f"{target}: {message}", hint)
    return bool(message)


def _text(parameter: CommandParameter, attribute: str) -> str:
    """Return the text of an attribute; the empty one where it is not stated."""
    return parameter.description if attribute == "description" else dict(parameter.attributes).get(attribute, "")
