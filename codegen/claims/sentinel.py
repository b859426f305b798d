"""Values for unknown, and units, that tables, lists and comments name for the fields of a message."""

import math
import re
from collections.abc import Iterator

from codegen.claims.field_notes import FieldNotes, Note, field_notes
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.model.dialect import Kind, WireField
from codegen.model.literals import LIMITS
from codegen.model.unit import UNITS

SENTINEL = Rule(
    "claim-sentinel",
    "A document names another value for unknown than the dialect has for the field, or one that the field cannot "
    "carry. Receivers go by the dialect, and take the value for a real one. Correct it.",
)
UNIT = Rule(
    "claim-unit",
    "A document gives a field another unit than the dialect has. Whoever follows it is wrong by a power of ten, or "
    "more. Correct it.",
)

_VALUE = r"(?P<value>U?INT(?:8|16|32|64)_M(?:AX|IN)|NaN|(?<![\w.+-])-1(?![\w.])|(?<![\w.+-])0(?![\w.]))"
_TIE = r"[\s(]*(?:\b(?:if|when|where|for|is|means|stands for|mark(?:ed)? as)\b|[:=;,])?[\s(]*"
_UNKNOWN = (
    r"(?:(?:field|value|voltage|temperature|current|it)\s)?(?:is\s)?"
    r"(?:unknown|unavailable|invalid|not (?:known|provided|available|measured))"
)
_OTHER = _VALUE.replace("value", "other")
_STATED = re.compile(rf"{_VALUE}{_TIE}{_UNKNOWN}\b|\b(?:unknown|invalid)\s*[:=]\s*{_OTHER}", re.IGNORECASE)
_LIMIT = re.compile(r"(?<![\w])U?INT(?:8|16|32|64)_M(?:AX|IN)(?![\w])")
_IN_UNIT = re.compile(r"\bin (?P<unit>[A-Za-z%][A-Za-z0-9/%^]{0,7})(?=\s*(?:[,.;)(|]|$|if\b|\u2013|\u2014))")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every value for unknown and every unit in the notes about fields."""
    for notes in field_notes(reading):
        for note, field in notes.pairs():
            yield from _sentinels(reading, notes, note, field)
            yield from _units(reading, notes, note, field)


def _sentinels(reading: Reading, notes: FieldNotes, note: Note, field: WireField) -> Iterator[Diagnostic]:
    said: set[str] = set()
    for found in _STATED.finditer(note.text):
        group = "value" if found["value"] else "other"
        problem = _problem(field, found[group], note, is_unknown=True)
        if problem and found[group] not in said:
            said.add(found[group])
            yield _finding(reading, notes, note, found.start(group), found[group], problem)
    for found in _LIMIT.finditer(note.text):
        problem = _problem(field, found[0], note, is_unknown=False)
        if problem and found[0] not in said:
            said.add(found[0])
            yield _finding(reading, notes, note, found.start(), found[0], problem)


def _finding(reading: Reading, notes: FieldNotes, note: Note, offset: int, value: str, problem: str) -> Diagnostic:
    name = f"{notes.message.name}.{note.name}"
    place = note.passage.place_at(note.start + offset)
    return reading.found(SENTINEL, place, f"{name} {value}", f"{name} {problem}, not {value}")


def _problem(field: WireField, written: str, note: Note, *, is_unknown: bool) -> str | None:
    """What is wrong with a value for unknown, as the beginning of a sentence; None where nothing is."""
    value = math.nan if written.lower() == "nan" else LIMITS.get(written.upper(), None)
    if value is None:
        value = int(written)
    own = _own(field, note)
    is_carried = _carries(field, value)
    if any(_is_same(value, sentinel) for sentinel in own):
        return None
    known = f"is unknown when it is {field.sentinel.written}" if field.sentinel is not None and own else None
    if not is_carried:
        return known or f"is {field.type.name} and carries {field.type.minimum} to {field.type.maximum}"
    return known if is_unknown else None


def _own(field: WireField, note: Note) -> list[int | float]:
    """The values for unknown of the elements that a note is about."""
    if field.sentinel is None:
        return []
    low, high = note.elements or (0, field.count - 1)
    return [value for value in field.sentinel.values[low : high + 1] if value is not None]


def _carries(field: WireField, value: int | float) -> bool:
    if field.type.kind is Kind.FLOAT:
        return True
    return not math.isnan(value) and field.type.minimum <= value <= field.type.maximum


def _is_same(first: int | float, second: int | float) -> bool:
    return first == second or (math.isnan(first) and math.isnan(second))


def _units(reading: Reading, notes: FieldNotes, note: Note, field: WireField) -> Iterator[Diagnostic]:
    own = field.definition.units
    for found in _IN_UNIT.finditer(note.text) if own else ():
        stated = found["unit"]
        if stated in UNITS and own in UNITS and UNITS[stated] != UNITS[own]:
            name = f"{notes.message.name}.{note.name}"
            place = note.passage.place_at(note.start + found.start("unit"))
            yield reading.found(UNIT, place, f"{name} in {stated}", f"{name} is in {own}, not {stated}")
            return
