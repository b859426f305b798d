"""Numbers of a row that follow from others beside them: sums, means, shares of a whole, counts of fewer bits."""

import re
from collections.abc import Iterator
from fractions import Fraction
from math import floor

from codegen.claims.own.worked.examples import Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.model.units.unit import unit_named
from codegen.pattern import pattern

_FEWEST = 3
"""Numbers of one entry that make a list of samples."""
_LIST = pattern(r"-?[\d.]+(?:, -?[\d.]+)+")
_SUM, _MEAN = pattern(r"sum", re.IGNORECASE), pattern(r"mean", re.IGNORECASE)
_READING = pattern(r"(?:reading|rounded)\b.*", re.IGNORECASE)
_WIDE = pattern(r".*u(?P<bits>16|32)\(\)")
_BITS = pattern(r".*\((?P<bits>\d{1,2}) bits\)")
_BRACKETS = pattern(r"\(([^()]*)\)$")
_BYTES = pattern(r"\b(?:frames?|payload|bytes|sizes?)\b", re.IGNORECASE)
_TOGETHER = pattern(r"\btogether\b", re.IGNORECASE)
_PER = pattern(
    r"per (?P<one>[a-z]+)(?: \((?P<count>\d{1,3}) (?P<many>[a-z]+)\)| \([^()]*\))?", re.IGNORECASE, needs="per"
)


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every row with a list of samples, a count of fewer bits or a share; a sum over the rows of the table before."""
    for table in examples.tables:
        wide, narrow = table.column(_WIDE), table.column(_BITS)
        shares = [(index, said) for index, head in enumerate(table.heads) if (said := _PER.fullmatch(head))]
        for index, said in shares:
            yield from _how_many(examples, table, index, said)
        for row in table.rows:
            yield from _samples(examples, table, row)
            if wide is not None and narrow is not None:
                yield from _narrowed(examples, table, row, wide, narrow)
            for index, said in shares:
                yield from _shared(examples, table, row, index, said)
    yield from _together(examples)


def _samples(examples: Examples, table: Table, row: Row) -> Iterator[Diagnostic]:
    listed = next((each for each in row.entries if _LIST.fullmatch(each.text)), None)
    if listed is None or len(listed.amounts) < _FEWEST:
        return
    total = sum((each.value for each in listed.amounts), Fraction(0))
    mean = total / len(listed.amounts)
    rounded = Fraction(floor(mean + Fraction(1, 2)))
    brackets = _BRACKETS.findall(table.heads[row.entries.index(listed)])
    for form, value, words in ((_SUM, total, "sum"), (_MEAN, mean, "mean"), (_READING, rounded, "rounded mean")):
        column = table.column(form)
        found = row.only(column)
        own = _BRACKETS.findall(table.heads[column]) if column is not None else []
        if found is not None and own in ([], brackets):
            yield from examples.judged(row.passage, found, [value], f"the {words} of {listed.text}")


def _narrowed(examples: Examples, table: Table, row: Row, wide: int, narrow: int) -> Iterator[Diagnostic]:
    """The upper bits of what `..._u16()` returns."""
    value, found = row.only(wide), row.only(narrow)
    if value is None or found is None or value.value.denominator != 1:
        return
    of, bits = _WIDE.fullmatch(table.heads[wide]), _BITS.fullmatch(table.heads[narrow])
    more = int(of["bits"]) - int(bits["bits"]) if of and bits else 0
    if more > 0:
        count = Fraction(int(value.value) >> more)
        yield from examples.judged(row.passage, found, [count], f"{table.heads[narrow]} of {value.written}")


def _shared(examples: Examples, table: Table, row: Row, index: int, said: "re.Match[str]") -> Iterator[Diagnostic]:
    """ "Per X (3 Xs)", or "Per X" beside a column "Xs": the amount in the same unit before it, divided."""
    found = table.amount(row, index)
    if found is None or found.is_plain:
        return
    heads = [each.casefold() for each in table.heads]
    many = f"{said['one'].casefold()}s"
    counted = row.only(heads.index(many)) if many in heads else None
    number = Fraction(said["count"]) if said["count"] else counted.value if counted else None
    before = [each for place in range(index) if (each := table.amount(row, place)) and each.like(found.unit)]
    whole = before[-1].in_unit(found.unit) if before else None
    if number and whole is not None:
        yield from examples.judged(row.passage, found, [whole / number], f"{before[-1].written} {table.heads[index]}")


def _how_many(examples: Examples, table: Table, index: int, said: "re.Match[str]") -> Iterator[Diagnostic]:
    """The number in a heading "Per X (3 Xs)", where the board says how many Xs there are."""
    parts = (part for system in examples.systems for each in system.components.values() for part in each.parts)
    known = {part.count(said["many"]) for part in parts} - {None} if said["many"] else set()
    for number in table.head.entries[index].amounts:
        expected = [Fraction(each) for each in sorted(known, key=str) if each is not None]
        yield from examples.judged(table.head.passage, number, expected, f"the number of {said['many']}")


def _together(examples: Examples) -> Iterator[Diagnostic]:
    """ "The three frames together | 196 bytes": the sum of the last column of the table before."""
    for statement in examples.statements:
        value, number = statement.value.alone, statement.table.number
        if value is None or not number or not _TOGETHER.search(statement.label.text):
            continue
        before = examples.tables[number - 1]
        last = len(before.heads) - 1
        column = [row.only(last) for row in before.rows]
        total = sum((each.value for each in column if each is not None), Fraction(0))
        is_bytes = value.like(unit_named("bytes")) and _BYTES.search(before.heads[last]) is not None
        if None not in column and total and is_bytes:
            yield from examples.judged(statement.passage, value, [total], f"the sum of {before.heads[last]}")
