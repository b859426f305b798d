"""The tables of a Markdown text (GitHub's extension) as rows of cells with their places, and what damages them.

A Markdown parser never complains: it fills a row up, drops what is too much, or shows no table at all. Here each of
these is a finding at its place, and the cells are read as they are written.
"""

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.frozen import dataclass
from codegen.load.markdown_blocks import Block, BlockKind, Line, parse_blocks, read_inline
from codegen.pattern import pattern
from codegen.source import Place

TABLE_DELIMITER = Rule(
    "table-delimiter",
    "The second line of a Markdown table is the delimiter row, | --- | --- |, with as many cells as the header above "
    "it. Where it is missing, has another number of cells or other characters, renderers show no table but text full "
    "of bars.",
)
TABLE_CELL_SURPLUS = Rule(
    "table-cell-surplus",
    "A row has more cells than the header. Renderers drop what is too much without a word. Escape a bar that belongs "
    r"to a text as \|, also inside of code, or add a column.",
)
TABLE_CELL_MISSING = Rule(
    "table-cell-missing",
    "A row has fewer cells than the header, so that renderers fill it up with empty ones: a bar is missing.",
    Severity.WARNING,
)
TABLE_BAR = Rule(
    "table-bar-in-code",
    "A bar inside of a code span ends the cell of a Markdown table all the same, and what follows moves to the next "
    r"column. Escape it: `a \| b`.",
)
TABLE_TEXT = Rule(
    "table-with-text",
    "A line of text follows a table without an empty line between them, so that renderers show it as a row.",
    Severity.WARNING,
)
TABLE_RUN_TOGETHER = Rule(
    "table-run-together",
    "A delimiter row stands in the middle of a table: two tables without an empty line between them. Renderers show "
    "the second header and its delimiter row as rows of the first table.",
    Severity.WARNING,
)

_DELIMITER_CELL = pattern(r":?-+:?")
_DASHES = pattern(r"[\s|:+=_\u2010-\u2015-]*")  # what word processors make of hyphens, and other styles of tables
_BACKTICKS = pattern(r"`+")


