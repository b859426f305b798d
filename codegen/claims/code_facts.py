"""Claims in lines of code about messages, fields and entries: constants, and comments beside the fields of a struct."""

import re
from collections.abc import Iterator, Mapping, Sequence

from codegen.claims.enclosing import types_around
from codegen.claims.enum_names import entry_values
from codegen.claims.reading import Reading
from codegen.claims.rules import CRC_EXTRA, ENTRY_VALUE, MESSAGE_ID, SIZE, UNIT
from codegen.diagnostics import Diagnostic
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.once import once
from codegen.pattern import pattern
from codegen.source import Place

_MODIFIERS = (
    r"(?:(?:pub|public|private|protected|internal|export|static|final|readonly|constexpr|const|let|var|auto|size_t"
    r"|u?int(?:\d+(?:_t)?)?|long|short|byte|u\d+|usize)\s+)*"
)
_CONSTANT = pattern(
    rf"^\s*(?:#define\s+|{_MODIFIERS})(?P<name>[A-Z][A-Z0-9_]{{2,80}})"
    r"(?:\s*:\s*\w+)?\s*=?\s+\(?(?P<value>0x[0-9a-fA-F]{1,8}|\d{1,8})\)?\s*[;,]?\s*(?://.*|/\*.*|#.*)?$"
)
_ROLE = pattern(
    r"(?:MAVLINK_MSG_ID_|MAVLINK_MSG_|MSG_|MAVLINK_|(?P<first>CRC_EXTRA|CRC|LENGTH|LEN|ID)_)?(?P<message>\w+?)(?:_(?P<role>ID|CRC_EXTRA|CRC|EXTRA|LEN|LENGTH|MIN_LEN|SIZE|PAYLOAD_LEN))?$"
)
_NUMBERED = pattern(r"(?:MAVLINK_)?(?:MSG|MESSAGE)_?ID_")
_BY_ID = pattern(r"MAVLINK_MSG_ID_(?P<id>\d{1,8})_(?P<role>LEN|MIN_LEN|CRC)")
_BARE = pattern(
    rf"^\s+{_MODIFIERS}(?:\w+ )?(?:MAVLINK_)?(?:MSG_|MESSAGE_)?"
    r"(?P<role>ID|CRC_EXTRA|EXTRA_CRC|CRC|LEN|LENGTH|MIN_LEN|MIN_LENGTH|PAYLOAD_LEN)\s*(?::\s*\w+\s*)?"
    r"=\s*(?P<value>\d{1,6})\s*[;,]?\s*(?://.*)?$"
)
_OF_TYPE = pattern(
    rf"^\s+(?P<modifiers>{_MODIFIERS})_?(?P<role>message_id|messageId|msg_id|msgId|msgid|id|crc_extra|crcExtra)"
    r"(?:\s*:\s*\w+)?\s*=\s*(?:U?[iI]nt\d*\()?(?P<value>\d{1,6})\)?\s*[;,]?\s*(?://.*)?$"
)
"""A constant of a type that bears the name of a message; one called ``id`` has to be of the type itself."""
_UNITS = pattern(r"^\s*@Units\(\"(?P<unit>[^\"]{1,20})\"\)\s*$")
_DECLARED = pattern(r"^\s*public\s+[\w\[\]]+\s+(?P<name>[a-z]\w*)(?:\[\])?\s*(?:=[^;]*)?;")
_COMMENT = pattern(
    r"(?:/\*|//|#)\s*(?P<message>[A-Z][A-Z0-9_]{2,60})(?:,?| [^.;]{1,30},) (?:message )?id:? #?(?P<id>\d{1,6})\b"
)
_SAID_OF = pattern(r"(?:/\*|//|#)\s*(?P<message>[A-Z][A-Z0-9_]{2,60})(?![\w.])")
_NAMED = pattern(r"(?:(?:export )?const|#)?\s*(?P<message>[A-Z][A-Z0-9_]{2,60})\s*(?::\s*\w+\s*)?=?\s*\{")
_KEY = pattern(
    r"^\s*[\"']?(?P<key>id|crcExtra|crc_extra|minLength|min_length|maxLength|length)[\"']?\s*:\s*(?P<value>\d{1,6})\b"
)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every line of every block of code."""
    entries = entry_values(reading.enums)
    for code in reading.prose.code:
        yield from _listed(reading, code)
        types = tuple(types_around(reading, code))
        yield from _units(reading, code, types)
        about: WireMessage | None = None
        seen = [(number, name) for number, name in reading.sightings if code.place.line <= number]
        for line, around in zip(code.lines, types, strict=True):
            yield from _constants(reading, line, entries)
            yield from _comments(reading, line)
            near = [name for number, name in seen if number <= line.place.line][-1:]
            yield from _alone(reading, line, near if around is None else [around.name])
            if around is not None:
                yield from _of_type(reading, line, around)
            yield from _length(reading, line)
            named = _NAMED.match(line.text)
            if named is not None:
                about = reading.messages.get(named["message"])
            elif line.text.strip().startswith("}"):
                about = None
            elif about is not None:
                yield from _keys(reading, line, about)


def _listed(reading: Reading, code: CodeBlock) -> Iterator[Diagnostic]:
    """``HEARTBEAT = 0`` and others below each other, of which most are ids."""
    found = [
        (line, each) for line in code.lines if (each := _MEMBER.match(line.text)) and each["name"] in reading.messages
    ]
    wrong = [(line, each) for line, each in found if reading.messages[each["name"]].id not in (int(each["value"]), -1)]
    if len(found) > len(wrong) and len(found) >= 2 * len(wrong):
        for line, each in wrong:
            yield from number_claims(
                reading, reading.messages[each["name"]], "id", int(each["value"]), _at(line, each.start("value"))
            )


_MEMBER = pattern(
    r"\s*[\"']?(?P<name>[A-Z][A-Z0-9_]{2,60})[\"']?\s*[=:]\s*(?P<value>\d{1,6})\s*[,;]?\s*(?://.*|#.*|/\*.*)?$"
)


def _units(reading: Reading, code: CodeBlock, types: Sequence[WireMessage | None]) -> Iterator[Diagnostic]:
    """``@Units("mV")`` above a member of a class of the message's name, with other notes between them."""
    noted: tuple[Line, re.Match[str]] | None = None
    for line, around in zip(code.lines, types, strict=True):
        found = _UNITS.match(line.text)
        member = _DECLARED.match(line.text)
        if found is not None:
            noted = (line, found)
        elif member is not None:
            field = around.field(member["name"]) if around is not None else None
            if noted is not None and around is not None and field is not None and field.definition.units:
                yield from _unit(reading, noted[0], noted[1], f"{around.name}.{field.name}", field)
            noted = None


