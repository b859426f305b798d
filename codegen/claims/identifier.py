"""Numbers that stand beside names: ids of messages, values of enum entries, CRC_EXTRA."""

import re
from collections.abc import Iterator

from codegen.claims.reading import Mention, Reading, between
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import CodeBlock, Passage
from codegen.model.dialect.literals import entry_value
from codegen.source import Place

MESSAGE_ID = Rule(
    "claim-message-id",
    "A document gives a message another id than its definition has, in the dialect or in the XML of the document "
    "itself. Correct the one that is wrong.",
)
ENTRY_VALUE = Rule(
    "claim-enum-value",
    "A document gives an entry of an enum another value than the dialect has. Correct it: the value is what is sent.",
)
CRC_EXTRA = Rule(
    "claim-crc-extra",
    "A document gives a message another CRC_EXTRA than its name and its base fields have. Either the number is wrong, "
    "or it belongs to another layout of the message: receivers with one drop the frames of the other.",
)

# (#147)  (ID #147)  (ID: 147)  (147)  id 147  #147
_AFTER = re.compile(
    r"(?:\s+messages?)?(?:\s*\((?:(?:message |msg)?id[ :=]{0,2})?#?(?P<held>\d{1,8})\)"
    r"|,?\s+(?:message |msg)?id[ :=]{1,3}#?(?P<named>\d{1,8})\b|\s+#(?P<marked>\d{1,8})\b)",
    re.IGNORECASE,
)
_COMMENT = re.compile(r"(?://|/\*|#|<!--|\*)\s.*?\bmessages?\s+(?:id\s*)?#?(\d{1,8})\b", re.IGNORECASE)
_NOTHING_MORE = re.compile(r"\)?[\s.,;]*$")
_ENTRY = re.compile(r"(?<![\w.])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+){2,}(?![\w])")
_NUMBER = r"(?:0[xX][0-9a-fA-F]{1,16}|\d{1,20})"
_VALUE_AFTER = re.compile(
    rf"\s*\(\s*({_NUMBER})\s*\)|\s*=\s*({_NUMBER})(?![\w.])"
    rf"|,? (?:is|has) (?:the )?(?:command|number|value|code)(?: number| id)? ({_NUMBER})(?![\w.]\d|\w)"
)
_VALUE_BEFORE = re.compile(
    rf"(?:^|[|:=,]|\bis|\bto|\bor|\bvalue|\b[Cc]ommand|\bresult|\bstate|\btype)\s*({_NUMBER})\s*\(\s*$"
)
_CRC = re.compile(
    r"\b(?:CRC[_ -]?EXTRA|extra CRC|(?:CRC[_ ])?seed)\b"
    r"(?:\s+(?:byte|of|is|for|value|[A-Z][A-Z0-9_]{2,60}))*[\s:=(]{1,3}(0x[0-9a-f]{1,2}\b|\d{1,3}\b)",
    re.IGNORECASE,
)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every number of a passage that stands beside a name."""
    entries = {entry.name: entry.value for enum in reading.enums.values() for entry in enum.entries}
    for passage, mentions in reading.passages_with_messages():
        yield from _ids(reading, passage, mentions)
        yield from _crcs(reading, passage, mentions)
    for passage in reading.prose.passages:
        yield from _values(reading, passage, entries)


def commented_id(code: CodeBlock) -> tuple[int, Place] | None:
    """The id that a comment of a block of code gives its message, and the place of its line."""
    for line in code.lines:
        found = _COMMENT.search(line.text)
        if found:
            return int(found[1]), line.place
    return None


def _ids(reading: Reading, passage: Passage, mentions: tuple[Mention, ...]) -> Iterator[Diagnostic]:
    for mention in mentions:
        found = _AFTER.match(passage.text, mention.end)
        if found is None:
            continue
        group = found.lastgroup or ""
        stated, message = int(found[group]), reading.messages[mention.name]
        is_called_id = "id" in found[0].lower()
        # "Add BATTERY_STATUS (#1068)" is how changes are called that belong to a discussion.
        is_discussed = "#" in found[0] and not is_called_id and _NOTHING_MORE.match(passage.text, found.end(group))
        is_count = "#" not in found[0] and not is_called_id and "_" not in mention.name
        if stated == message.id or message.id < 0 or is_discussed or is_count:
            continue
        others = [other.name for other in reading.messages.values() if other.id == stated]
        text = f"{message.name} has the id {message.id}, not {stated}"
        words = passage.text[mention.start : found.end()]
        yield reading.found(
            MESSAGE_ID,
            passage.place_at(found.start(group)),
            words,
            text,
            f"{stated} is {others[0]}" if others else None,
            _definition(reading, message.definition.place),
        )


def _definition(reading: Reading, place: Place) -> list[tuple[Place, str]]:
    return [(place, "it is defined here")] if place.file == reading.prose.path else []


def _crcs(reading: Reading, passage: Passage, mentions: tuple[Mention, ...]) -> Iterator[Diagnostic]:
    for found in _CRC.finditer(passage.text):
        start, end = passage.sentence(found.start(), found.end())
        named = {mention.name for mention in between(mentions, start, end)}
        if len(named) != 1:
            continue
        message = reading.messages[named.pop()]
        stated = int(found[1], 16 if found[1][:2] in ("0x", "0X") else 10)
        if stated != message.crc_extra:
            text = f"{message.name} has the CRC_EXTRA {message.crc_extra}, not {stated}"
            words = f"{message.name} {found[0]}"
            yield reading.found(CRC_EXTRA, passage.place_at(found.start(1)), words, text)


def _values(reading: Reading, passage: Passage, entries: dict[str, int]) -> Iterator[Diagnostic]:
    for name in _ENTRY.finditer(passage.text):
        if name[0] not in entries:
            continue
        after = _VALUE_AFTER.match(passage.text, name.end())
        before = _VALUE_BEFORE.search(passage.text, max(name.start() - 30, 0), name.start())
        found = after or before
        if found is None:
            continue
        written = next(group for group in found.groups() if group)
        stated = entry_value(written)
        if stated is None or stated == entries[name[0]]:
            continue
        text = f"{name[0]} is {entries[name[0]]}, not {written}"
        words = passage.text[min(name.start(), found.start()) : max(name.end(), found.end())]
        yield reading.found(ENTRY_VALUE, passage.place_at(found.start()), words, text)
