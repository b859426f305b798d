"""Structs that a document shows for a message: their types, array lengths, fields and order."""

import re
from collections.abc import Iterator

from codegen.claims.field_notes import FieldNotes, Note, field_notes
from codegen.claims.identifier import MESSAGE_ID
from codegen.claims.layout import typed
from codegen.claims.reading import Reading
from codegen.claims.size import RULE as SIZE
from codegen.diagnostics import Diagnostic, Rule, did_you_mean
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.wire_types import SPELLINGS

RULE = Rule(
    "claim-struct",
    "A struct that a document shows for a message has another type, array length or order of fields than the message, "
    "or, where it names the message by id, lacks a base field or has one too many. The order may be that of the XML or "
    "that of the wire; extensions may be left out.",
)

COLUMN_TYPE = re.compile(r"(?:field |wire |c |data )?type|format", re.IGNORECASE)
TYPE_CELL = re.compile(
    r"(?P<type>u?int(?:8|16|32|64)(?:_t)?|[uif](?:8|16|32|64)|float|double|char)(?:\s?\[\s?(?P<length>\d{1,3})\s?\])?"
)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every declaration of a field, and the structs as a whole; a struct with the id of another message."""
    for notes in field_notes(reading):
        for note, field in notes.pairs():
            declared = _declared(notes, note)
            if declared is not None and not has_type(field, declared[0]):
                stated, offset = declared
                text = f"{notes.message.name}.{note.name} is {typed(field.definition)}, not {stated}"
                words = f"{notes.message.name}.{note.name} {stated}"
                yield reading.found(RULE, note.passage.place_at(offset), words, text)
            if note.elements is not None and note.elements[1] >= field.count:
                text = f"{notes.message.name}.{note.name} has {field.count} elements, 0 to {field.count - 1}"
                words = f"{notes.message.name}.{note.name} {note.elements}"
                yield reading.found(RULE, note.passage.place, words, f"{text}: there is no {note.elements[1]}")
        yield from _whole(reading, notes)
        yield from _size(reading, notes)
        yield from _commented(reading, notes)


def has_type(field: WireField, stated: str) -> bool:
    """Whether a type as XML writes it is that of a field; of an array the type of its elements will do."""
    own = (typed(field.definition), field.definition.type, field.type.name, *_bytes_of(field))
    return stated in (own if field.is_array else (own[0], own[2]))


def _bytes_of(field: WireField) -> tuple[str, ...]:
    """How languages without a type for text write a field of characters."""
    return (f"uint8_t[{field.count}]", f"int8_t[{field.count}]") if field.type.name == "char" else ()


def _declared(notes: FieldNotes, note: Note) -> tuple[str, int] | None:
    """The type that a declaration or the column of a table states, as XML writes it, and its offset."""
    if note.type is not None:
        return (note.type if note.length is None else f"{note.type}[{note.length}]"), 0
    cell = notes.cell(note, COLUMN_TYPE)
    if cell is None or (found := TYPE_CELL.fullmatch(cell[0])) is None:
        return None
    return spelled_type(found), cell[1]


def spelled_type(found: "re.Match[str]") -> str:
    """The type of a cell as XML writes it."""
    spelled = found["type"]
    own = SPELLINGS.get(spelled) or (f"{spelled}_t" if spelled[-1].isdigit() else spelled)
    return own + (f"[{found['length']}]" if found["length"] else "")


def _whole(reading: Reading, notes: FieldNotes) -> Iterator[Diagnostic]:
    if not notes.is_whole:
        return
    message = notes.message
    names = [note.name for note in notes.notes]
    for note in notes.notes:
        if message.field(note.name) is None:
            hint = did_you_mean(note.name, [field.name for field in message.fields])
            text = f"{message.name} has no field {note.name}"
            yield reading.found(RULE, note.passage.place, f"{message.name} {note.name}", text, hint)
    base = [field.name for field in message.definition.fields if not field.is_extension]
    missing = [name for name in base if name not in names]
    first: Note = notes.notes[0]
    if missing:
        text = f"the struct of {message.name} lacks {', '.join(missing)}"
        yield reading.found(RULE, first.passage.place, f"{message.name} lacks {missing}", text)
    wire = [field.name for field in message.fields if not field.definition.is_extension]
    written = [name for name in names if name in base]
    orders = [[name for name in order if name in written] for order in (base, wire)]
    if written not in orders:
        text = f"the fields of {message.name} come in another order: {', '.join(wire)} on the wire"
        yield reading.found(RULE, first.passage.place, f"{message.name} order {written}", text)


def _size(reading: Reading, notes: FieldNotes) -> Iterator[Diagnostic]:
    """``};  /* 38 bytes */`` behind the last field of a struct."""
    message = notes.message
    names = {note.name for note in notes.notes}
    is_full = all(field.name in names for field in message.fields)
    if notes.end is None or notes.end[0] == (message.length if is_full else message.base_length) or message.id < 0:
        return
    number, place = notes.end
    own = f"{message.base_length} bytes, {message.length} with extensions"
    yield reading.found(SIZE, place, f"{message.name} struct {number}", f"{message.name} has {own}, not {number}")


def _commented(reading: Reading, notes: FieldNotes) -> Iterator[Diagnostic]:
    message = notes.message
    if notes.stated is not None and notes.stated[0] != message.id and message.id >= 0:
        number, place = notes.stated
        text = f"{message.name} has the id {message.id}, not {number}"
        yield reading.found(MESSAGE_ID, place, f"{message.name} message #{number}", text)
