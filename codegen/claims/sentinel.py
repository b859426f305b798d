"""Values for unknown, and units, that tables, lists and comments name for the fields of a message."""

import math
import re
from collections.abc import Iterator

from codegen.claims.field_notes import FieldNotes, Note, field_notes
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.dialect.literals import named_number, same_number
from codegen.model.units.unit import Unit
from codegen.model.units.unit_table import SHOWN

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
    rf"(?:(?:field|value|it|{'|'.join(sorted(set(SHOWN.values())))})\s)?(?:is\s)?"
    r"(?:unknown|unavailable|invalid|not (?:known|provided|available|measured))"
)
_OTHER = _VALUE.replace("value", "other")
_STATED = re.compile(rf"{_VALUE}{_TIE}{_UNKNOWN}\b|\b(?:unknown|invalid)\s*[:=]\s*{_OTHER}", re.IGNORECASE)
_ONLY = re.compile(_VALUE, re.IGNORECASE)
_COLUMN_UNKNOWN = re.compile(
    r"(?:if |when )?(?:invalid|unknown|sentinel|not (?:known|available))(?: value)?", re.IGNORECASE
)
_COLUMN_UNIT = re.compile(r"units?", re.IGNORECASE)
_LIMIT = re.compile(r"(?<![\w])U?INT(?:8|16|32|64)_M(?:AX|IN)(?![\w])")
_IN_UNIT = re.compile(r"\bin (?P<unit>[A-Za-z%][A-Za-z0-9/%^]{0,7})(?=\s*(?:[,.;)(|]|$|if\b|\u2013|\u2014))")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every value for unknown and every unit in the notes about fields."""
    for notes in field_notes(reading):
        for note, field in notes.pairs():
            yield from _sentinels(reading, notes, note, field)
            yield from _units(reading, notes, note, field)


def _sentinels(reading: Reading, notes: FieldNotes, note: Note, field: WireField) -> Iterator[Diagnostic]:
    """The first value that is wrong, if none of those that are named is right: one note explains one field."""
    values: list[tuple[str, int, bool]] = []
    for found in _STATED.finditer(note.text):
        group = "value" if found["value"] else "other"
        values.append((found[group], note.start + found.start(group), True))
    cell = notes.cell(note, _COLUMN_UNKNOWN)
    if cell is not None and (single := _ONLY.fullmatch(cell[0])):
        values.append((single["value"], cell[1] + single.start("value"), True))
    values += [(found[0], note.start + found.start(), False) for found in _LIMIT.finditer(note.text)]
    problems = [_problem(field, written, note, is_unknown=is_unknown) for written, _, is_unknown in values]
    wrong = [(value, problem) for value, problem in zip(values, problems, strict=True) if problem]
    if not wrong or any(_is_own(field, written, note) for written, _, _ in values):
        return
    (written, offset, _), problem = wrong[0]
    name = f"{notes.message.name}.{note.name}"
    text = f"{name} {problem}, not {written}"
    yield reading.found(SENTINEL, note.passage.place_at(offset), f"{name} {written}", text)


def _problem(field: WireField, written: str, note: Note, *, is_unknown: bool) -> str | None:
    """What is wrong with a value for unknown, as the beginning of a sentence; None where nothing is.

    0 of an enum is an entry, whatever it is called.
    """
    value = named_number(written)
    assert value is not None, f"{written} is no value for unknown"
    own = _own(field, note)
    if any(same_number(value, sentinel) for sentinel in own) or (value == 0 and field.definition.enum):
        return None
    known = f"is unknown when it is {field.sentinel.written}" if field.sentinel is not None and own else None
    if not _carries(field, value):
        return known or f"is {field.type.name} and carries {field.type.minimum} to {field.type.maximum}"
    return known if is_unknown else None


def _is_own(field: WireField, written: str, note: Note) -> bool:
    return any(same_number(named_number(written), sentinel) for sentinel in _own(field, note))


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


def _units(reading: Reading, notes: FieldNotes, note: Note, field: WireField) -> Iterator[Diagnostic]:
    own = Unit.parse(field.definition.units)
    stated = [(found["unit"], note.start + found.start("unit")) for found in _IN_UNIT.finditer(note.text)]
    cell = notes.cell(note, _COLUMN_UNIT)
    if cell is not None:
        stated.append(cell)
    for unit, offset in stated if own else ():
        if own and (other := Unit.parse(unit)) is not None and other != own:
            name = f"{notes.message.name}.{note.name}"
            place = note.passage.place_at(offset)
            yield reading.found(UNIT, place, f"{name} in {unit}", f"{name} is in {own.name}, not {unit}")
            return
