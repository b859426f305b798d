"""Notes of a document on the fields of a message, one by one: in structs of code, tables, and lists."""

import re
from collections.abc import Iterator
from itertools import groupby

from codegen.claims.reading import Reading
from codegen.frozen import dataclass
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.dialect.wire_types import SPELLINGS
from codegen.pattern import pattern
from codegen.source import Place

C_TYPE = r"u?int(?:8|16|32|64)_t|float|double|char"
_C_FIELD = pattern(
    rf"\s*(?:const\s+)?(?P<type>{C_TYPE})\s+(?P<name>\w+)\s*(?:\[\s*(?P<length>\d{{1,4}})\s*\])?\s*;(?P<rest>.*)"
)
_RUST_FIELD = pattern(
    r"\s*(?:pub\s+)?(?:r#)?(?P<name>[a-z]\w*?)_?\s*:\s*(?:\[\s*(?P<array>[iuf]\d\d?)\s*;\s*(?P<length>\d{1,4})\s*\]"
    r"|(?P<type>[iuf](?:8|16|32|64)))\s*,?(?P<rest>\s*(?://.*)?)$"
)
_END_OF = pattern(r"\s*\}")
_END = pattern(r"\s*\}[^/#]{0,60}(?://|/\*|#)\s*(\d{1,3}) bytes?\b(?! of)")
_ELEMENT = r"(?P<name>[a-z][a-z0-9_]*)(?:\[(?P<low>\d{1,3})(?:\s*(?:\.{2,3}|-|:|\u2013)\s*(?P<high>\d{1,3}))?\])?"
_ITEM = pattern(rf"{_ELEMENT}\s*(?::|=|\u2013|\u2014|-)\s+")
_CELL = pattern(rf"\s*{_ELEMENT}\s*$")


_NUMBERED = pattern(r"(?://|/\*|#|<!--|\*)\s.*?\bmessages?\s+(?:id\s*)?#?(\d{1,8})\b", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Note:
    """A note on one field: the ``text`` of a passage from ``start`` on.

    ``elements`` are the first and last index where elements of an array are meant; ``type`` and ``length`` are stated
    by declarations only.
    """

    name: str
    passage: Passage
    start: int
    elements: tuple[int, int] | None = None
    type: str | None = None
    length: int | None = None


@dataclass(frozen=True, slots=True)
class FieldNotes:
    """Notes about fields of one message, in their order.

    ``stated`` is the id that a comment in a struct gives its message, and the place of that line, ``end`` the bytes
    that a comment behind its last line gives it.
    """

    message: WireMessage
    notes: tuple[Note, ...]
    stated: tuple[int, Place] | None = None
    end: tuple[int, Place] | None = None

    @property
    def is_whole(self) -> bool:
        """Return whether a struct says that it is the message, by its id, and so has to have all of its base fields."""
        return self.stated is not None and self.stated[0] == self.message.id

    def pairs(self) -> Iterator[tuple[Note, WireField]]:
        """The notes about fields that the message has, each with its field."""
        for note in self.notes:
            field = self.message.field(note.name)
            if field is not None:
                yield note, field


def field_notes(reading: Reading) -> Iterator[FieldNotes]:
    """The structs, tables and lists of a document that are about the fields of a message."""
    for code in reading.prose.code:
        yield from _struct(reading, code)
    for is_note, run in groupby(reading.prose.parts, _kind):
        if is_note is PassageKind.ROW:
            yield from _table(reading, [part for part in run if isinstance(part, Passage)])
        elif is_note is PassageKind.ITEM:
            yield from _list(reading, [part for part in run if isinstance(part, Passage)])


def _kind(part: Passage | CodeBlock) -> PassageKind | None:
    return part.kind if isinstance(part, Passage) else None


def _struct(reading: Reading, code: CodeBlock) -> Iterator[FieldNotes]:
    notes: list[Note] = []
    for line in code.lines:
        if _END_OF.match(line.text):
            yield from _structure(reading, notes, code, _bytes_of(line))
            notes = []
        found = _C_FIELD.match(line.text) or _RUST_FIELD.match(line.text)
        if found is None:
            continue
        groups = found.groupdict()
        written = groups["type"] or groups.get("array") or ""
        passage = Passage(PassageKind.TEXT, line.text, ((0, line.place),))
        length = int(found["length"]) if found["length"] else None
        wire_type = SPELLINGS.get(written, written)
        notes.append(Note(found["name"], passage, found.start("rest"), None, wire_type, length))
    yield from _structure(reading, notes, code, None)


def _structure(
    reading: Reading, notes: list[Note], code: CodeBlock, end: tuple[int, Place] | None
) -> Iterator[FieldNotes]:
    if len(notes) < 2:
        return
    about = reading.message_with([note.name for note in notes], notes[0].passage.place.line)
    if about is not None:
        yield FieldNotes(about, tuple(notes), commented_id(code), end)


def _bytes_of(line: Line) -> tuple[int, Place] | None:
    found = _END.match(line.text)
    if found is None:
        return None
    return int(found[1]), line.place._replace(column=line.place.column + found.start(1))


def _table(reading: Reading, rows: list[Passage]) -> Iterator[FieldNotes]:
    """One table; two that follow each other directly are looked at as one, which only makes fewer notes."""
    notes = []
    for row in rows[1:]:
        own = cells(row)
        found = _CELL.fullmatch(own[0][0]) if own else None
        if found and len(own) > 1:
            notes.append(Note(found["name"], row, own[1][1], _elements(found)))
    yield from _about(reading, notes, rows[0].place.line)


def _list(reading: Reading, items: list[Passage]) -> Iterator[FieldNotes]:
    notes = []
    for item in items:
        found = _ITEM.match(item.text)
        if found:
            notes.append(Note(found["name"], item, found.end(), _elements(found)))
    yield from _about(reading, notes, items[0].place.line)


def _about(reading: Reading, notes: list[Note], line: int) -> Iterator[FieldNotes]:
    names = {note.name for note in notes}
    about = reading.message_with(names, line) if len(names) > 1 else None
    if about is not None:
        yield FieldNotes(about, tuple(notes))


def _elements(found: "re.Match[str]") -> tuple[int, int] | None:
    if found["low"] is None:
        return None
    return int(found["low"]), int(found["high"] or found["low"])


def cells(row: Passage) -> list[tuple[str, int]]:
    """The cells of a row of a table, each with the offset of its text."""
    text = row.text
    start = len(text) - len(text.lstrip())
    position = start + 1 if text[start : start + 1] == "|" else start
    found: list[tuple[str, int]] = []
    for cell in text[position:].rstrip("| ").split("|"):
        found.append((cell, position + len(cell) - len(cell.lstrip())))
        position += len(cell) + 1
    return found


def commented_id(code: CodeBlock) -> tuple[int, Place] | None:
    """The id that a comment of a block of code gives its message, and the place of its line."""
    for line in code.lines:
        found = _NUMBERED.search(line.text)
        if found:
            return int(found[1]), line.place
    return None
