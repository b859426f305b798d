"""Rows of names of messages and numbers, without a word about what the numbers are: most of them tell it.

Where a column of numbers is, for most of its messages, the id, CRC_EXTRA or a length of each, it is so for all, and the
others are wrong.
"""

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import groupby

from codegen.claims.code_facts import number_claims
from codegen.claims.field_notes import cells
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern
from codegen.source import Place

_NAME = pattern(r"(?<![\w])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*(?![\w])")
_NUMBER = pattern(r"(?<![\w.#-])#?(\d{1,5})(?![\w.]\d|\w|\.)")
_FACTS: Mapping[str, Callable[[WireMessage], tuple[int, ...]]] = {
    "id": lambda message: (message.id,),
    "crc": lambda message: (message.crc_extra,),
    "min_length": lambda message: (message.base_length,),
    "length": lambda message: (message.base_length, message.length),
}
_ITEM = pattern(r"\W*(?:#?\d{1,5}\W{1,5}){0,4}[A-Z][A-Z0-9_]{2,60}\W{0,5}(?:#?\d{1,5}\W{0,5}){0,4}")
"""An item that is a name and numbers, and nothing else."""
_CELL = pattern(r"#?\d{1,5}")
_IN_TEXT = ("id", "crc")
"""The roles that a column of numbers may have without a heading; a length may be the sent one, without its zeros."""
_FEWEST = 2
"""Rows that have to agree before another one is wrong."""


@dataclass(frozen=True, slots=True)
class _Row:
    """A row that names one message, and its numbers, each with its place."""

    message: WireMessage
    numbers: tuple[tuple[int, Place], ...]


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every run of rows, of items, and of lines of code."""
    for rows, roles in _runs(reading):
        for column in range(max(len(row.numbers) for row in rows)):
            found = [(row.message, *row.numbers[column]) for row in rows if column < len(row.numbers)]
            role = _role(found, roles)
            for message, number, place in found if role is not None else ():
                yield from number_claims(reading, message, role or "", number, place)


def _role(found: Sequence[tuple[WireMessage, int, Place]], roles: Collection[str]) -> str | None:
    """Return the fact that most numbers of a column agree with; None where less than two thirds of them do."""
    agreeing = Counter(
        {
            role: len({message.name for message, number, _ in found if number in fact(message)})
            for role, fact in _FACTS.items()
            if role in roles
        }
    )
    role, most = agreeing.most_common(1)[0]
    different = len({number for _, number, _ in found})
    return role if most >= _FEWEST and different > 1 and 3 * most >= 2 * len(found) else None


def _runs(reading: Reading) -> Iterator[tuple[list[_Row], Collection[str]]]:
    for kind, run in groupby(reading.prose.parts, lambda part: getattr(part, "kind", None)):
        parts = list(run)
        if kind in (PassageKind.ROW, PassageKind.ITEM):
            rows = _together([_row_of(reading, part) for part in parts if isinstance(part, Passage)])
            yield from ((row, _FACTS if kind is PassageKind.ITEM else _IN_TEXT) for row in rows)
        for part in parts:
            if isinstance(part, CodeBlock):
                rows = _together([_row(reading, line.text, _places(line)) for line in part.lines])
                yield from ((row, _FACTS) for row in rows)


def _places(line: Line) -> Callable[[int], Place]:
    return lambda at: line.place._replace(column=line.place.column + at)


def _together(rows: Sequence[_Row | None]) -> Iterator[list[_Row]]:
    found = [row for row in rows if row is not None and row.numbers]
    if len(found) > _FEWEST:
        yield found


def _row_of(reading: Reading, passage: Passage) -> _Row | None:
    """The row of a table, of which whole cells are numbers, or the item that is a name and a number."""
    row = _row(reading, passage.text, passage.place_at)
    if row is None or (passage.kind is PassageKind.ITEM and _ITEM.fullmatch(passage.text) is None):
        return None
    if passage.kind is PassageKind.ITEM:
        return row
    whole = [offset for text, offset in cells(passage) if _CELL.fullmatch(text.strip())]
    places = {passage.place_at(offset + (passage.text[offset] == "#")) for offset in whole}
    return _Row(row.message, tuple(each for each in row.numbers if each[1] in places))


def _row(reading: Reading, text: str, place_at: Callable[[int], Place]) -> _Row | None:
    """The row of a text that names one known message, or None."""
    named = {found[0] for found in _NAME.finditer(text)} & reading.messages.keys()
    if len(named) != 1:
        return None
    message = reading.messages[named.pop()]
    if message.id < 0:
        return None
    numbers = tuple((int(found[1]), place_at(found.start(1))) for found in _NUMBER.finditer(text))
    return _Row(message, numbers)
