"""Tables of the sizes of messages, and what their rows establish for the statements below them."""

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.claims.own.worked.amount import Amount
from codegen.claims.own.worked.examples import Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2
from codegen.pattern import pattern

_NAME = pattern(r"(?P<name>[A-Z][A-Z0-9_]{2,60})(?=$|,| \()")
_CHARACTERS = pattern(r"\b(?P<count>\d{1,3}) characters\b")
_V1 = pattern(r"\bv1\b|\bMAVLink 1\b", re.IGNORECASE)
_COLUMNS = {
    "id": pattern(r"(?:message )?(?:id|number)", re.IGNORECASE),
    "base": pattern(r"payload,? \(?base\)?|base payload", re.IGNORECASE),
    "full": pattern(r"payload,? \(?(?:extended|with extensions)\)?|extended payload", re.IGNORECASE),
    "sent": pattern(r"payload sent(?: \(v2\))?|payload,? sent", re.IGNORECASE),
    "v2": pattern(r"frame(?: \(v2\)|,? v2|,? MAVLink 2)", re.IGNORECASE),
    "v1": pattern(r"frame(?: \(v1\)|,? v1|,? MAVLink 1)", re.IGNORECASE),
}


@dataclass(frozen=True, slots=True)
class Frame:
    """The bytes of a frame that a row of a table states, by version of MAVLink; None where it does not."""

    v1: Fraction | None
    v2: Fraction | None


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every row that begins with a message, below headings for ids, payloads and frames."""
    for table in examples.tables:
        columns = columns_of(table)
        for row in table.rows if columns else ():
            message = message_of(examples, row)
            if message is not None:
                yield from _row(examples, table, row, columns, message)


def columns_of(table: Table) -> Mapping[str, int]:
    """The columns of sizes, by what they have; none in a table that has no column of a size."""
    found = {key: table.column(form) for key, form in _COLUMNS.items()}
    columns = {key: index for key, index in found.items() if index is not None}
    return columns if columns.keys() - {"id"} else {}


def message_of(examples: Examples, row: Row) -> WireMessage | None:
    """The message that a row begins with."""
    named = _NAME.match(row.entries[0].text)
    return examples.reading.messages.get(named["name"]) if named else None


def stated_frames(examples: Examples) -> Mapping[str, tuple[Frame, ...]]:
    """Return the sizes of frames that the tables of a document state, by the names of the messages."""
    found: dict[str, tuple[Frame, ...]] = {}
    for table in examples.tables:
        columns = columns_of(table)
        for row in table.rows if columns else ():
            message = message_of(examples, row)
            if message is not None:
                v1, v2 = (row.only(columns.get(key)) for key in ("v1", "v2"))
                frame = Frame(v1.value if v1 else None, v2.value if v2 else None)
                found[message.name] = (*found.get(message.name, ()), frame)
    return found


def text_start(message: WireMessage) -> int | None:
    """Return the offset of the only text of a message in its payload; None where it has none, or several."""
    texts = [field for field in message.fields if field.type.name == "char" and field.is_array]
    return texts[0].offset if len(texts) == 1 else None


def possible_frames(examples: Examples, message: WireMessage) -> tuple[Fraction, ...]:
    """The bytes of a frame of MAVLink 2: those of whole ones, and fewer unless the last field is never zero."""
    last = message.fields[-1].definition
    enum = examples.reading.enums.get(last.enum or "")
    whole = {HEAD_V2 + message.base_length, HEAD_V2 + message.length}
    if enum is None or last.is_bitmask or any(entry.value == 0 for entry in enum.entries):
        whole |= set(range(HEAD_V2 + 1, HEAD_V2 + message.length))
    return tuple(Fraction(each) for each in sorted(whole))


def is_v1(text: str) -> bool:
    """Return whether a text is about MAVLink 1."""
    return _V1.search(text) is not None


def _row(
    examples: Examples, table: Table, row: Row, columns: Mapping[str, int], message: WireMessage
) -> Iterator[Diagnostic]:
    base, full = message.base_length, message.length
    sent = row.only(columns.get("sent"))
    expected: dict[str, list[int]] = {
        "id": [message.id],
        "base": [base],
        "full": [full],
        "v1": [HEAD_V1 + base],
    }
    characters = _CHARACTERS.search(row.entries[0].text)
    start = text_start(message)
    if characters is not None and start is not None:
        expected["sent"] = [start + int(characters["count"])]
    elif sent is not None and not 1 <= sent.value <= full:
        expected["sent"] = [full]
    if sent is not None:
        expected["v2"] = [HEAD_V2 + int(sent.value)]
    else:
        expected["v2"] = [int(each) for each in possible_frames(examples, message)]
    for key, numbers in expected.items():
        found: Amount | None = row.only(columns.get(key))
        if found is not None and message.id >= 0:
            head = table.heads[columns[key]]
            yield from examples.judged(
                row.passage, found, [Fraction(each) for each in numbers], f"{message.name}, {head}"
            )
