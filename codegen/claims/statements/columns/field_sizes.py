"""Columns of sizes in tables whose rows name fields: the sizes are those of the fields, not of their messages."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial

from codegen.claims.reading import Reading
from codegen.claims.rules import TYPE, as_sure
from codegen.claims.statements.columns.rows import Row, field_of
from codegen.claims.statements.fields import number
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField
from codegen.pattern import pattern

_OF_MESSAGE = pattern(r"payload|frame|packet|message|msg|\bon (?:the )?wire\b|extension")
_SIZE = pattern(
    r"(?:field |data )?(?:size|bytes|octets|width|length|len\.?|bits|nbytes)"
    r"(?: ?\(?(?:in )?(?:bytes|octets|bits)\)?)?(?: ?\[[^\]]*\])?",
    needs="bits|bytes|len|octets|size|width",
)
_BITS = 8
_HALF = 2


def is_of_fields(reading: Reading, rows: Sequence[Row], column: int, head: str) -> bool:
    """Return whether a column of numbers is about the fields that another column of the table names.

    A heading with "payload" or "frame" is about the message, and so is a column before that of the fields, unless it
    has several numbers for one message.
    """
    named = [row for row in rows if (one := field_of(reading, row)) and row.message in (one.message, None)]
    places = [place for row in named if (place := row.field_column) is not None]
    if _HALF * len(places) < len(rows) or not places:
        return False
    if _OF_MESSAGE.search(head):
        return _is_mostly_of_fields(reading, named, column)
    if column > min(places):
        return True
    numbers: dict[str, set[int | float | Fraction | None]] = {}
    for row in rows:
        at = row.number(column)
        if row.message is not None and at is not None:
            numbers.setdefault(row.message.name, set()).add(number(row.span.sentence.term(at)))
    return any(len(each) > 1 for each in numbers.values())


def _is_mostly_of_fields(reading: Reading, rows: Sequence[Row], column: int) -> bool:
    """Return whether more than half of the numbers of a column are the sizes of the fields of their rows."""
    found = []
    for row in rows:
        one, at = field_of(reading, row), row.number(column)
        value = number(row.span.sentence.term(at)) if at is not None else None
        if one is not None and value is not None:
            found.append(value == one.field.size and value != one.message.length)
    return _HALF * sum(found) > len(found)


def check(reading: Reading, rows: Sequence[Row], column: int, head: str, *, is_length: bool) -> Iterator[Diagnostic]:
    """Find the sizes of fields that differ; ``is_length`` leaves arrays to what reads their elements."""
    if not _SIZE.fullmatch(head) or not is_of_fields(reading, rows, column, head):
        return
    for row in rows:
        one, at = field_of(reading, row), row.number(column)
        value = number(row.span.sentence.term(at)) if at is not None else None
        if one is None or at is None or value is None or (is_length and one.field.is_array):
            continue
        if one.is_wrong(partial(_is_size, value=value)):
            written = row.span.sentence.term(at).written
            text = f"{one.name} has {one.field.size} bytes, not {written}"
            rule = as_sure(TYPE, is_sure=False)
            yield reading.found(rule, row.span.place(at), f"{one.name} {written} bytes", text)


def _is_size(field: WireField, value: float | Fraction) -> bool:
    """Return whether a number is the size of a field or of its elements, in bytes or bits, or how many they are."""
    bytes_of = (field.size, field.type.size)
    return value in (*bytes_of, *(_BITS * each for each in bytes_of), field.count)
