"""Tables that are written in HTML, as lines of a Markdown table: whatever reads those reads them, too.

GitHub shows both alike, and documents have HTML where an entry has several lines, or where a tool wrote the table.
"""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from itertools import accumulate

from codegen.frozen import dataclass
from codegen.pattern import pattern

_TAG = pattern(r"<(/?)([A-Za-z][A-Za-z0-9]*)[^<>]*>")

_STRUCK = frozenset(("del", "s", "strike"))
_BAR = "\u00a6"
"""In place of a bar within an entry, which would end it."""
_LARGEST = 100_000
"""Entries of the largest table that is read: each row is filled up to the longest."""


@dataclass(frozen=True, slots=True)
class Row:
    """A row as Markdown: its ``line`` and ``column`` count from 0, where its text is as far to the right as in HTML.

    Of a row of several lines the place is where its first entry has text.
    """

    text: str
    line: int
    column: int


def tables_of(lines: Sequence[str]) -> Iterator[tuple[Row, ...]]:
    """Yield the tables of some lines, each with the delimiter row of Markdown behind its first row."""
    reader = _Reader(lines)
    reader.read()
    for table in reader.tables:
        rows = [row for row in table if row]
        most = max(map(len, rows), default=0)
        if 0 < most * len(rows) <= _LARGEST:
            found = [_row(row + [_Entry()] * (most - len(row))) for row in rows]
            yield (found[0], Row(f"|{'---|' * most}", found[0].line, 0), *found[1:])


class _Entry:
    """The text that an entry shows, in pieces, each with the line and column at which it stands."""

    def __init__(self, line: int = -1, column: int = -1) -> None:
        self.start = line, column
        self.pieces: list[tuple[int, int, str]] = []


def _row(entries: list[_Entry]) -> Row:
    pieces = [piece for entry in entries for piece in entry.pieces if piece[2].strip()]
    starts = [entry.start for entry in entries if entry.start[0] >= 0]
    at = {line for line, _ in starts} | {line for line, _, _ in pieces}
    if len(at) == 1 and len(starts) == len(entries):
        return _in_place(starts, pieces)
    texts = (" ".join("".join(text for _, _, text in entry.pieces).split()) for entry in entries)
    line, column = min(((line, column) for line, column, _ in pieces), default=min(starts, default=(0, 0)))
    return Row(f"| {' | '.join(texts)} |", line, max(column - 2, 0))


def _in_place(starts: list[tuple[int, int]], pieces: list[tuple[int, int, str]]) -> Row:
    """Return a row of one line, in which each character of an entry stands where it is in HTML."""
    line, low = starts[0]
    high = max([column for _, column in starts] + [column + len(text) for _, column, text in pieces])
    written = [" "] * (high - low + 1)
    for _, column, text in pieces:
        written[column - low : column - low + len(text)] = text
    for _, column in starts:
        written[column - low] = "|"
    return Row("".join(written).rstrip() + " |", line, low)


class _Reader:
    """Collects the rows of tables, entry by entry."""

    def __init__(self, lines: Sequence[str]) -> None:
        self.tables: list[list[list[_Entry]]] = []
        self._starts = [0, *accumulate(len(line) + 1 for line in lines)]
        self._text = "\n".join(lines)
        self._rows: list[list[_Entry]] | None = None
        self._entry: _Entry | None = None
        self._struck = 0
        self._has_comments = True

    def read(self) -> None:
        """Go through the text once, from tag to tag; what is no tag is text, and comments are not shown."""
        shown = at = 0
        while (at := self._text.find("<", at)) >= 0:
            end = self._end_of_comment(at)
            found = _TAG.match(self._text, at) if end < 0 else None
            if found is not None:
                end = found.end()
            if end < 0:
                at += 1
                continue
            self._show(shown, at)
            if found is not None and found[1]:
                self._close(found[2].lower(), at)
            elif found is not None:
                self._open(found[2].lower(), at, end)
            shown = at = end
        self._show(shown, len(self._text))

    def _end_of_comment(self, at: int) -> int:
        """Return where a comment ends that begins at ``at``; -1 where there is none, or it never ends."""
        if self._has_comments and self._text.startswith("<!--", at):
            end = self._text.find("-->", at + 4)
            self._has_comments = end >= 0  # else none behind it ends either
            return end + 3 if end >= 0 else -1
        return -1

    def _open(self, tag: str, start: int, end: int) -> None:
        if tag == "table":
            self._rows = []
            self.tables.append(self._rows)
        elif tag == "tr" and self._rows is not None:
            self._entry = None
            self._rows.append([])
        elif tag in ("td", "th") and self._rows:
            self._entry = _Entry(*self._place(start))
            self._rows[-1].append(self._entry)
        elif tag == "code":
            self._add("`", end - 1)
        elif tag == "br":
            self._add(" ", start)
        self._struck += tag in _STRUCK

    def _close(self, tag: str, start: int) -> None:
        if tag in ("td", "th", "tr", "table"):
            self._entry = None
            self._rows = None if tag == "table" else self._rows
        elif tag == "code":
            self._add("`", start)
        self._struck = max(0, self._struck - (tag in _STRUCK))

    def _show(self, start: int, end: int) -> None:
        """Add the text between two tags, by its lines; an end of a line is a blank."""
        at = start
        for number, text in enumerate(self._text[start:end].split("\n")):
            if number:
                self._add(" ", at - 1)
            self._add(text, at)
            at += len(text) + 1

    def _add(self, text: str, at: int) -> None:
        if text and self._entry is not None and not self._struck:
            self._entry.pieces.append((*self._place(at), text.replace("|", _BAR)))

    def _place(self, at: int) -> tuple[int, int]:
        line = bisect_right(self._starts, at) - 1
        return line, at - self._starts[line]
