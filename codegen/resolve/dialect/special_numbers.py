"""The numbers that a correction states for who receives a field: those that change nothing, and those of no value."""

import math
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.dialect import EnumDefinition, FieldDefinition, Kind, WireType
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


def check_special(
    field: FieldDefinition,
    wire_type: WireType,
    enum: EnumDefinition | None,
    places: Mapping[str, Place],
    report: Report,
) -> None:
    """Report what a correction lists that is no number of the field, at the correction."""
    for attribute, text in (("unchanged", field.unchanged), ("unknown", field.unknown)):
        if text and wire_type.kind is Kind.CHAR:
            place = places.get(attribute, field.place)
            report.add(SPECIAL_VALUE, place, f"{field.name}: {attribute} says nothing of a text", "leave it out")
        elif text:
            for problem in problems(listed(text), wire_type, enum):
                place = places.get(attribute, field.place)
                report.add(SPECIAL_VALUE, place, f"{field.name}: {problem.message}", problem.hint)


def listed(text: str | None) -> list[str]:
    """Return the numbers of a list as a correction has them, each as it is written."""
    return [each.strip() for each in (text or "").split(",") if each.strip()]


def problems(texts: Iterable[str], wire_type: WireType, enum: EnumDefinition | None) -> Iterator[Problem]:
    """Yield what is wrong with each text that is no number on the wire."""
    for text in texts:
        number = number_on_wire(text, wire_type, enum)
        if isinstance(number, Problem):
            yield number


def numbers(texts: Iterable[str], wire_type: WireType, enum: EnumDefinition | None) -> Numbers:
    """Return the numbers of the texts that are some, each once."""
    found: list[int | float] = []
    for text in texts:
        number = number_on_wire(text, wire_type, enum)
        if not isinstance(number, Problem) and not is_among(number, tuple(found)):
            found.append(number)
    return tuple(found)


def is_among(number: float | Fraction | None, numbers: Numbers) -> bool:
    """Return whether a number is one of some, of which NaN may be one."""
    if isinstance(number, float) and math.isnan(number):
        return any(math.isnan(each) for each in numbers)
    return number in numbers
