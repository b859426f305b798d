"""Rows of tables, read by the headings of their columns: what a column says without a word in its cells."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import groupby

from codegen.claims.reading import Reading
from codegen.claims.rules import CRC_EXTRA, MESSAGE_ID, OFFSET, SENTINEL, SIZE
from codegen.claims.size import SIGNATURE, size_hint, sizes_of
from codegen.claims.statements.fields import number
from codegen.claims.statements.spans import About, Span, about
from codegen.claims.statements.unknown import is_unknown
from codegen.claims.unknown_value import unknown_values
from codegen.diagnostics import Diagnostic, Rule
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2

_ID = re.compile(r"(?:message |msg )?(?:id|number|no\.?|#)")
_CRC = re.compile(r"crc(?:[ _-]?extra)?(?: \(seed\))?|extra[ _]crc|crc seed|seed|extra")
_BASE = re.compile(
    r"(?:base|min(?:imum)?)(?: (?:payload|length|size|len|bytes))?(?: \(bytes\))?"
    r"|(?:payload )?without ext(?:ensions?|\.)?|(?:v1|mavlink 1)(?: payload)?|payload,? base|length v1"
)
_FULL = re.compile(
    r"(?:max(?:imum)?|full|whole|with ext(?:ensions?|\.)?|extended|(?:v2|mavlink 2) payload|payload,? (?:extended"
    r"|full|max))(?: (?:payload|length|size|len|bytes))?(?: \(bytes\))?"
)
_SIZE = re.compile(
    r"(?:payload|length|len|size|bytes|frames?|packets?|(?:bytes )?on (?:the )?wire|(?:v[12]|mavlink [12]|whole"
    r"|full) (?:frames?|packets?))"
    r"(?: (?:bytes|length|len|size))?(?:,? in bytes|,? \(?(?:bytes|b|v[12]|mavlink [12])\)?)?(?:,? v[12]"
    r"|,? mavlink [12])?"
)
_OFFSET = re.compile(r"(?:byte )?offset(?: in (?:the )?payload)?|byte|at|pos(?:ition)?|starts at")
_UNKNOWN = re.compile(
    r"(?:if |when )?(?:invalid|unknown|sentinel|no data|missing|n/a|not (?:known|available|used))(?: (?:value|is"
    r"|if))?|value if unknown"
)
_NOT_PAYLOAD = re.compile(r"frame|packet|wire")
_ENOUGH = 2


@dataclass(frozen=True, slots=True)
class _Row:
    """A row, its cells as bounds in the short text, and the message that it is about, if it names one."""

    span: Span
    cells: tuple[tuple[int, int], ...]
    message: WireMessage | None

    def number(self, column: int) -> int | None:
        """The offset of the number that is all of a cell, or of ``N bytes``."""
        if column >= len(self.cells):
            return None
        low, high = self.cells[column]
        found = _NUMBER.fullmatch(self.span.text, low, high)
        return None if found is None else found.start("number")


_NUMBER = re.compile(r"\s*#?(?P<number>N)(?: ?bytes?| b)?\s*")
_MESSAGE = re.compile(r"\s*(?P<message>M)(?: \([^)]*\))?\s*")


def check(reading: Reading, parts: Sequence[Span]) -> Iterator[Diagnostic]:
    """Every table of a document."""
    for is_row, run in groupby(parts, lambda span: span.kind is PassageKind.ROW):
        rows = [_row(reading, span) for span in run] if is_row else []
        if len(rows) > 1:
            heads = [head.lower() for head in rows[0].span.heads]
            for column, head in enumerate(heads):
                yield from _messages(reading, rows[1:], column, head)
                yield from _fields(reading, rows[1:], column, head)


def _row(reading: Reading, span: Span) -> _Row:
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
    return _Row(span, tuple(cells), message)


def _messages(reading: Reading, rows: Sequence[_Row], column: int, head: str) -> Iterator[Diagnostic]:
    """A column of ids, CRC_EXTRA or sizes, one message in each row."""
    told = [
        (row, row.message, at) for row in rows if row.message is not None and (at := row.number(column)) is not None
    ]
    told = [(row, message, at) for row, message, at in told if message.id >= 0]
    if _ID.fullmatch(head):
        for row, message, at in told:
            yield from _other(reading, row, at, message.id, MESSAGE_ID, message, "id")
    elif _CRC.fullmatch(head):
        for row, message, at in told:
            yield from _other(reading, row, at, message.crc_extra, CRC_EXTRA, message, "CRC_EXTRA")
    elif sizes := _sizes(head, told):
        for row, message, at in told:
            value, written = number(row.span.sentence.term(at)), row.span.sentence.term(at).written
            if value not in sizes(message):
                text = f"{message.name} {sizes_of(message)}, not {written}"
                yield reading.found(
                    SIZE, row.span.place(at), f"{message.name} {head} {written}", text, size_hint(message, reading)
                )


def _other(
    reading: Reading, row: _Row, at: int, own: int, rule: Rule, message: WireMessage, what: str
) -> Iterator[Diagnostic]:
    term = row.span.sentence.term(at)
    if number(term) != own:
        text = f"{message.name} has the {what} {own}, not {term.written}"
        yield reading.found(rule, row.span.place(at), f"{message.name} {what} {term.written}", text)


_Sizes = Callable[[WireMessage], set[int]]
_MEANINGS: Mapping[str, _Sizes] = {
    "payload": lambda message: {message.base_length, message.length},
    "v2": lambda message: {HEAD_V2 + message.base_length, HEAD_V2 + message.length},
    "v1": lambda message: {HEAD_V1 + message.base_length},
    "signed": lambda message: {HEAD_V2 + SIGNATURE + message.base_length, HEAD_V2 + SIGNATURE + message.length},
}


def _sizes(head: str, told: Sequence[tuple[_Row, WireMessage, int]]) -> _Sizes | None:
    """What a column of sizes means: by its heading, and where that leaves it open by most of its rows."""
    if _BASE.fullmatch(head):
        return lambda message: {message.base_length}
    if _FULL.fullmatch(head):
        return lambda message: {message.length}
    if not _SIZE.fullmatch(head):
        return None
    meanings = {key: sizes for key, sizes in _MEANINGS.items() if not (key == "payload" and _NOT_PAYLOAD.search(head))}
    if "payload" in head:
        return meanings["payload"]
    right = {
        key: sum(number(row.span.sentence.term(at)) in sizes(message) for row, message, at in told)
        for key, sizes in meanings.items()
    }
    best = max(right, key=lambda key: right[key])
    if right[best] >= _ENOUGH and 2 * right[best] > len(told):
        return meanings[best]
    return lambda message: set().union(*(sizes(message) for sizes in meanings.values()))


def _fields(reading: Reading, rows: Sequence[_Row], column: int, head: str) -> Iterator[Diagnostic]:
    """A column of offsets, or of values for unknown, one field in each row."""
    is_offset, is_sentinel = _OFFSET.fullmatch(head) is not None, _UNKNOWN.fullmatch(head) is not None
    for row in rows if is_offset or is_sentinel else ():
        one = _field(reading, row)
        if one is None or column >= len(row.cells):
            continue
        low, high = row.cells[column]
        found = re.compile(r"\s*(?P<value>[NS])(?: \([^)]*\))?\s*").fullmatch(row.span.text, low, high)
        value = number(row.span.sentence.term(found.start("value"))) if found is not None else None
        if found is None or value is None:
            continue
        written, place = row.span.sentence.term(found.start("value")).written, row.span.place(found.start("value"))
        if is_offset and one.is_wrong(partial(_begins_at, offset=value)):
            text = f"{one.name} begins at byte {one.field.offset}, not {written}"
            yield reading.found(OFFSET, place, f"{one.name} at {written}", text)
        known = unknown_values(one.field)
        if is_sentinel and known is not None and one.is_wrong(partial(is_unknown, value=float(value))):
            text = f"{one.name} is unknown when it is {known[1]}, not {written}"
            yield reading.found(SENTINEL, place, f"{one.name} {written}", text)


def _begins_at(field: WireField, offset: float | Fraction) -> bool:
    return field.offset == offset


def _field(reading: Reading, row: _Row) -> About | None:
    """The field of a row: the first cell that is one name of a field."""
    for low, high in row.cells:
        found = re.compile(r"\s*(?P<name>[FP])\s*").fullmatch(row.span.text, low, high)
        if found is not None:
            return about(reading, row.span, found.start("name"))
    return None
