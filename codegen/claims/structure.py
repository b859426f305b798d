"""Structs that a document shows for a message: their types, array lengths, fields and order."""

from collections.abc import Iterator

from codegen.claims.field_notes import FieldNotes, Note, field_notes
from codegen.claims.reading import Reading
from codegen.claims.rules import MESSAGE_ID, TYPE
from codegen.diagnostics import Diagnostic, did_you_mean


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every declaration of a field, and the structs as a whole; a struct with the id of another message."""
    for notes in field_notes(reading):
        for note, field in notes.pairs():
            if note.elements is not None and note.elements[1] >= field.count:
                text = f"{notes.message.name}.{note.name} has {field.count} elements, 0 to {field.count - 1}"
                words = f"{notes.message.name}.{note.name} {note.elements}"
                yield reading.found(TYPE, note.passage.place, words, f"{text}: there is no {note.elements[1]}")
        yield from _whole(reading, notes)
        yield from _commented(reading, notes)


def _whole(reading: Reading, notes: FieldNotes) -> Iterator[Diagnostic]:
    if not notes.is_whole:
        return
    message = notes.message
    names = [note.name for note in notes.notes]
    for note in notes.notes:
        if message.field(note.name) is None:
            hint = did_you_mean(note.name, [field.name for field in message.fields])
            text = f"{message.name} has no field {note.name}"
            yield reading.found(TYPE, note.passage.place, f"{message.name} {note.name}", text, hint)
    base = [field.name for field in message.definition.fields if not field.is_extension]
    missing = [name for name in base if name not in names]
    first: Note = notes.notes[0]
    if missing:
        text = f"the struct of {message.name} lacks {', '.join(missing)}"
        yield reading.found(TYPE, first.passage.place, f"{message.name} lacks {missing}", text)
    wire = [field.name for field in message.fields if not field.definition.is_extension]
    written = [name for name in names if name in base]
    orders = [[name for name in order if name in written] for order in (base, wire)]
    if written not in orders:
        text = f"the fields of {message.name} come in another order: {', '.join(wire)} on the wire"
        yield reading.found(TYPE, first.passage.place, f"{message.name} order {written}", text)


def _commented(reading: Reading, notes: FieldNotes) -> Iterator[Diagnostic]:
    message = notes.message
    if notes.stated is not None and notes.stated[0] != message.id and message.id >= 0:
        number, place = notes.stated
        text = f"{message.name} has the id {message.id}, not {number}"
        yield reading.found(MESSAGE_ID, place, f"{message.name} message #{number}", text)
