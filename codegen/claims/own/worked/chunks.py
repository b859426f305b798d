"""Tables of the chunks that a long text goes out in: their characters and frames, and all of the text."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.examples import Examples, Table
from codegen.claims.own.worked.sizes import text_start
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V2
from codegen.pattern import pattern

_MESSAGE, _NUMBER, _PLACE = "STATUSTEXT", "id", "chunk_seq"
"""The message that carries texts, with the fields for the number of the text and the place of a chunk."""
_CHUNK, _CHARACTERS = pattern(r"chunk", re.IGNORECASE), pattern(r"characters", re.IGNORECASE)
_FRAME = pattern(r"frame(?: \(v2\)|,? v2)?", re.IGNORECASE)
_TEXT = pattern(r"\btext of (?P<length>\d{1,5}) characters with the number (?P<number>\d{1,5})\b")


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table of chunks below "a text of N characters with the number N"."""
    message = examples.reading.messages.get(_MESSAGE)
    for table in examples.tables:
        said = _TEXT.search(table.intro.text) if table.intro is not None else None
        columns = [table.column(form) for form in (_CHUNK, _CHARACTERS, _FRAME)]
        if said is not None and message is not None and None not in columns:
            yield from _chunks(examples, table, columns, message, said)


def _chunks(
    examples: Examples, table: Table, columns: list[int | None], message: WireMessage, said: "re.Match[str]"
) -> Iterator[Diagnostic]:
    start = text_start(message)
    text = next((field for field in message.fields if field.offset == start), None)
    if start is None or text is None:
        return
    left, most = int(said["length"]), text.count
    for number, row in enumerate(table.rows):
        expected = (number, min(left, most), _frame(message, start, min(left, most), int(said["number"]), number))
        for column, value in zip(columns, expected, strict=True):
            found = row.only(column)
            if found is not None:
                words = f"{table.heads[column or 0]} of chunk {number}"
                yield from examples.judged(row.passage, found, [Fraction(value)], words)
        left = max(left - most, 0)


def _frame(message: WireMessage, start: int, characters: int, number: int, place: int) -> int:
    """The bytes of a frame: up to the last byte that is not zero."""
    end = start + characters
    for name, value in ((_NUMBER, number), (_PLACE, place)):
        field = message.field(name)
        if field is not None and value:
            end = max(end, field.offset + (value.bit_length() + 7) // 8)
    return HEAD_V2 + end
