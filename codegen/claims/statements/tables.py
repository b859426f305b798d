"""Rows of tables, read by the headings of their columns: what a column says without a word in its cells."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import groupby

from codegen.claims.parts.span import Span
from codegen.claims.rate import RULE as BANDWIDTH
from codegen.claims.rate import exact_sizes
from codegen.claims.reading import Reading
from codegen.claims.rules import CRC_EXTRA, EXTENSION, MESSAGE_ID, OFFSET, SENTINEL, SIZE, TYPE, as_sure
from codegen.claims.size import size_hint, sizes_of
from codegen.claims.statements.columns import field_sizes
from codegen.claims.statements.columns.rows import Row, field_of, row_of
from codegen.claims.statements.fields import number
from codegen.claims.statements.unknown import is_unknown
from codegen.claims.unknown_value import unknown_values
from codegen.diagnostics import Diagnostic, Rule
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2, SIGNATURE
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_IN_BYTES = pattern(r",? ?[(\[](?:in )?(?:b|bytes?)[)\]]$|,? in bytes$")
_ID = pattern(r"(?:message |msg )?(?:id|number|no\.?|#)")
_CRC = pattern(r"crc(?:[ _-]?extra)?(?: \(seed\))?|extra[ _]crc|crc seed|seed|extra")
_BASE = pattern(
    r"(?:base|min(?:imum)?)(?: (?:payload|length|size|len|bytes))?(?: \(bytes\))?"
    r"|(?:payload )?without ext(?:ensions?|\.)?|(?:v1|mavlink 1)(?: payload)?|payload,? base|length v1",
    needs="base|length|mavlink|min|v1|without",
)
_FULL = pattern(
    r"(?:max(?:imum)?|full|whole|with ext(?:ensions?|\.)?|extended|(?:v2|mavlink 2) payload|payload,? (?:extended"
    r"|full|max))(?: (?:payload|length|size|len|bytes))?(?: \(bytes\))?"
)
_SIZE = pattern(
    r"(?:payload|length|len|size|bytes|frames?|packets?|(?:bytes )?on (?:the )?wire|(?:v[12]|mavlink [12]|whole"
    r"|full) (?:frames?|packets?))"
    r"(?: (?:bytes|length|len|size))?(?:,? in bytes|,? \(?(?:bytes|b|v[12]|mavlink [12])\)?)?(?:,? v[12]"
    r"|,? mavlink [12])?",
    needs="bytes|frame|len|on|packet|payload|size",
)
_OFFSET = pattern(r"(?:byte )?offset(?: in (?:the )?payload)?|byte|at|pos(?:ition)?|starts at")
_UNKNOWN = pattern(
    r"(?:if |when )?(?:invalid|unknown|sentinel|no data|missing|n/a|not (?:known|available|used))(?: (?:value|is"
    r"|if))?|value if unknown"
)
_NOT_PAYLOAD = pattern(r"frame|packet|wire")
_NAMED = pattern(r"message|msg|\bids?\b|crc|payload|frame|extension|mavlink|v[12]\b")
"""A heading that says what its numbers are; "#" and "Size" may be of something else, unless half of them are right."""
_ENOUGH = 2


def check(reading: Reading, parts: Sequence[Span]) -> Iterator[Diagnostic]:
    """Every table of a document."""
    for is_row, run in groupby(parts, lambda span: span.kind is PassageKind.ROW):
        rows = [row_of(reading, span) for span in run] if is_row else []
        if len(rows) > 1:
            heads = [_IN_BYTES.sub("", head.lower()) or head.lower() for head in rows[0].span.heads]
            for column, head in enumerate(heads):
                yield from _messages(reading, rows[1:], column, head)
                yield from _fields(reading, rows[1:], column, head)
            yield from _bandwidths(reading, rows[1:], heads)


def _messages(reading: Reading, rows: Sequence[Row], column: int, head: str) -> Iterator[Diagnostic]:
    """A column of ids, CRC_EXTRA or sizes, one message in each row."""
    told = [
        (row, row.message, at) for row in rows if row.message is not None and (at := row.number(column)) is not None
    ]
    told = [(row, message, at) for row, message, at in told if message.id >= 0]
    is_of_fields = field_sizes.is_of_fields(reading, rows, column, head)
    if _ID.fullmatch(head) or _CRC.fullmatch(head):
        rule, what = (MESSAGE_ID, "id") if _ID.fullmatch(head) else (CRC_EXTRA, "CRC_EXTRA")
        facts = [
            (row, at, message.id if rule is MESSAGE_ID else message.crc_extra, message) for row, message, at in told
        ]
        right = sum(number(row.span.sentence.term(at)) == own for row, at, own, _ in facts)
        counted = [number(row.span.sentence.term(at)) for row, at, _, _ in facts]
        if right == 0 and len(facts) > 1 and counted in ([*range(len(facts))], [*range(1, len(facts) + 1)]):
            return  # the rows are numbered
        is_sure = 2 * right >= len(facts) or _NAMED.search(head) is not None
        for row, at, own, message in facts if not is_of_fields or is_sure else ():
            yield from _other(reading, row, at, own, as_sure(rule, is_sure=is_sure), message, what)
    elif not is_of_fields and (sizes := _sizes(head, told)):
        right = sum(number(row.span.sentence.term(at)) in sizes(message) for row, message, at in told)
        rule = as_sure(SIZE, is_sure=2 * right >= len(told) or _NAMED.search(head) is not None)
        for row, message, at in told:
            value, written = number(row.span.sentence.term(at)), row.span.sentence.term(at).written
            if value not in sizes(message):
                text = f"{message.name} {sizes_of(message)}, not {written}"
                yield reading.found(
                    rule, row.span.place(at), f"{message.name} {head} {written}", text, size_hint(message, reading)
                )


def _other(
    reading: Reading, row: Row, at: int, own: int, rule: Rule, message: WireMessage, what: str
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


def _sizes(head: str, told: Sequence[tuple[Row, WireMessage, int]]) -> _Sizes | None:
    """Return the sizes that a column may mean: by its heading, and where that leaves it open by most of its rows."""
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


def _bandwidths(reading: Reading, rows: Sequence[Row], heads: Sequence[str]) -> Iterator[Diagnostic]:
    """A column of bytes per second beside one of rates, one message in each row.

    Where no row shows the size that it was computed from, they may be measured: then most rows have to be right.
    """
    rate = next((column for column, head in enumerate(heads) if _RATE.fullmatch(head)), None)
    total = next((column for column, head in enumerate(heads) if _TOTAL.fullmatch(head)), None)
    if rate is None or total is None:
        return
    told = [each for row in rows if (each := _bandwidth(reading, row, rate, total)) is not None]
    wrong = [each for each in told if not each.is_right]
    is_computed = len(told) > _MOST * len(wrong)
    for each in wrong:
        if each.is_given or is_computed:
            message, at = each.message, each.at
            size = each.size if each.size > message.length else each.size + HEAD_V2
            hertz, written = float(each.hertz), each.row.span.sentence.term(at).written
            text = f"{message.name}: {size} bytes at {hertz:g} Hz are {size * hertz:g} bytes/s, not {written}"
            rule = as_sure(BANDWIDTH, is_sure=each.is_given)
            yield reading.found(rule, each.row.span.place(at), f"{message.name} {hertz:g} Hz {written}", text)


_MOST = 3
"""So many times as many rows as are wrong are there, where a column is computed and not measured."""


@dataclass(frozen=True, slots=True)
class _Bandwidth:
    """The bytes per second in a row: ``size`` is the largest that the row shows, or that of a frame."""

    row: Row
    message: WireMessage
    at: int
    hertz: Fraction
    size: int
    is_given: bool
    is_right: bool


def _bandwidth(reading: Reading, row: Row, rate: int, total: int) -> _Bandwidth | None:
    """The bytes per second of a row."""
    hertz, at, message = _hertz(row, rate), row.number(total), row.message
    value = number(row.span.sentence.term(at)) if at is not None else None
    if message is None or not hertz or at is None or value is None or message.id < 0:
        return None
    own = exact_sizes(message)
    shown = [row.number(column) for column in range(len(row.cells)) if column not in (rate, total)]
    given = {int(each) for place in shown if place is not None for each in [number(row.span.sentence.term(place)) or 0]}
    given &= own
    sizes = {each + more for each in given for more in (0, HEAD_V1, HEAD_V2, HEAD_V2 + SIGNATURE)} & own or own
    sent = reading.reference.sent.get(message.name)
    is_sent = sent is not None and sent.low * hertz <= value <= sent.high * hertz
    is_right = is_sent or any(abs(size * hertz - Fraction(value)) < 1 for size in sizes)
    size = max(given) if given else HEAD_V2 + message.base_length
    return _Bandwidth(row, message, at, hertz, size, bool(given), is_right)


def _hertz(row: Row, column: int) -> Fraction | None:
    """The rate of a cell, ``4`` or ``4 Hz``."""
    at = row.number(column)
    if at is None and column < len(row.cells):
        found = re.compile(r"\s*(?P<rate>Q)\s*").fullmatch(row.span.text, *row.cells[column])
        amount = row.span.sentence.term(found.start("rate")).value if found is not None else None
        if isinstance(amount, tuple) and isinstance(amount[1], Unit) and amount[1].name == "Hz":
            return Fraction(amount[0])
    value = number(row.span.sentence.term(at)) if at is not None else None
    return None if value is None or isinstance(value, float) else Fraction(value)


_RATE = pattern(
    r"(?:update |send |stream )?(?:rate|hz|freq(?:uency)?\.?|per second|times/s|messages/s)(?: ?[(\[,]? ?hz[)\]]?)?",
    needs="freq|hz|messages|rate|second|times",
)
_TOTAL = pattern(
    r"(?:bandwidth|load|total|throughput|traffic|data rate|cost)?(?: in)? ?[(\[,]?(?:b|bytes?)(?:/| per | a )(?:s"
    r"|sec|second)\.?[)\]]?",
    needs="/s|a s|per s",
)


def _fields(reading: Reading, rows: Sequence[Row], column: int, head: str) -> Iterator[Diagnostic]:
    """A column of offsets, or of values for unknown, one field in each row."""
    if _LENGTH.fullmatch(head):
        yield from _lengths(reading, rows, column)
    yield from field_sizes.check(reading, rows, column, head, is_length=_LENGTH.fullmatch(head) is not None)
    if _EXTENSION.fullmatch(head):
        yield from _extensions(reading, rows, column)
    is_offset, is_sentinel = _OFFSET.fullmatch(head) is not None, _UNKNOWN.fullmatch(head) is not None
    is_place = is_offset and ("offset" in head or _is_borne_out(reading, rows, column))
    for row in rows if is_offset or is_sentinel else ():
        one = field_of(reading, row)
        if one is None or column >= len(row.cells):
            continue
        low, high = row.cells[column]
        found = re.compile(r"\s*(?P<value>[NS])(?: \([^)]*\))?\s*").fullmatch(row.span.text, low, high)
        value = number(row.span.sentence.term(found.start("value"))) if found is not None else None
        if found is None or value is None:
            continue
        written, place = row.span.sentence.term(found.start("value")).written, row.span.place(found.start("value"))
        if is_offset and is_place and one.is_wrong(partial(_begins_at, offset=value)):
            text = f"{one.name} begins at byte {one.field.offset}, not {written}"
            yield reading.found(OFFSET, place, f"{one.name} at {written}", text)
        known = unknown_values(one.field)
        if is_sentinel and known is not None and one.is_wrong(partial(is_unknown, value=float(value))):
            text = f"{one.name} is unknown when it is {known[1]}, not {written}"
            yield reading.found(SENTINEL, place, f"{one.name} {written}", text)


def _is_borne_out(reading: Reading, rows: Sequence[Row], column: int) -> bool:
    """Return whether half of the numbers of a column, "Position" or "At", are places on the wire."""
    places = [
        (one, row, at) for row in rows if (one := field_of(reading, row)) and (at := row.number(column)) is not None
    ]
    right = sum(number(row.span.sentence.term(at)) == one.field.offset for one, row, at in places)
    return 2 * right >= len(places) > 0


_LENGTH = pattern(r"(?:array )?(?:length|elements|entries|count|size of (?:the )?array|array size|dimension)")


def _lengths(reading: Reading, rows: Sequence[Row], column: int) -> Iterator[Diagnostic]:
    """A column with the number of elements of each array; bytes will do."""
    for row in rows:
        one, at = field_of(reading, row), row.number(column)
        value = number(row.span.sentence.term(at)) if at is not None else None
        if one is None or at is None or value is None or not one.field.is_array:
            continue
        if one.is_wrong(partial(_holds, value=value)):
            written = row.span.sentence.term(at).written
            text = f"{one.name} has {one.field.count} elements, not {written}"
            yield reading.found(TYPE, row.span.place(at), f"{one.name} {written} elements", text)


def _holds(field: WireField, value: float | Fraction) -> bool:
    return value in (field.count, field.size)


_EXTENSION = pattern(r"(?:is )?(?:an )?(?:extension|ext\.?)(?: field)?\??|v2 only|mavlink 2 only")
_YES_OR_NO = pattern(r"\s*(?:(?P<yes>yes|y|x|true|\u2713|\u2714|extension|ext)|(?P<no>no|n|false|base|-))\s*")


def _extensions(reading: Reading, rows: Sequence[Row], column: int) -> Iterator[Diagnostic]:
    """A column that says of each field whether it is an extension."""
    for row in rows:
        one = field_of(reading, row)
        said = _YES_OR_NO.fullmatch(row.span.text, *row.cells[column]) if column < len(row.cells) else None
        if one is None or said is None:
            continue
        is_extension = said["yes"] is not None
        if one.is_wrong(partial(_is_of_kind, is_extension=is_extension)):
            kind = "an extension" if one.field.definition.is_extension else "a base field"
            place = row.span.place(row.cells[column][0] + 1)
            yield reading.found(EXTENSION, place, f"{one.name} {is_extension}", f"{one.name} is {kind}")


def _is_of_kind(field: WireField, *, is_extension: bool) -> bool:
    return field.definition.is_extension is is_extension


def _begins_at(field: WireField, offset: float | Fraction) -> bool:
    return field.offset == offset
