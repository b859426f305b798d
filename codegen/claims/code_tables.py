"""Tables of messages in code: their ids, CRC_EXTRA and lengths as pairs of names and numbers, in any language."""

import re
from collections.abc import Iterator, Mapping

from codegen.claims.code_facts import by_id, number_claims
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic
from codegen.load.markdown_blocks import Line
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern

_NAME = r"[A-Z][A-Z0-9_]{2,60}"
_NAMED = pattern(rf"[\"']?(?P<name>{_NAME})[\"']?\s*(?::|=>|=)\s*(?P<number>0x[0-9a-fA-F]{{1,6}}|\d{{1,6}})(?![\w.])")
_NUMBERED = pattern(rf"(?<![\w.])(?P<number>\d{{1,6}})\s*(?::|=>)\s*[\"'](?P<name>{_NAME})[\"']")
_BY_ID = pattern(r"(?<![\w.])(?P<id>\d{1,6})\s*(?::|=>)\s*(?P<number>0x[0-9a-fA-F]{1,6}|\d{1,6})(?![\w.])")
_CASE = pattern(
    rf"(?:\bcase\s+|==\s*|\b(?:id|msgid|msg_id|message_id)\s*[:=]\s*)(?P<number>\d{{1,6}})\s*[:)]?[:;,{{]?\s*"
    rf"(?://|#|/\*)\s*(?P<name>{_NAME})\b"
)
_OBJECT = pattern(
    rf"\bid[\"']?\s*[:=]\s*(?P<number>\d{{1,6}})\s*,\s*[\"']?name[\"']?\s*[:=]\s*[\"'](?P<name>{_NAME})[\"']"
    rf"|\bname[\"']?\s*[:=]\s*[\"'](?P<first>{_NAME})[\"']\s*,\s*[\"']?id[\"']?\s*[:=]\s*(?P<then>\d{{1,6}})"
)
_KEYED = pattern(rf"[\"']?(?P<name>{_NAME})[\"']?\s*[:=]\s*\{{(?P<inner>[^{{}}]{{1,200}})")
_KEY = pattern(
    r"[\"']?(?P<key>id|crcExtra|crc_extra|crc|minLength|min_length|maxLength|length)[\"']?\s*[:=]\s*(?P<value>\d{1,6})\b"
)
_ROLES: Mapping[str, "re.Pattern[str]"] = {
    "crc": pattern(r"crc|seed", re.IGNORECASE),
    "id": pattern(r"(?:msg|message)_?ids?\b|(?<![a-z])ids?\b|_ids?\b|Ids?\b|\bIDS?\b|MsgId|MessageId"),
    "length": pattern(r"(?:^|_|\b)len(?:gths?)?s?\b|payload|sizes?\b", re.IGNORECASE),
}
_BRANCH = pattern(r"\b(?:match|switch|if|while|return)\b")
_ROLE_OF_KEY = {"crcextra": "crc", "crc_extra": "crc", "minlength": "min_length", "min_length": "min_length"}


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every line of every block of code."""
    for code in reading.prose.code:
        role: str | None = None
        for line in code.lines:
            yield from _always(reading, line)
            opened = pattern(r"[{\[(]").search(line.text)
            if opened is not None and not _BRANCH.search(line.text) and not _NAMED.match(line.text.lstrip()):
                own = _role(line.text if line.text.rstrip().endswith("{") else line.text[: opened.start()])
                role = own or (role if line.text.startswith((" ", "\t")) else None)
            if role is not None:
                yield from _pairs(reading, line, role)
            if line.text.startswith(("}", "]", ")")):
                role = None


def _role(head: str) -> str | None:
    """Return the role of a table's numbers ("id", "crc", ...) by the name in front of it; None where it tells none."""
    return next((role for role, words in _ROLES.items() if words.search(head)), None)


def _number(written: str) -> int:
    return int(written, 0) if written[:2] in ("0x", "0X") else int(written)


def _found(
    reading: Reading, line: Line, message: WireMessage | None, role: str, found: "re.Match[str]", group: str
) -> Iterator[Diagnostic]:
    if message is not None and message.id >= 0:
        place = line.place._replace(column=line.place.column + found.start(group))
        yield from number_claims(reading, message, role, _number(found[group]), place)


def _always(reading: Reading, line: Line) -> Iterator[Diagnostic]:
    """Pairs that are an id whatever stands around them, and objects with keys."""
    for form in (_NUMBERED, _CASE):
        for found in form.finditer(line.text):
            yield from _found(reading, line, reading.messages.get(found["name"]), "id", found, "number")
    for found in _OBJECT.finditer(line.text):
        group = "number" if found["number"] else "then"
        message = reading.messages.get(found["name"] or found["first"])
        yield from _found(reading, line, message, "id", found, group)
    for found in _KEYED.finditer(line.text):
        message = reading.messages.get(found["name"])
        for key in _KEY.finditer(line.text, found.start("inner"), found.end("inner")) if message else ():
            role = key["key"].lower()
            yield from _found(reading, line, message, _ROLE_OF_KEY.get(role, role), key, "value")


def _pairs(reading: Reading, line: Line, role: str) -> Iterator[Diagnostic]:
    """``"NAME": 84`` of a table whose name says what the numbers are, and ``24: 24`` where they are no ids."""
    for found in _NAMED.finditer(line.text):
        yield from _found(reading, line, reading.messages.get(found["name"]), role, found, "number")
    for found in _BY_ID.finditer(line.text) if role != "id" else ():
        yield from _found(reading, line, by_id(reading.messages).get(int(found["id"])), role, found, "number")
