"""Numbers of a received field that are no value: those that leave its quantity as it was, and further unknown ones."""

import math
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.dialect import EnumDefinition, Kind, WireField
from codegen.model.spec.receive import ReceivedFieldSpec
from codegen.model.units.unit import decimal
from codegen.resolve.dialect.sentinel import Problem, number_on_wire
from codegen.source import Place

SPECIAL_VALUE = Rule(
    "special-value",
    "'unchanged' and 'unknown' of a received field list numbers that the field carries on the wire, limits of types "
    "such as UINT16_MAX or UINT16_MAX-1, entries of the field's enum, or NaN, each in one list only; a text has none. "
    "Those that a correction of the dialect states are written alike, with commas between them.",
    remedy="write numbers that the field carries, limits such as UINT16_MAX, or entries of its enum",
)
Numbers = tuple[int | float, ...]


def special_values(
    field: WireField, written: ReceivedFieldSpec, enum: EnumDefinition | None, report: Report
) -> tuple[Numbers, Numbers]:
    """Return the numbers that leave the quantity as it was, and those that set it unknown beside the sentinel.

    What the table lists goes before what a correction states; an empty list is that there are none.
    """
    if field.type.kind is Kind.CHAR:
        for key in ("unchanged", "unknown"):
            if key in written.places:
                report.add(SPECIAL_VALUE, written.at(key), f"{key} says nothing of a text", "leave it out")
        return (), ()
    definition = field.definition
    lists: dict[str, Numbers] = {}
    for key, own, stated in (
        ("unchanged", written.unchanged, definition.unchanged),
        ("unknown", written.unknown, definition.unknown),
    ):
        if own is not None:
            texts = [each if isinstance(each, str) else decimal(each) for each in own]
            lists[key] = _numbers(texts, field, enum, written.at(key), report)
        else:
            texts = [each.strip() for each in (stated or "").split(",") if each.strip()]
            lists[key] = _numbers(texts, field, enum, written.place, report)
    unchanged, unknown = lists["unchanged"], lists["unknown"]
    both = tuple(number for number in unknown if is_among(number, unchanged))
    if not both:
        return unchanged, unknown
    if written.unchanged is not None and written.unknown is not None:
        message = f"{field.name}: {both[0]} leaves the quantity as it was, and makes it unknown"
        related = [(written.at("unchanged"), "the other list is here")]
        report.add(SPECIAL_VALUE, written.at("unknown"), message, "keep it in one of the lists", related)
    if written.unchanged is None:
        return tuple(number for number in unchanged if not is_among(number, both)), unknown
    return unchanged, tuple(number for number in unknown if not is_among(number, both))


def is_among(number: float | Fraction | None, numbers: Numbers) -> bool:
    """Return whether a number is one of some, of which NaN may be one."""
    if isinstance(number, float) and math.isnan(number):
        return any(math.isnan(each) for each in numbers)
    return number in numbers


def _numbers(texts: list[str], field: WireField, enum: EnumDefinition | None, place: Place, report: Report) -> Numbers:
    found: list[int | float] = []
    for text in texts:
        number = number_on_wire(text, field.type, enum)
        if isinstance(number, Problem):
            report.add(SPECIAL_VALUE, place, f"{field.name}: {number.message}", number.hint)
        elif not is_among(number, tuple(found)):
            found.append(number)
    return tuple(found)