def _unit(reading: Reading, line: Line, found: "re.Match[str]", name: str, field: WireField) -> Iterator[Diagnostic]:
    if found["unit"] != field.definition.units:
        text = f"{name} is in {field.definition.units}, not {found['unit']}"
        yield reading.found(UNIT, _at(line, found.start("unit")), f"{name} {found['unit']}", text)


def _at(line: Line, offset: int) -> Place:
    return line.place._replace(column=line.place.column + offset)


def _constants(reading: Reading, line: Line, entries: Mapping[str, int]) -> Iterator[Diagnostic]:
    found = _CONSTANT.match(line.text)
    if found is None:
        return
    name, number = found["name"], int(found["value"], 0)
    place = _at(line, found.start("value"))
    of_id = _BY_ID.fullmatch(name)
    if of_id is not None:
        named = by_id(reading.messages).get(int(of_id["id"]))
        if named is not None:
            yield from number_claims(reading, named, of_id["role"].lower(), number, place)
        return
    if name in entries:
        if entries[name] != number:
            text = f"{name} is {entries[name]}, not {found['value']}"
            yield reading.found(ENTRY_VALUE, place, f"{name} {number}", text)
        return
    prefix = _NUMBERED.match(name)
    numbered = reading.messages.get(name[prefix.end() :]) if prefix is not None else None
    parts = _ROLE.match(name)
    role = "id" if numbered else ((parts["role"] or parts["first"]) if parts else None)
    message = numbered or (reading.messages.get(parts["message"]) if parts else None)
    said = _SAID_OF.search(line.text, found.end("value")) if message is None and role is not None else None
    message = reading.messages.get(said["message"]) if said is not None else message
    if role is not None and message is not None and message.id >= 0:
        yield from number_claims(reading, message, role.lower(), number, place)


