"""Rows of tables: their cells, and the message and the field that each is about."""

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.statements.subjects import About, about
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern


@dataclass(frozen=True, slots=True)
class Row:
    """A row, its cells as bounds in the short text, and the message that it is about, if it names one.

    ``field_column`` is the first column whose cell is one name of a field.
    """

    span: Span
    cells: tuple[tuple[int, int], ...]
    message: WireMessage | None
    field_column: int | None

    def number(self, column: int) -> int | None:
        """The offset of the number that is all of a cell, or of ``N bytes``."""
        if column >= len(self.cells):
            return None
        low, high = self.cells[column]
        found = _NUMBER.fullmatch(self.span.text, low, high)
        return None if found is None else found.start("number")


_FIELD = pattern(r"\s*(?P<name>[FP])\s*(?:\[[^\]|]*\])?\s*")
_NUMBER = pattern(r"\s*#?(?P<number>N)(?: ?bytes?| b)?\s*")
_MESSAGE = pattern(r"\s*(?P<message>M)(?: \([^)]*\))?\s*")


def row_of(reading: Reading, span: Span) -> Row:
    """Return the row of a part: the message is the only one that a cell is, or the one of the first cell."""
    text = span.text
    start = text.index("|") + 1 if text.lstrip().startswith("|") else 0
    cells: list[tuple[int, int]] = []
    for cell in text[start:].rstrip("| ").split("|"):
        cells.append((start, start + len(cell)))
        start += len(cell) + 1
    found = [each for low, high in cells if (each := _MESSAGE.fullmatch(text, low, high)) is not None]
    names = list(dict.fromkeys(str(span.sentence.term(each.start("message")).value) for each in found))
    first = _MESSAGE.fullmatch(text, *cells[0]) if cells else None
    message = reading.messages[names[0]] if len(names) == 1 or (first is not None and names) else None
    column = next((at for at, cell in enumerate(cells) if _FIELD.fullmatch(text, *cell)), None)
    return Row(span, tuple(cells), message, column)


def field_of(reading: Reading, row: Row) -> About | None:
    """Return the field of a row: the first cell that is one name of a field."""
    column = row.field_column
    found = None if column is None else _FIELD.fullmatch(row.span.text, *row.cells[column])
    return None if found is None else about(reading, row.span, found.start("name"))
