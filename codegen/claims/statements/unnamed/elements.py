"""Units of elements without the name of their array: "each element is in millimetres", "the sectors are in cm".

The array is the only one of the message with a unit of that dimension, or all of them have another unit.
"""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import (
    CHANGED,
    CONVERTED,
    DENIED,
    MISTAKEN,
    OWN,
    PAST,
    REPLACED,
    SHOWN,
    SUPPOSED,
    words,
)
from codegen.claims.rules import UNIT, as_sure
from codegen.claims.statements.nouns import OF_ELSE
from codegen.claims.statements.scaling.field_units import has_unit
from codegen.claims.statements.scaling.own_units import is_told_behind
from codegen.claims.statements.subjects import subjects
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_IN = pattern(
    r"\b(?:(?:each|every|an?|one) (?:element|entry|sector|slot|bin|item)|(?:the|all|its) (?:elements|entries|sectors"
    r"|slots|bins|items))(?: (?:of|in) the array)? (?:is|are|comes?|holds?)(?: (?:all|always|given|measured|sent|told)"
    r")*(?: in)?(?: whole| plain)? U(?=\s*(?:[,.;:)]|$|and\b))"
)
_NOT = words(
    DENIED, REPLACED, PAST, CHANGED, MISTAKEN, SUPPOSED, OWN, SHOWN, CONVERTED, r"\?", r"\bif\b",
)  # fmt: skip
_OF_DEVICE = pattern(r"\b(?:sensor|driver|lidar|radar|sonar|scanner|device)")
"""Before the unit: it is that of a source."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every unit that a part states of the elements of an array."""
    if span.kind is PassageKind.ROW or span.is_code:
        return
    for found in _IN.finditer(span.text):
        low, high = span.bounds(found.start())
        if _NOT.search(span.text, low, high) or OF_ELSE.search(span.text, low, high):
            continue
        if _OF_DEVICE.search(span.text, low, found.end()) or any(span.sentence.within(low, found.end(), "FP")):
            continue  # of a source, or of a field that other rules know
        messages, is_sure = subjects(reading, span, found.start())
        term = span.sentence.term(found.end() - 1)
        unit = term.value
        if not is_sure or not isinstance(unit, Unit):
            continue
        arrays = [field for field in messages[0].fields if field.is_array and field.definition.units]
        kin = [field for field in arrays if _dimension(field.definition.units) == unit.dimension]
        others = [field for message in messages for field in message.fields if field.is_array]
        if not kin or any(has_unit(field, unit) for field in others) or is_told_behind(span, found.end() - 1, kin[0]):
            continue
        name = f"{messages[0].name}.{kin[0].name}"
        text = f"{name} is in {kin[0].definition.units}, not {term.written}"
        place = span.place(found.end() - 1)
        yield reading.found(as_sure(UNIT, is_sure=False), place, f"{name} in {term.written}", text)


def _dimension(written: str | None) -> object:
    unit = Unit.parse(written)
    return None if unit is None else unit.dimension