def number_claims(reading: Reading, message: WireMessage, role: str, number: int, place: Place) -> Iterator[Diagnostic]:
    """Yield a finding where the id, CRC_EXTRA or length that code gives to a message differs from the dialect."""
    if role == "id" and number != message.id:
        text = f"{message.name} has the id {message.id}, not {number}"
        yield reading.found(MESSAGE_ID, place, f"{message.name} id {number}", text)
    elif role in ("crc", "crc_extra", "extra", "crcextra") and number != message.crc_extra:
        text = f"{message.name} has the CRC_EXTRA {message.crc_extra}, not {number}"
        yield reading.found(CRC_EXTRA, place, f"{message.name} crc {number}", text)
    elif role in ("min_len", "minlength", "min_length") and number != message.base_length:
        text = f"{message.name} has a payload of {message.base_length} bytes without extensions, not {number}"
        yield reading.found(SIZE, place, f"{message.name} length {number}", text)
    elif role in ("len", "length", "payload_len", "maxlength") and number not in (message.base_length, message.length):
        both = f"{message.base_length} bytes, {message.length} with extensions"
        yield reading.found(SIZE, place, f"{message.name} length {number}", f"{message.name} has {both}, not {number}")


def _alone(reading: Reading, line: Line, near: list[str]) -> Iterator[Diagnostic]:
    """``const ID: u32 = 30;`` below the name of a type."""
    found = _BARE.match(line.text) if near else None
    message = reading.messages[near[0]] if near else None
    if found is not None and message is not None and message.id >= 0:
        role = found["role"].lower().removeprefix("extra_")
        yield from number_claims(reading, message, role, int(found["value"]), _at(line, found.start("value")))


@once
def by_id(messages: Mapping[str, WireMessage]) -> Mapping[int, WireMessage]:
    """Return messages, which documents about one dialect share, by their ids."""
    return {message.id: message for message in messages.values() if message.id >= 0}


def _of_type(reading: Reading, line: Line, message: WireMessage) -> Iterator[Diagnostic]:
    """``public _message_id: number = 22;`` in a class of the message's name."""
    found = _OF_TYPE.match(line.text)
    if found is None or message.id < 0 or (found["role"] == "id" and "static" not in found["modifiers"]):
        return
    role = "crc" if found["role"].lower().startswith("crc") else "id"
    yield from number_claims(reading, message, role, int(found["value"]), _at(line, found.start("value")))


_OWN_LENGTH = pattern(
    r"^\s*(?:#define|(?:pub |export |static |constexpr )*(?:const|let|var))\s+(?:MSG_|MESSAGE_)?"
    r"(?P<role>(?:MIN_|MAX_|PAYLOAD_)?(?:LEN|LENGTH)|(?:min|max|payload)_?(?:len|length)|[pP]ayloadLen(?:gth)?)"
    r"(?:\s*:\s*\w+)?\s*=?\s*(?P<value>\d{1,3})\s*;?\s*(?://.*)?$"
)


def _length(reading: Reading, line: Line) -> Iterator[Diagnostic]:
    """``const PAYLOAD_LEN: usize = 28;`` in a document about one message."""
    found = _OWN_LENGTH.match(line.text)
    names = {name for _, name in reading.sightings} if found is not None else set()
    lines = [each.text for code in reading.prose.code for each in code.lines] if len(names) == 1 else []
    if found is None or sum(f"{found['role']}:" in text or f"{found['role']} " in text for text in lines) != 1:
        return  # or each of several types has one
    message = reading.messages[names.pop()] if len(names) == 1 else None
    if message is not None and message.id >= 0:
        role = "min_len" if found["role"].lower().startswith("min") else "len"
        yield from number_claims(reading, message, role, int(found["value"]), _at(line, found.start("value")))


def _comments(reading: Reading, line: Line) -> Iterator[Diagnostic]:
    found = _COMMENT.search(line.text)
    message = reading.messages.get(found["message"]) if found else None
    if found is not None and message is not None and message.id >= 0:
        yield from number_claims(reading, message, "id", int(found["id"]), _at(line, found.start("id")))


def _keys(reading: Reading, line: Line, message: WireMessage) -> Iterator[Diagnostic]:
    found = _KEY.match(line.text)
    if found is not None and message.id >= 0:
        yield from number_claims(
            reading, message, found["key"].lower(), int(found["value"]), _at(line, found.start("value"))
        )
