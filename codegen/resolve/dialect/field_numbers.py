"""The numbers that attributes of a field state: multiplier, minValue, maxValue, increment and default."""

from collections.abc import Callable, Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.dialect import FieldDefinition
from codegen.model.dialect.literals import entry_value, exact_number
from codegen.source import Place

FIELD_NUMBER = Rule(
    "field-number",
    "An attribute of a field is no number that can be read: multiplier is a number above 0 or a quotient of two (1E-2, "
    "360/255), minValue, maxValue and increment are decimal numbers, default is one of the forms of an enum's values, "
    "or NaN, and minValue is not above maxValue. Correct it in the XML, or in a correction.",
)


_ONE = Fraction(1)
"""The multiplier of most fields: one object for all of them, which is kept once with a dialect and read once."""


def field_multiplier(
    message: str, field: FieldDefinition, places: Mapping[tuple[str, str, str], Place], report: Report
) -> Fraction:
    """Return what a number on the wire is multiplied with to be in the units of the field; 1 where nothing is stated.

    What the other attributes state is only looked at: they stay as they are written. ``places`` has, by message, field
    and attribute, the places of what a correction states.
    """

    def place(*attributes: str) -> Place:
        stated = (places.get((message, field.name, attribute)) for attribute in attributes)
        return next((each for each in stated if each is not None), field.place)

    if not (field.minimum is field.maximum is field.increment is field.default is None):  # few state any
        _look_at(field, place, report)
    if field.multiplier is None:
        return _ONE
    multiplier = exact_number(field.multiplier)
    if multiplier is None or multiplier <= 0:
        _report(field, "multiplier", field.multiplier, place, report)
        return _ONE
    return multiplier


def _look_at(field: FieldDefinition, place: Callable[..., Place], report: Report) -> None:
    for attribute, text in (("minValue", field.minimum), ("maxValue", field.maximum), ("increment", field.increment)):
        if text is not None and exact_number(text) is None:
            _report(field, attribute, text, place, report)
    low, high = (None if text is None else exact_number(text) for text in (field.minimum, field.maximum))
    if low is not None and high is not None and low > high:
        message = f"{field.name}: minValue {field.minimum} is above maxValue {field.maximum}, so that no value is left"
        at = place("maxValue", "minValue")
        report.add(FIELD_NUMBER, at, message, f'minValue="{field.maximum}" maxValue="{field.minimum}"')
    default = field.default
    if default is not None and entry_value(default) is None and exact_number(default) is None and default != "NaN":
        _report(field, "default", default, place, report)


def _report(field: FieldDefinition, attribute: str, text: str, place: Callable[..., Place], report: Report) -> None:
    example = {"multiplier": "a number above 0, 1E-2 or 360/255", "default": "a number, or NaN"}.get(attribute)
    hint = f"{attribute} is {example or 'a decimal number, such as 0.5'}"
    report.add(FIELD_NUMBER, place(attribute), f"{field.name}: {attribute} is {text!r}", hint)