@dataclass(frozen=True, slots=True)
class Cell:
    r"""One cell. ``text`` is what a reader sees, ``codes`` what stands in code spans, ``written`` the source.

    In ``written`` the escape of bars is undone (``\|`` is ``|``), other escapes are kept; ``place`` is the first
    character of the content, or of the blank where there is none.
    """

    text: str
    codes: tuple[str, ...]
    written: str
    place: Place


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a table with its cells as they are written, which may be fewer or more than the header has."""

    cells: tuple[Cell, ...]
    place: Place


@dataclass(frozen=True, slots=True)
class Table:
    """A header and the rows below it.

    ``headings`` are the titles of the sections that it stands in, from the outermost, ``lead`` is the text of the
    paragraph before it, empty where a heading or another table is nearer. ``is_shown`` tells whether renderers show a
    table.
    """

    header: Row
    rows: tuple[Row, ...]
    headings: tuple[str, ...]
    lead: str
    is_shown: bool = True

    @property
    def place(self) -> Place:
        """Return where the header begins."""
        return self.header.place


@dataclass(frozen=True, slots=True)
class FoundTables:
    """The tables of a document in its order, and what damages them."""

    tables: tuple[Table, ...]
    findings: tuple[Diagnostic, ...]


@dataclass(frozen=True, slots=True)
class _Piece:
    """The text between two bars and its column in the line, both from the first character behind the bar."""

    written: str
    column: int


@cache
def parse_tables(text: str, path: str) -> FoundTables:
    """Every table of a text, those in lists and quotes and those right below a line of text included; none of code."""
    tables: list[Table] = []
    findings: list[Diagnostic] = []
    headings: list[str] = []
    lead = ""
    for block in parse_blocks(text, path):
        if block.kind is BlockKind.CODE:
            continue
        # A row that a line of hyphens below the table has made a heading is still a row.
        if block.kind is BlockKind.HEADING and len(block.lines) == 1:
            headings[block.level - 1 :] = [""] * (block.level - 1 - len(headings)) + [read_inline(block.written).text]
            lead = ""
            continue
        above = tuple(heading for heading in headings if heading)
        lead = _read_block(block, above, lead, tables, findings)
    return FoundTables(tuple(tables), tuple(findings))


def _read_block(
    block: Block, headings: tuple[str, ...], lead: str, tables: list[Table], findings: list[Diagnostic]
) -> str:
    """Add the tables of one block, and return what is the lead of a table in the next one."""
    lines = block.lines
    if not any("|" in line.text for line in lines):
        return read_inline(block.written).text
    starts = [index for index in range(1, len(lines)) if _is_header(lines, index - 1)]
    if not starts:
        findings.extend(_without_delimiter(lines))
        return read_inline(block.written).text
    if starts[0] > 1:
        lead = read_inline("\n".join(line.text for line in lines[: starts[0] - 1])).text
    for start, end in zip(starts, [*(following - 1 for following in starts[1:]), len(lines)], strict=True):
        header, delimiter = _row(lines[start - 1]), _pieces(lines[start].text)
        is_shown = _is_delimiter(lines[start].text) and len(delimiter) == len(header.cells)
        if not is_shown:
            findings.append(_unfit(header, lines[start], delimiter))
        if start != starts[0]:
            findings.append(_run_together(header, tables[-1]))
        findings.extend(_bar_in_code(lines[start - 1]))
        rows, lead_in = [], lead
        for index in range(start + 1, end):
            if "|" not in lines[index].text:
                findings.append(_text_below(lines[index], header))
                lead = read_inline("\n".join(line.text for line in lines[index:end])).text
                break
            rows.append(_row(lines[index]))
            findings.extend(_damage(lines[index], rows[-1], header))
        else:
            lead = ""
        tables.append(Table(header, tuple(rows), headings, lead_in, is_shown))
    return lead


def _is_header(lines: Sequence[Line], index: int) -> bool:
    """Return whether a line and the one below it are meant as header and delimiter row, fitting or not."""
    header, below = lines[index].text, lines[index + 1].text
    if "|" not in header or "|" not in below or _is_dashes(header):
        return False
    return _is_delimiter(below) or _is_dashes(below)


def _is_delimiter(text: str) -> bool:
    return all(_DELIMITER_CELL.fullmatch(piece.written.strip()) for piece in _pieces(text))


def _is_dashes(text: str) -> bool:
    """Return whether a line looks like a delimiter row, though a parser may not take it for one."""
    return _DASHES.fullmatch(text) is not None and all(piece.written.strip(" \t:") for piece in _pieces(text))


def _pieces(text: str) -> list[_Piece]:
    r"""The cells of a line: parted at each bar without a backslash before it; the outer bars are no borders of cells.

    As GitHub and markdown-it read it, a bar is escaped wherever it stands, in code spans too.
    """
    bars = [index for index, one in enumerate(text) if one == "|" and (index == 0 or text[index - 1] != "\\")]
    bounds = [-1, *bars, len(text)]
    pieces = [_Piece(text[left + 1 : right], left + 1) for left, right in pairwise(bounds)]
    if bars and not pieces[0].written.strip():
        pieces.pop(0)
    if bars and len(pieces) > 1 and not pieces[-1].written.strip():
        pieces.pop()
    return pieces


def _row(line: Line) -> Row:
    return Row(tuple(_cell(piece, line.place) for piece in _pieces(line.text)), line.place)


def _cell(piece: _Piece, line: Place) -> Cell:
    content = piece.written.strip()
    indent = len(piece.written) - len(piece.written.lstrip()) if content else 0
    place = line._replace(column=line.column + piece.column + indent)
    written = content.replace("\\|", "|")
    seen = read_inline(written)
    return Cell(seen.text, seen.codes, written, place)


def _damage(line: Line, row: Row, header: Row) -> Iterator[Diagnostic]:
    """Yield what is wrong with one row."""
    width, count = len(header.cells), len(row.cells)
    related = ((header.place, "the header is here"),)
    in_code = list(_bar_in_code(line))
    if in_code:
        yield from in_code
    elif count > width:
        surplus = row.cells[width]
        lost = " | ".join(cell.written for cell in row.cells[width:])
        message = f"the row has {count} cells, the header {width}: readers never see {lost!r}"
        hint = r"write \| for a bar that belongs to a text, or add a column"
        yield Diagnostic(surplus.place, TABLE_CELL_SURPLUS, message, hint, related)
    elif count < width:
        missing = ", ".join(cell.text or "(no name)" for cell in header.cells[count:])
        message = f"the row has {_cells(count)}, the header {width}: nothing for {missing}"
        yield Diagnostic(row.place, TABLE_CELL_MISSING, message, "add the missing bars", related)


def _bar_in_code(line: Line) -> Iterator[Diagnostic]:
    """The first bar that stands within a code span, if the line is looked at as a whole."""
    text = line.text
    ticks = list(_BACKTICKS.finditer(text))
    position = 0
    while position < len(ticks):
        opening, following = ticks[position], range(position + 1, len(ticks))
        end = next((index for index in following if len(ticks[index][0]) == len(opening[0])), None)
        position += 1
        # A mark in the middle of a word is an apostrophe, not code.
        if end is None or text[opening.start() - 1 : opening.start()].isalnum():
            continue
        closing, position = ticks[end], end + 1
        for index in range(opening.end(), closing.start()):
            if text[index] == "|" and text[index - 1] != "\\":
                code = text[opening.end() : closing.start()].strip()
                place = line.place._replace(column=line.place.column + index)
                message = f"the bar inside of the code {code!r} ends the cell"
                yield Diagnostic(place, TABLE_BAR, message, r"write \| for it")
                return


def _unfit(header: Row, line: Line, delimiter: Sequence[_Piece]) -> Diagnostic:
    """Return why a delimiter row is none for renderers."""
    width = len(header.cells)
    wrong = next((one for one in delimiter if not _DELIMITER_CELL.fullmatch(one.written.strip())), None)
    related = ((header.place, "the header is here"),)
    hint = f"write | {' | '.join(['---'] * width)} |"
    if wrong is not None:
        indent = len(wrong.written) - len(wrong.written.lstrip())
        place = line.place._replace(column=line.place.column + wrong.column + indent)
        message = f"{wrong.written.strip()!r} is no cell of a delimiter row, so this is no table"
        return Diagnostic(place, TABLE_DELIMITER, message, hint, related)
    message = f"the delimiter row has {_cells(len(delimiter))}, the header {width}, so this is no table"
    return Diagnostic(line.place, TABLE_DELIMITER, message, hint, related)


def _without_delimiter(lines: Sequence[Line]) -> Iterator[Diagnostic]:
    """Lines between bars, of equal numbers of cells, that no delimiter row makes a table."""
    rows = [line for line in lines if line.text.strip().startswith("|") and line.text.strip().endswith("|")]
    counts = {len(_pieces(line.text)) for line in rows}
    if len(rows) < 2 or len(rows) < len(lines) or len(counts) != 1 or counts == {1}:
        return
    (width,) = counts
    first = rows[0]
    message = "the header of the table is missing" if _is_dashes(first.text) else "the table has no delimiter row"
    hint = f"write | {' | '.join(['---'] * width)} | below the header"
    yield Diagnostic(first.place, TABLE_DELIMITER, f"{message}, so this is no table", hint)


def _text_below(line: Line, header: Row) -> Diagnostic:
    message = "renderers show this text as a row of the table above it"
    hint = "put an empty line between the table and the text"
    return Diagnostic(line.place, TABLE_TEXT, message, hint, ((header.place, "the table begins here"),))


def _run_together(header: Row, before: Table) -> Diagnostic:
    message = "a second table begins here, but renderers go on with the first"
    return Diagnostic(
        header.place,
        TABLE_RUN_TOGETHER,
        message,
        "put an empty line before its header",
        ((before.place, "the first one begins here"),),
    )


def _cells(count: int) -> str:
    return "1 cell" if count == 1 else f"{count} cells"
