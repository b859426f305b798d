"""Columns and mappings that others of their kind bear out: numbers beside names whose meaning no word tells."""

import re
from itertools import groupby

from codegen.claims.enum_names import entry_values
from codegen.claims.parts.span import Span, head_of
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.statements.fields import number
from codegen.load.prose import PassageKind
from codegen.once import once
from codegen.pattern import pattern

_CLEAR = pattern(
    r"(?:.*\b(?:value|code|enum|mask|dec(?:imal)?|hex|entry|constant|result|flag|command|bit)\b.*)", re.IGNORECASE
)
"""A heading that says that numbers are those of entries; "#" and "No." may count the rows."""
_KEY = pattern(r"V[\"' ]*(?::|=>|->) ?N|N[\"' ]*(?::|=>|->) ?V")
"""An entry of a mapping, of which the numbers may be anything."""
_COUNTED = pattern(
    r" (?!(?:in|for|and|or|but|if|when|while|as|with|is|are|not|to|at|on|by|of|from|per|means|says|which|that|so|then"
    r"|since|because|here|there|according|instead|bytes?)\b)[a-z]{3,}"
)
"""Behind a number that counts something: "3 vehicles"."""
_OWN = pattern(r" (?:in|on|of) (?:our|my|their|its|this|that)\b")
_HALF = 2


def is_column_of_entries(reading: Reading, span: Span, at: int) -> bool:
    """Return whether a column is one of the numbers of entries: its heading says so, or half of its rows are right."""
    head = head_of(span, at)
    if _CLEAR.fullmatch(head.strip("*_` ")):
        return True
    column = span.text.count("|", 0, at)
    found = []
    for row in _run(reading, span):
        numbers = [place for place, _ in row.sentence.within(0, len(row.text), "N")]
        found += _pair(reading, row, [place for place in numbers if row.text.count("|", 0, place) == column])
    return _is_mostly_right(found)


def is_mapping_of_entries(reading: Reading, span: Span) -> bool:
    """Return whether a line of code is no entry of a mapping, or of one of which half of the entries are right."""
    if not span.is_code or span.is_comment or not _KEY.search(span.text):
        return True
    found = []
    for line in _run(reading, span):
        if _KEY.search(line.text):
            found += _pair(reading, line, [place for place, _ in line.sentence.within(0, len(line.text), "N")])
    return _is_mostly_right(found)


def is_amount_of_entries(reading: Reading, span: Span, at: int, name: int) -> bool:
    """Return whether a number only stands before a name, "3 NAME", in no list of which half of the items are right."""
    if span.is_code or span.text[at + 1 : name] != " ":
        return False
    found = []
    for part in _run(reading, span):
        numbers = [place for place, _ in part.sentence.within(0, len(part.text), "N")]
        found += _pair(reading, part, numbers)
    return not _is_mostly_right(found)


def is_counted(span: Span, at: int) -> bool:
    """Return whether a number counts something, or is one in somebody's own list: "3 vehicles", "3 in our list"."""
    if span.is_code or span.kind is PassageKind.ROW:
        return False
    return _COUNTED.match(span.text, at + 1) is not None or _OWN.match(span.text, at + 1) is not None


def _pair(reading: Reading, part: Span, places: list[int]) -> list[bool]:
    """Return whether the only number of some places is that of the only entry of a part; nothing without both."""
    names = {term.written for _, term in part.sentence.within(0, len(part.text), "V")}
    if len(names) != 1 or len(places) != 1:
        return []
    own = entry_values(reading.enums).get(names.pop())
    return [] if own is None else [number(part.sentence.term(places[0])) == own]


def _is_mostly_right(found: list[bool]) -> bool:
    return any(found) and _HALF * sum(found) >= len(found)


def _run(reading: Reading, span: Span) -> tuple[Span, ...]:
    return _runs(reading).get(id(span), (span,))


@once
def _runs(reading: Reading) -> dict[int, tuple[Span, ...]]:
    """Return by the identity of each row, item and line of code those that follow each other without a break."""
    found: dict[int, tuple[Span, ...]] = {}
    for _, run in groupby(spans(reading), lambda span: (span.kind, span.is_code)):
        parts = tuple(run)
        found.update(dict.fromkeys(map(id, parts), parts))
    return found
