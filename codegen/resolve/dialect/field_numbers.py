"""The numbers that attributes of a field state: multiplier, minValue, maxValue, increment and default."""

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.dialect import FieldDefinition
from codegen.model.dialect.literals import entry_value, exact_number
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.source import Place

FIELD_NUMBER = Rule(
    "field-number",
    "An attribute of a field is no number that can be read: multiplier is a number above 0 or a quotient of two (1E-2, "
    "360/255), minValue, maxValue and increment are decimal numbers, default is one of the forms of an enum's values, "
    "or NaN, and minValue and maxValue leave a number that the type has. Correct it in the XML, or in the correction "
    "that states it.",
)
Places = Mapping[str, Place]
"""The places of corrections that state attributes of a field, by attribute."""


_ONE = Fraction(1)
"""The multiplier of most fields: one object for all of them, which is kept once with a dialect and read once."""


def field_multiplier(field: FieldDefinition, places: Places, report: Report) -> Fraction:
    """Return what a number on the wire is multiplied with to be in the units of the field; 1 where nothing is stated.

    What the other attributes state is only looked at: they stay as they are written.
    """
    if not (field.minimum is field.maximum is field.increment is field.default is None):  # few state any
        _look_at(field, places, report)
    if field.multiplier is None:
        return _ONE
    multiplier = exact_number(field.multiplier)
    if multiplier is None or multiplier <= 0:
        _report(field, "multiplier", field.multiplier, places, report)
        return _ONE
    return multiplier


def _look_at(field: FieldDefinition, places: Places, report: Report) -> None:
    for attribute, text in (("minValue", field.minimum), ("maxValue", field.maximum), ("increment", field.increment)):
        if text is not None and exact_number(text) is None:
            _report(field, attribute, text, places, report)
    low, high = (None if text is None else exact_number(text) for text in (field.minimum, field.maximum))
    if low is not None and high is not None and low > high:
        message = f"{field.name}: minValue {field.minimum} is above maxValue {field.maximum}, so that no value is left"
        hint = f'minValue="{field.maximum}" maxValue="{field.minimum}"'
        report.add(FIELD_NUMBER, _place(field, ("minValue", "maxValue"), places), message, hint)
    else:
        _look_at_type(field, low, high, places, report)
    default = field.default
    if default is not None and entry_value(default) is None and exact_number(default) is None and default != "NaN":
        _report(field, "default", default, places, report)


def _look_at_type(
    field: FieldDefinition, low: Fraction | None, high: Fraction | None, places: Places, report: Report
) -> None:
    """Report limits between which the type of a field has no number."""
    wire_type = WIRE_TYPES[field.type]
    if not wire_type.is_integer:
        return
    least = wire_type.minimum if low is None else max(wire_type.minimum, math.ceil(low))
    most = wire_type.maximum if high is None else min(wire_type.maximum, math.floor(high))
    if least > most:
        named = (("minValue", field.minimum), ("maxValue", field.maximum))
        stated = [(attribute, text) for attribute, text in named if text is not None]
        shown = " and ".join(f"{attribute} {text}" for attribute, text in stated)
        message = f"{field.name}: no number of {wire_type.name} lies within {shown}"
        hint = f"{wire_type.name} has whole numbers from {wire_type.minimum} to {wire_type.maximum}"
        report.add(FIELD_NUMBER, _place(field, [attribute for attribute, _ in stated], places), message, hint)


def _place(field: FieldDefinition, attributes: Iterable[str], places: Places) -> Place:
    """Return the place of the correction that states one of some attributes; else that of the field."""
    return next((places[attribute] for attribute in attributes if attribute in places), field.place)


def _report(field: FieldDefinition, attribute: str, text: str, places: Places, report: Report) -> None:
    example = {"multiplier": "a number above 0, 1E-2 or 360/255", "default": "a number, or NaN"}.get(attribute)
    hint = f"{attribute} is {example or 'a decimal number, such as 0.5'}"
    report.add(FIELD_NUMBER, _place(field, (attribute,), places), f"{field.name}: {attribute} is {text!r}", hint)
