"""Tables about messages, fields and entries, read by the headings of their columns."""

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from codegen.claims.about import Surroundings, surroundings
from codegen.claims.enum_words import entry_claim
from codegen.claims.field_notes import cells
from codegen.claims.field_values import ENTRY
from codegen.claims.identifier import CRC_EXTRA, ENTRY_VALUE, MESSAGE_ID
from codegen.claims.layout import typed
from codegen.claims.reading import Reading
from codegen.claims.sentinel import SENTINEL
from codegen.claims.size import RULE as SIZE
from codegen.claims.structure import COLUMN_TYPE, TYPE_CELL, has_type, spelled_type
from codegen.claims.structure import RULE as TYPE
from codegen.claims.unit_claim import unit_claim
from codegen.claims.unknown_value import number_of, unknown_values
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import Passage, PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.dialect.literals import same_number
from codegen.model.price import HEAD_V1, HEAD_V2

OFFSET = Rule(
    "claim-offset",
    "A document gives a field another place in the payload than it has on the wire: the largest types come first, and "
    "extensions behind all others. Correct it.",
)
ENUM_OF = Rule(
    "claim-enum-of-field",
    "A document says that a field has another enum than the dialect gives it, in which its numbers mean something "
    "else. Correct it.",
)

_SIGNATURE = 13
_NAME = re.compile(r"(?P<message>[A-Z][A-Z0-9_]{2,60})(?: \((?P<note>[^)]*)\))?")
_FIELD = re.compile(
    r"(?:(?P<message>[A-Z][A-Z0-9_]{2,60})\.)?(?P<field>[a-z]\w{0,60})(?:\[\d{0,3}\])?"
    r"(?: ?[(\[](?P<unit>[^()\[\]]{1,18})[)\]])?"
)
_SAID_UNIT = re.compile(
    r"(?:.*\bin |.*\(|(?:u?int\d+(?:_t)?|float|double),? )(?P<unit>[A-Za-z%][A-Za-z0-9/%^*]{0,18})\)?\.?"
)
_ENTRY = re.compile(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+){1,}")
_WHOLE = re.compile(r"#?(\d{1,5})(?: bytes?| B)?")
_HEADS = {
    "id": re.compile(r"(?:message |msg )?(?:id|number|no\.?|#)", re.IGNORECASE),
    "crc": re.compile(r"crc(?:[ _-]?extra)?(?: \(seed\))?|extra crc|crc seed|seed", re.IGNORECASE),
    "base": re.compile(
        r"(?:base|min(?:imum)?)(?: (?:payload|length|size|len))?(?: \(bytes\))?|without extensions?"
        r"|(?:v1|mavlink 1)(?: payload)?",
        re.IGNORECASE,
    ),
    "full": re.compile(
        r"(?:max(?:imum)?|full|whole|with extensions?|extended|(?:v2|mavlink 2) payload)"
        r"(?: (?:payload|length|size|len))?(?: \(bytes\))?",
        re.IGNORECASE,
    ),
    "payload": re.compile(
        r"(?:payload|length|len|size|bytes)(?: (?:bytes|length|len|size))?(?:,? in bytes| \((?:bytes|B)\)|, bytes)?",
        re.IGNORECASE,
    ),
    "frame": re.compile(
        r"(?:(?:v[12]|mavlink [12]|whole|full) )?(?:frames?|packets?|(?:bytes )?on (?:the )?wire)"
        r"(?: (?:length|size|bytes))?"
        r"(?:,? in bytes| \((?:bytes|B|v[12])\)|, bytes|,? v[12]|,? mavlink [12])?",
        re.IGNORECASE,
    ),
    "field": re.compile(r"fields?|field name|name|member|key", re.IGNORECASE),
    "unit": re.compile(r"units?", re.IGNORECASE),
    "unknown": re.compile(
        r"(?:if |when )?(?:invalid|unknown|sentinel|no data|not (?:known|available|used))(?: value)?|unknown is",
        re.IGNORECASE,
    ),
    "offset": re.compile(r"(?:byte )?offset|(?:byte|at|pos(?:ition)?)", re.IGNORECASE),
    "type": COLUMN_TYPE,
    "enum": re.compile(r"enum", re.IGNORECASE),
    "value": re.compile(r"(?:value|number|num|code|id|#|no\.?|bit value)", re.IGNORECASE),
}


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every row of every table."""
    parts = list(surroundings(reading))
    for is_row, run in groupby(parts, lambda each: isinstance(each[0], Passage) and each[0].kind is PassageKind.ROW):
        rows = [(part, around) for part, around in run if isinstance(part, Passage)]
        if is_row and len(rows) > 1:
            yield from _table(reading, [part for part, _ in rows], rows[0][1])


def _table(reading: Reading, rows: Sequence[Passage], around: Surroundings) -> Iterator[Diagnostic]:
    heads = [cell.strip() for cell, _ in cells(rows[0])]
    columns = {key: [index for index, head in enumerate(heads) if form.fullmatch(head)] for key, form in _HEADS.items()}
    for row in rows[1:]:
        own = cells(row)
        if len(own) < 2:
            continue
        message = _named(reading, own)
        if message is not None:
            part = next((message.field(own[index][0].strip()) for index in columns["field"] if index < len(own)), None)
            if part is not None:
                yield from _of_field(reading, row, own, columns, message, part)
            else:
                yield from _message(reading, row, own, columns, message)
            continue
        if columns["value"]:
            yield from _entry(reading, row, own, columns["value"][0])
        place = next((index for index in (columns["field"] or [0])[:1] if index < len(own)), 0)
        found = _FIELD.fullmatch(own[place][0].strip())
        about = _field(reading, around, found["message"], found["field"]) if found else None
        if about is not None:
            yield from _of_field(reading, row, own, columns, *about)


def _named(reading: Reading, own: Sequence[tuple[str, int]]) -> WireMessage | None:
    """The message that a row is about: that of its first cell, or the only one that a cell names."""
    named = [found["message"] for text, _ in own if (found := _NAME.fullmatch(text.strip())) is not None]
    known = [reading.messages[name] for name in named if name in reading.messages]
    first = _NAME.fullmatch(own[0][0].strip())
    if first is not None and first["message"] in reading.messages:
        return reading.messages[first["message"]]
    return known[0] if len(known) == 1 else None


def _field(
    reading: Reading, around: Surroundings, message: str | None, name: str
) -> tuple[WireMessage, WireField] | None:
    if message is not None:
        candidates = [reading.messages[message]] if message in reading.messages else []
    else:
        candidates = [*around.headings[:1], *around.earlier[:1]][:1] if around.headings else list(around.earlier[:1])
    for candidate in candidates:
        field = candidate.field(name)
        if field is not None:
            return candidate, field
    return None


_Row = list[tuple[str, int]]


def _message(
    reading: Reading, row: Passage, own: _Row, columns: dict[str, list[int]], message: WireMessage
) -> Iterator[Diagnostic]:
    base, full = message.base_length, message.length
    frames = {HEAD_V2 + base, HEAD_V2 + full, HEAD_V1 + base}
    wanted = {
        "id": ({message.id}, MESSAGE_ID, f"has the id {message.id}"),
        "crc": ({message.crc_extra}, CRC_EXTRA, f"has the CRC_EXTRA {message.crc_extra}"),
        "base": ({base}, SIZE, f"has a payload of {base} bytes without extensions"),
        "full": ({full}, SIZE, f"has a payload of {full} bytes with extensions"),
        "payload": ({base, full}, SIZE, f"has a payload of {base} bytes, {full} with extensions"),
        "frame": (frames | {each + _SIGNATURE for each in frames}, SIZE, f"has frames of {HEAD_V2 + base} bytes"),
    }
    for key, (numbers, rule, words) in wanted.items():
        for index in columns[key]:
            found = _WHOLE.fullmatch(own[index][0].strip()) if index < len(own) else None
            if found is not None and int(found[1]) not in numbers and message.id >= 0:
                place = row.place_at(own[index][1])
                yield reading.found(
                    rule, place, f"{message.name} {key} {found[1]}", f"{message.name} {words}, not {found[1]}"
                )


def _entry(reading: Reading, row: Passage, own: _Row, column: int) -> Iterator[Diagnostic]:
    """``| MAV_CMD_DO_SET_HOME | 179 |``, in either order."""
    if column >= len(own):
        return
    number, offset = own[column][0].strip(), own[column][1]
    for name in (own[index][0].strip() for index in (column - 1, column + 1) if 0 <= index < len(own)):
        if _ENTRY.fullmatch(name) is None or not re.fullmatch(r"\d{1,6}|0x[0-9A-Fa-f]{1,8}", number):
            continue
        values = {entry.value for enum in reading.enums.values() for entry in enum.entries if entry.name == name}
        if values and int(number, 0) not in values:
            text = f"{name} is {min(values)}, not {number}"
            yield reading.found(ENTRY_VALUE, row.place_at(offset), f"{name} {number}", text)


def _of_field(
    reading: Reading, row: Passage, own: _Row, columns: dict[str, list[int]], message: WireMessage, field: WireField
) -> Iterator[Diagnostic]:
    name = f"{message.name}.{field.name}"
    for index in columns["offset"]:
        found = _WHOLE.fullmatch(own[index][0].strip()) if index < len(own) else None
        if found is not None and columns["field"] and int(found[1]) != field.offset:
            text = f"{name} begins at byte {field.offset}, not {found[1]}"
            yield reading.found(OFFSET, row.place_at(own[index][1]), f"{name} at {found[1]}", text)
    for index in columns["unknown"]:
        stated = number_of(own[index][0].strip()) if index < len(own) else None
        values = unknown_values(field)
        is_entry = stated == 0 and field.definition.enum
        if stated is not None and values and not is_entry and not any(same_number(stated, each) for each in values[0]):
            text = f"{name} is unknown when it is {values[1]}, not {own[index][0].strip()}"
            yield reading.found(SENTINEL, row.place_at(own[index][1]), f"{name} {own[index][0].strip()}", text)
    for index in columns["enum"]:
        stated_enum = own[index][0].strip() if index < len(own) else ""
        if stated_enum in reading.enums and field.definition.enum and stated_enum != field.definition.enum:
            text = f"{name} has the enum {field.definition.enum}, not {stated_enum}"
            yield reading.found(ENUM_OF, row.place_at(own[index][1]), f"{name} {stated_enum}", text)
    yield from _types(reading, row, own, columns, name, field)
    yield from _units(reading, row, own, columns, message, field)


def _types(
    reading: Reading, row: Passage, own: _Row, columns: dict[str, list[int]], name: str, field: WireField
) -> Iterator[Diagnostic]:
    """The column of types, and the values of an enum that any other cell lists."""
    for index in columns["type"] if columns["field"] else ():
        cell = TYPE_CELL.fullmatch(own[index][0].strip()) if index < len(own) else None
        if cell is not None and not has_type(field, spelled_type(cell)):
            text = f"{name} is {typed(field.definition)}, not {own[index][0].strip()}"
            yield reading.found(TYPE, row.place_at(own[index][1]), f"{name} {spelled_type(cell)}", text)
    enum = reading.enums.get(field.definition.enum or "")
    for text, offset in own[1:] if enum else ():
        for found in ENTRY.finditer(row.text, offset, offset + len(text)):
            if enum is not None:
                yield from entry_claim(reading, name, enum, row, found)


def _units(
    reading: Reading, row: Passage, own: _Row, columns: dict[str, list[int]], message: WireMessage, field: WireField
) -> Iterator[Diagnostic]:
    """The column of units; without one what another cell ends with: ``speed (m/s)``, ``uint16, cm``, ``vel [m/s]``."""
    stated = [own[index] for index in columns["unit"] if index < len(own)]
    if not stated:
        first = _FIELD.fullmatch(own[0][0].strip())
        stated = [(first["unit"], own[0][1])] if first and first["unit"] else []
        ends = [(_SAID_UNIT.fullmatch(text.strip()), offset) for text, offset in own[1:]]
        stated += [(found["unit"], offset + found.start("unit")) for found, offset in ends if found is not None]
    for text, offset in stated:
        found = list(unit_claim(reading, message, field.name, text.strip(), row.place_at(offset)))
        yield from found
        if found:
            return
