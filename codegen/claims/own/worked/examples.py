"""The worked examples of a document: the tables and the text below a heading that says that it has examples."""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from codegen.claims.field_notes import cells
from codegen.claims.own.worked.amount import Amount, amounts
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.frozen import dataclass
from codegen.load.prose import Passage, PassageKind
from codegen.model.system import System
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

EXAMPLE = Rule(
    "claim-example",
    "A worked example says another number than follows from the specification, or from the other numbers beside it. "
    "Correct the example, or the number that it was computed from. codegen check --examples lists the numbers of "
    "worked examples that nothing can compute.",
    remedy="write the number that follows, or correct the one that it was computed from",
)

_BRACKETS = pattern(r"\(([^()]{1,18})\)$")
_HEADING = pattern(r"\b(?:worked )?examples?\b", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Entry:
    """One entry of a row: its text, where that begins in the passage, and its numbers."""

    text: str
    start: int
    amounts: tuple[Amount, ...]

    @property
    def alone(self) -> Amount | None:
        """The number that the entry begins with, or None."""
        first = self.amounts[0] if self.amounts else None
        return first if first is not None and first.start == self.start else None

    @property
    def only(self) -> Amount | None:
        """The number that it consists of, or None."""
        found = self.alone
        return found if found is not None and found.end == self.start + len(self.text) else None


@dataclass(frozen=True, slots=True)
class Row:
    """A row of a table; empty entries at its end are left out."""

    passage: Passage
    entries: tuple[Entry, ...]

    def at(self, column: int | None) -> Entry | None:
        """The entry of a column, or None."""
        return self.entries[column] if column is not None and column < len(self.entries) else None

    def only(self, column: int | None) -> Amount | None:
        """The number that the entry of a column consists of, or None."""
        entry = self.at(column)
        return entry.only if entry is not None else None


@dataclass(frozen=True, slots=True)
class Table:
    """A table; ``intro`` is the text directly before it, or None, ``number`` its place.

    ``heads`` are the headings of its columns, ``units`` those that they end with in brackets: ``Rounded (mV)``.
    """

    head: Row
    rows: tuple[Row, ...]
    intro: Passage | None
    number: int
    heads: tuple[str, ...]
    units: tuple[Unit | None, ...]

    def amount(self, row: Row, column: int | None) -> Amount | None:
        """The number that the entry of a column begins with, in the unit of the heading where it has none; or None."""
        entry = row.at(column)
        found = entry.alone if entry is not None else None
        unit = self.units[column] if column is not None and column < len(self.heads) else None
        return replace(found, unit=unit) if found is not None and found.is_plain and unit is not None else found

    def column(self, form: "re.Pattern[str]") -> int | None:
        """The first column whose heading matches as a whole, or None."""
        return next((index for index, head in enumerate(self.heads) if form.fullmatch(head)), None)


@dataclass(frozen=True, slots=True)
class Statement:
    """A row of two entries: what is said, and the number that it is."""

    passage: Passage
    label: Entry
    value: Entry
    table: Table


@dataclass(frozen=True, slots=True)
class Examples:
    """The worked examples of a document, in its order; ``statements`` are the rows of two columns."""

    reading: Reading
    tables: tuple[Table, ...]
    texts: tuple[Passage, ...]
    statements: tuple[Statement, ...]

    @property
    def systems(self) -> tuple[System, ...]:
        """The programs of the project that the document is compared with; none without a project."""
        return self.reading.reference.systems

    def judged(self, passage: Passage, amount: Amount, expected: Collection[Fraction], of: str) -> Iterator[Diagnostic]:
        """A finding where a number is none of those that are ``expected`` (in its unit), if anything is."""
        if expected and not any(amount.shows(each) for each in expected):
            shown = " or ".join(dict.fromkeys(amount.spelled(each) for each in expected))
            yield self.wrong(passage, amount.start, f"{of} is {shown}, not {amount.written}")

    def wrong(self, passage: Passage, at: int, message: str) -> Diagnostic:
        """A finding at an offset of a passage; a waiver knows it by the whole row or sentence."""
        start, end = passage.sentence(at, at) if passage.kind is not PassageKind.ROW else (0, len(passage.text))
        claim = f"{passage.text[start:end].strip()}: {message}"
        return self.reading.found(EXAMPLE, passage.place_at(at), claim, message)


def read_examples(reading: Reading) -> Examples:
    """The worked examples of a document."""
    tables: list[Table] = []
    texts: list[Passage] = []
    depth = 0
    rows: list[Passage] = []
    intro: Passage | None = None
    for part in reading.prose.parts:
        passage = part if isinstance(part, Passage) else None
        if passage is None or passage.kind is not PassageKind.ROW:
            tables += _tables(rows, intro, len(tables))
            rows = []
        if passage is None:
            continue
        if passage.kind is PassageKind.HEADING:
            if _HEADING.search(passage.text) and not 0 < depth < passage.level:
                depth, intro = passage.level, None
            elif passage.level <= depth:
                depth = 0
        elif depth and passage.kind is PassageKind.ROW:
            rows.append(passage)
        elif depth:
            texts.append(passage)
            intro = passage
    tables += _tables(rows, intro, len(tables))
    return Examples(reading, tuple(tables), tuple(texts), tuple(_statements(tables)))


def _statements(tables: Sequence[Table]) -> Iterator[Statement]:
    for table in tables:
        for row in table.rows if len(table.heads) == 2 else ():
            if len(row.entries) == 2:
                yield Statement(row.passage, *row.entries, table)


def _tables(rows: Sequence[Passage], intro: Passage | None, number: int) -> Iterator[Table]:
    """The tables of rows that follow each other: a head, the line below it, and rows on one line after the other."""
    first = 0
    for index, passage in enumerate(rows):
        is_last = index + 1 == len(rows)
        if is_last or (index > first and rows[index + 1].place.line - passage.place.line > 1):
            if index > first:
                head, *own = (_row(each) for each in rows[first : index + 1])
                heads = tuple(entry.text for entry in head.entries)
                found = (_BRACKETS.search(each) for each in heads)
                units = tuple(Unit.parse(each[1]) if each else None for each in found)
                cut = tuple(replace(row, entries=row.entries[: len(heads)]) for row in own)
                yield Table(head, cut, intro, number, heads, units)
                number, intro = number + 1, None
            first = index + 1


def _row(passage: Passage) -> Row:
    entries = []
    for text, start in cells(passage):
        bare = text.strip()
        entries.append(Entry(bare, start, amounts(passage.text, start, start + len(bare))))
    return Row(passage, tuple(entries))
