"""Reads a document's statements about fields: the rows of its tables and the items of its lists that name a field."""

import re
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import takewhile

from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.importing.columns import Role, column_roles, unit_of
from codegen.load.markdown_blocks import Block, BlockKind, parse_blocks, read_inline
from codegen.load.markdown_table import Cell, Row, Table, parse_tables
from codegen.pattern import pattern
from codegen.source import Place

# name, name[2], name[1..9], name[1-9], name[1:9], name[1…9]; with a dash of any length.
_LABEL = pattern(
    r"(?:[A-Z][A-Z0-9_]*\.)?([A-Za-z_]\w*)\s*(?:\[\s*(\d{1,3})\s*(?:(?:\.{2,3}|…|-|\u2013|:|,|to)\s*(\d{1,3}))?\s*\])?"
)
# A field at the begin of a list item: in code, or bare; then a mark and the answer.
_ITEM = pattern(
    r"(?P<mark>`{0,2}|\*\*`?|__)(?P<label>[A-Za-z_][\w.]*(?:\\?\[[^\]`]{1,12}\])?)(?:`?\*\*|`{0,2}|__)"
    r"\s*(?::|=|→|->|[\u2013\u2014-]\s)(?:\*\*)?\s*(?P<answer>\S.*)",
    re.DOTALL,
)


_PARAGRAPHS = 12
"""The number of paragraphs of a section that are looked at: earlier ones are about something else."""


@dataclass(frozen=True, slots=True)
class StatedField:
    """One row: ``name`` and the elements ``first`` to ``last`` (None: the whole field), with a cell for each role.

    ``unit`` is what the heading of the values says of their numbers, or empty.
    """

    name: str
    first: int | None
    last: int | None
    place: Place
    cells: dict[Role, Cell]
    unit: str = ""

    @property
    def label(self) -> str:
        """``voltages``, ``voltages[0]`` or ``voltages[1..9]``, as the tables write it."""
        if self.first is None:
            return self.name
        return f"{self.name}[{self.first}]" if self.last == self.first else f"{self.name}[{self.first}..{self.last}]"


_ITEM_ROLES = frozenset({Role.FIELD, Role.VALUE})


@dataclass(frozen=True, slots=True)
class FieldList:
    """Rows that belong together. ``context`` is the text around them that may name the message.

    The nearest above comes first, what stands right below them last. ``unnamed`` are values in rows without a field.
    """

    rows: tuple[StatedField, ...]
    place: Place
    context: tuple[str, ...]
    roles: frozenset[Role]
    unnamed: tuple[Cell, ...] = ()

    @property
    def is_descriptive(self) -> bool:
        """Return whether it tells what fields are, by type, unit or sentinel, and nothing of what goes into them."""
        return Role.VALUE not in self.roles and bool(self.roles & {Role.TYPE, Role.UNIT, Role.UNKNOWN})


@dataclass(frozen=True, slots=True)
class StatedFields:
    """Every list of fields of a document in its order, and what is wrong with the form of the document.

    ``others`` are the tables in which no column of fields is known by its heading, and ``other_contexts`` the texts
    around each of them.
    """

    lists: tuple[FieldList, ...]
    findings: tuple[Diagnostic, ...]
    others: tuple[Table, ...] = ()
    other_contexts: tuple[tuple[str, ...], ...] = ()


def stated_fields(text: str, path: str) -> StatedFields:
    """Return what a Markdown text states, in tables with a column of fields and in lists of the form ``- `field`:
    answer``.

    Whether the names are those of a message is for the reader to say, who knows a dialect.
    """
    blocks = parse_blocks(text, path)
    found = parse_tables(text, path)
    findings = list(found.findings)
    lists: list[tuple[FieldList, str]] = []
    others: list[Table] = []
    for table in found.tables:
        roles, unclear = column_roles(table.header)
        rows = tuple(_table_rows(table, roles))
        if rows:
            findings.extend(unclear)
            unnamed = tuple(_unnamed(table, roles))
            heading = table.header.cells[roles[Role.FIELD]].text
            lists.append((FieldList(rows, table.place, (), frozenset(roles), unnamed), heading))
        else:
            others.append(table)
    lists.extend((FieldList(rows, rows[0].place, (), _ITEM_ROLES), "") for rows in _bullet_lists(blocks))
    lists.sort(key=lambda one: one[0].place)
    contexts = _contexts(blocks, [fields.place.line for fields, _ in lists])
    return StatedFields(
        tuple(
            replace(fields, context=(heading, *context) if heading.isupper() else context)
            for (fields, heading), context in zip(lists, contexts, strict=True)
        ),
        tuple(findings),
        tuple(others),
        tuple(_contexts(blocks, [table.place.line for table in others])),
    )


def columns_of(table: Table, context: tuple[str, ...]) -> Iterator[FieldList]:
    """Yield each column of a table whose headings are not known, as the list of fields that it may be."""
    for column in range(len(table.header.cells)):
        cells = [cell for row in table.rows if (cell := _cell_at(row, column)) is not None]
        matches = [(match, cell) for cell in cells if (match := _LABEL.fullmatch(cell.text)) is not None]
        rows = tuple(_stated(match, cell.place, {}) for match, cell in matches)
        if rows:
            yield FieldList(rows, table.place, context, frozenset())


