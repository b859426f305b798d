"""Tables that are written in HTML, as lines of a Markdown table: whatever reads those reads them, too.

GitHub shows both alike, and documents have HTML where an entry has several lines, or where a tool wrote the table.
"""

from collections.abc import Iterator, Sequence
from html.parser import HTMLParser

from codegen.frozen import dataclass

_STRUCK = frozenset(("del", "s", "strike"))
_BAR = "\u00a6"
"""In place of a bar within an entry, which would end it."""


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
    reader = _Reader()
    reader.feed("\n".join(lines))
    reader.close()
    for table in reader.tables:
        rows = [row for row in table if row]
        most = max(map(len, rows), default=0)
        if most:
            found = [_row(row + [_Entry()] * (most - len(row)), lines) for row in rows]
            yield (found[0], Row(f"|{'---|' * most}", found[0].line, 0), *found[1:])


class _Entry:
    """The text that an entry shows, in pieces, each with the line and column at which it stands."""

    def __init__(self, line: int = -1, column: int = -1) -> None:
        self.start = line, column
        self.pieces: list[tuple[int, int, str]] = []


def _row(entries: list[_Entry], lines: Sequence[str]) -> Row:
    pieces = [piece for entry in entries for piece in entry.pieces if piece[2].strip()]
    starts = [entry.start for entry in entries if entry.start[0] >= 0]
    at = {line for line, _ in starts} | {line for line, _, _ in pieces}
    if len(at) == 1 and len(starts) == len(entries):
        return _in_place(starts, pieces, lines[starts[0][0]])
    texts = (" ".join("".join(text for _, _, text in entry.pieces).split()) for entry in entries)
    line, column = min(((line, column) for line, column, _ in pieces), default=min(starts, default=(0, 0)))
    return Row(f"| {' | '.join(texts)} |", line, max(column - 2, 0))


def _in_place(starts: list[tuple[int, int]], pieces: list[tuple[int, int, str]], line: str) -> Row:
    """Return a row of one line, in which each character of an entry stands where it is in HTML."""
    written = [" "] * (len(line) + 1)
    for _, column, text in pieces:
        written[column : column + len(text)] = text
    for _, column in starts:
        written[column] = "|"
    return Row("".join(written).rstrip() + " |", starts[0][0], 0)


class _Reader(HTMLParser):
    """Collects the rows of tables, entry by entry."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=False)
        self.tables: list[list[list[_Entry]]] = []
        self._rows: list[list[_Entry]] | None = None
        self._entry: _Entry | None = None
        self._struck = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:  # noqa: ARG002  the base has it
        line, column = self.getpos()
        if tag == "table":
            self._rows = []
            self.tables.append(self._rows)
        elif tag == "tr" and self._rows is not None:
            self._entry = None
            self._rows.append([])
        elif tag in ("td", "th") and self._rows:
            self._entry = _Entry(line - 1, column)
            self._rows[-1].append(self._entry)
        elif tag == "code":
            self._put("`", len(self.get_starttag_text() or "") - 1)
        elif tag == "br":
            self._put(" ")
        self._struck += tag in _STRUCK

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th", "tr", "table"):
            self._entry = None
            self._rows = None if tag == "table" else self._rows
        elif tag == "code":
            self._put("`")
        self._struck = max(0, self._struck - (tag in _STRUCK))

    def handle_data(self, data: str) -> None:
        line, column = self.getpos()
        for number, text in enumerate(data.split("\n")):
            self._add(line - 1 + number, 0 if number else column, " " if number and not text else text)

    def handle_entityref(self, name: str) -> None:
        self._put(f"&{name};")

    def handle_charref(self, name: str) -> None:
        self._put(f"&#{name};")

    def _put(self, text: str, behind: int = 0) -> None:
        line, column = self.getpos()
        self._add(line - 1, column + behind, text)

    def _add(self, line: int, column: int, text: str) -> None:
        if self._entry is not None and not self._struck:
            self._entry.pieces.append((line, column, text.replace("|", _BAR)))
