"""Rows about a curve of the board: its points on both sides of an amount, and the value between them."""

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from codegen.claims.own.worked.amount import Amount, amounts
from codegen.claims.own.worked.examples import Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.model.spec.board import CurveSpec
from codegen.model.units.unit import read_measure
from codegen.pattern import pattern

_POINTS = pattern(r"[\d.]+: [\d.]+(?: and [\d.]+: [\d.]+)?")
_BEYOND = pattern(r"(?P<side>above|below) (?=\d)")
_PER = pattern(r"per [a-z]+\b.*", re.IGNORECASE)

Points = Sequence[tuple[Fraction, Fraction]]


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every row that names what chooses a curve and has an amount "per" something, with points behind it."""
    curves = [curve for system in examples.systems for curve in system.spec.board.curves.values() if curve.by]
    for table in examples.tables if curves else ():
        column = table.column(_PER)
        for row in table.rows if column is not None else ():
            amount = table.amount(row, column)
            points = _points(curves, row, amount) if amount is not None else ()
            if amount is not None and points:
                yield from _row(examples, table, row, amount, points)


def _points(curves: Sequence[CurveSpec], row: Row, amount: Amount) -> Points:
    """The points of the curve that a row names, by amounts in the unit of the row's."""
    named = {entry.text for entry in row.entries}
    chosen: Mapping[str, Fraction] = next(
        (points for curve in curves for name, points in curve.by.items() if name in named), {}
    )
    found = []
    for written, value in chosen.items():
        measure = read_measure(written)
        at = measure.in_unit(amount.unit) if measure is not None else None
        if at is not None:
            found.append((at, value))
    return sorted(found)


def _row(examples: Examples, table: Table, row: Row, amount: Amount, points: Points) -> Iterator[Diagnostic]:
    low = max((each for each in points if each[0] <= amount.value), default=None)
    high = min((each for each in points if each[0] >= amount.value), default=None)
    near = [each for each in dict.fromkeys((low, high)) if each is not None]
    place = next((index for index, entry in enumerate(row.entries) if _POINTS.fullmatch(entry.text)), None)
    beyond = next((index for index, entry in enumerate(row.entries) if _BEYOND.match(entry.text)), None)
    last = row.only(len(table.heads) - 1)
    words = f"the point beside {amount.written}"
    if place is not None and low is not None and high is not None:
        said = [each for pair in near for each in pair]
        stated = amounts(
            row.passage.text, row.entries[place].start, row.entries[place].start + len(row.entries[place].text)
        )
        for number, expected in zip(stated, said, strict=False) if len(stated) == len(said) else ():
            yield from examples.judged(row.passage, number, [expected], words)
    elif beyond is not None and row.entries[beyond].amounts:
        end = points[-1] if row.entries[beyond].text.startswith("above") else points[0]
        yield from examples.judged(row.passage, row.entries[beyond].amounts[0], [end[0]], "the end of the curve")
    if last is not None and (place is not None or beyond is not None):
        yield from examples.judged(row.passage, last, [_between(amount.value, near)], f"the value at {amount.written}")


def _between(at: Fraction, near: Sequence[tuple[Fraction, Fraction]]) -> Fraction:
    """The value on the line between two points, or that of the one."""
    if len(near) == 1:
        return near[0][1]
    (low, first), (high, last) = near
    return first + (last - first) * (at - low) / (high - low)