def _unnamed(table: Table, roles: dict[Role, int]) -> Iterator[Cell]:
    """Yield the values of rows whose cell for the field is empty, as in a table whose cells were merged."""
    if Role.VALUE not in roles:
        return
    for row in table.rows:
        name, value = _cell_at(row, roles[Role.FIELD]), _cell_at(row, roles[Role.VALUE])
        if name is not None and not name.text and value is not None and value.text:
            yield value


def _table_rows(table: Table, roles: dict[Role, int]) -> Iterator[StatedField]:
    """One for each field that a row names; a cell may name several, with commas between them."""
    if Role.FIELD not in roles or len(roles) == 1:
        return
    unit = unit_of(table.header.cells[roles[Role.VALUE]].text) if Role.VALUE in roles else ""
    for row in table.rows:
        cell = _cell_at(row, roles[Role.FIELD])
        if cell is None or not cell.text:
            continue
        cells = {role: found for role, index in roles.items() if (found := _cell_at(row, index))}
        matches = [_LABEL.fullmatch(part) for part in re.split(r",\s*|\s+and\s+|\s*/\s*", cell.text)]
        if all(matches):
            yield from (_stated(match, cell.place, cells, unit) for match in matches if match)
        else:
            yield StatedField(cell.text, None, None, cell.place, cells, unit)


def _cell_at(row: Row, index: int) -> Cell | None:
    return row.cells[index] if index < len(row.cells) else None


def _stated(match: re.Match[str], place: Place, cells: dict[Role, Cell], unit: str = "") -> StatedField:
    name, first, last = match.groups()
    begin = None if first is None else int(first)
    return StatedField(name, begin, begin if last is None else int(last), place, cells, unit)


def _bullet_lists(blocks: Sequence[Block]) -> Iterator[tuple[StatedField, ...]]:
    """Runs of items of one depth that begin with a field; items of lists within them do not end a run."""
    run: list[StatedField] = []
    depth = 0
    for block in blocks:
        stated = _stated_item(block) if block.begins_item else None
        is_sibling = block.begins_item and block.depth == depth
        if run and (block.kind is BlockKind.HEADING or block.depth < depth or (is_sibling and stated is None)):
            yield tuple(run)
            run = []
        if stated is not None and (not run or is_sibling):
            depth = block.depth
            run.append(stated)
    if run:
        yield tuple(run)


def _stated_item(block: Block) -> StatedField | None:
    written = block.written
    match = _ITEM.match(written)
    label = _LABEL.fullmatch(match["label"].replace("\\", "")) if match else None
    if match is None or label is None:
        return None
    seen = read_inline(match["answer"])
    cells = {
        Role.FIELD: Cell(label[0], (), label[0], _place_in(block, match.start("label"))),
        Role.VALUE: Cell(seen.text, seen.codes, match["answer"], _place_in(block, match.start("answer"))),
    }
    return _stated(label, cells[Role.FIELD].place, cells)


def _place_in(block: Block, position: int) -> Place:
    """The place of a character of ``block.written``."""
    before = block.written[:position]
    line = block.lines[before.count("\n")]
    return line.place._replace(column=line.place.column + position - (before.rfind("\n") + 1))


def _is_prose(text: str) -> bool:
    return not text.startswith("|")


def _behind(blocks: Sequence[Block], line: int) -> Iterator[str]:
    """The paragraph that follows a table or list in its own section."""
    for block in blocks:
        if block.place.line <= line or block.depth:
            continue
        if block.kind is BlockKind.PARAGRAPH and _is_prose(block.lines[0].text):
            yield block.written
        if block.kind is not BlockKind.PARAGRAPH or _is_prose(block.lines[0].text):
            return


def _contexts(blocks: Sequence[Block], lines: Sequence[int]) -> Iterator[tuple[str, ...]]:
    """Yield for each of the lines, in rising order, the text above it, the nearest first.

    That is the text of its own section, the headings around it from the innermost, what stands further up, and the
    paragraph right below.
    """
    headings: list[str] = []
    further: deque[str] = deque(maxlen=_PARAGRAPHS)
    above: deque[str] = deque(maxlen=_PARAGRAPHS)
    rest = iter(blocks)
    block = next(rest, None)
    for line in lines:
        while block is not None and block.place.line < line:
            if block.kind is BlockKind.HEADING:
                headings[block.level - 1 :] = [""] * (block.level - 1 - len(headings)) + [block.written]
                further.extend(above)
                above.clear()
            elif block.kind is BlockKind.PARAGRAPH:
                # Of a paragraph with a table only what stands above the table tells what the table is about.
                above.append("\n".join(takewhile(_is_prose, (one.text for one in block.lines))))
            block = next(rest, None)
        written = (*reversed(above), *reversed(headings), *reversed(further), *_behind(blocks, line))
        yield tuple(text for one in written if (text := read_inline(one).text))
