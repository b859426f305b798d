"""Names of messages, fields and entries that there are not, and that look like one that there is."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from difflib import get_close_matches
from itertools import groupby, pairwise

from codegen.claims.about import surroundings
from codegen.claims.field_notes import field_notes
from codegen.claims.keyed_fields import keyed_fields
from codegen.claims.known_names import (
    FAMILY,
    UPPER,
    Names,
    entry_start,
    is_of_field,
    is_successor,
    is_unknown,
    names_of,
    near_fields,
    near_message,
)
from codegen.claims.membership import names_field_of
from codegen.claims.misspelled import is_spelled_so, numbered_message, shortened_message
from codegen.claims.reading import Reading, between
from codegen.claims.unknown_fields import fields, first, members, no_field, qualified
from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import Dialect, WireMessage
from codegen.once import once
from codegen.pattern import pattern
from codegen.source import Place

NO_MESSAGE = Rule(
    "claim-no-message",
    "A document names a message that no dialect has, and that looks like one of them. Correct the name, or list the "
    "dialect that has it under known in codegen.yaml. "
    "It is likely, not certain: another dialect may have it.",
    Severity.WARNING,
    remedy="write the name as the dialect has it, or list under known the dialect that has this one",
)
NO_ENTRY = Rule(
    "claim-no-entry",
    "A document names an entry that its enum does not have, and that looks like one that it has. Correct the name. "
    "It is likely, not certain: another dialect may have it.",
    Severity.WARNING,
)

_SENT = pattern(
    r"\b(?:messages?|send|sends|sent|answers?|streams?|streamed|requests?|requested|repl(?:y|ies)|receives?|publishe?s?"
    r"|uses?|emits?|telemetry|Hz)\b",
    re.IGNORECASE,
)
_BEFORE = pattern(
    r"\b(?:messages?|msg|sends?(?: out| back)?|streams?|requests?|publish(?:es)?|uses?|emits?|answers? with"
    r"|repl(?:y|ies) with|reads?|receives?|forwards?|decodes?|handles?|subscribes? to|listens? (?:to|for)|asks? for"
    r"|waits? for|broadcasts?|records?|logs?) (?:the |an? |each |all |only )?$",
    re.IGNORECASE,
)
_BEHIND = pattern(
    r" ?(?:message|packet|frame)\b| \((?:id |#)?\d| (?:at|with|every) \d|,? \d+ ?Hz"
    r"| (?:(?:is|are) (?:not |never |only )?(?:sent|streamed|received|requested|answered|published|broadcast)"
    r"|carries|arrives|comes|reports)\b",
    re.IGNORECASE,
)
_SENDS = pattern(
    r"\b(?:messages?|msg|sends?|streams?|receives?|answers? with|repl(?:y|ies) with|broadcasts?"
    r"|records?) (?:the |an? |each )?$",
    re.IGNORECASE,
)
_PARAMETER = pattern(r"[A-Z]+\d_")
_IS_SENT = pattern(
    r" ?(?:messages?|packet)\b| (?:is|are) (?:not |never |only )?(?:sent|streamed|received|broadcast)\b| at \d+ ?Hz"
    r"| (?:carries|arrives|comes|contains|reports)\b"
)
_OWN = pattern(
    r"\b(?:propos\w*|new|private|custom|own|vendor\w*|draft|future|planned|would|parameters?|topics?|macros?"
    r"|upstream)\b",
    re.IGNORECASE,
)
_IN_CODE = pattern(
    r"(?:\btype\s*=\s*|get_?[tT]ype\(\)\s*===?\s*|\bname\s*===?\s*)[\"'](?P<quoted>[A-Z][A-Z0-9_]{2,60})[\"']"
    r"|\bMAVLINK_MSG_ID_(?P<constant>[A-Z][A-Z0-9_]{2,60})(?![\w])"
)
_OF_LIBRARY = pattern(r"_(?:(?:MIN_)?LEN|CRC|FIELD_[A-Z0-9_]+_LEN)$")
"""The end of names that libraries in C make of the name of a message, "MAVLINK_MSG_ID_HEARTBEAT_MIN_LEN"."""
_TAKEN = pattern(r"^\s*(?P<variable>\w+)\s*=\s*.*\btype\s*=\s*[\"'](?P<message>[A-Z][A-Z0-9_]{2,60})[\"']")
_DECLARED = pattern(r"\bmavlink_(?P<message>[a-z][a-z0-9_]{2,60})_t\s+(?P<variable>\w+)\s*[;=]")
_CONSTANT = pattern(r"(?<![\w\-/])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+(?![\w*])")
_MEMBER = pattern(r"(?<![\w.])(?P<variable>[a-z]\w{0,60})\.(?P<field>[a-z]\w{0,60})\b(?!\()")
_QUOTED = pattern(r"[\"'](?P<name>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*)[\"']")
_WORD = pattern(r"(?<![\w.\-/])[A-Z]{6,}(?![\w\-/]|\.[a-z]|\s*\()")
_JOINED = pattern(r"[`\s]*(?:,|and|or|/|, and)[`\s]*")
_NEAR = 20
"""Messages of a sentence that are looked at for one directly beside a name."""
_SURE = 0.7
"""The likeness that a name must have to a known one (0 to 1), where the words around it call for a message."""
_KIN = 0.65
"""The same for a name with the prefix that all entries of an enum have."""


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every passage, every run of rows or items, and every line of code."""
    names = names_of(reading)
    for notes in field_notes(reading):
        for note in notes.notes if not notes.is_whole and notes.message.name not in names.followed else ():
            own = [field.name for field in notes.message.fields]
            is_one = note.type is None or is_of_field(note.name, own) or note.name in names.fields
            if not is_one and near_fields(note.name, notes.message):
                yield no_field(reading, note.passage.place, notes.message, note.name)
    for kind, run in groupby(surroundings(reading), lambda each: getattr(each[0], "kind", None)):
        parts = list(run)
        passages = [part for part, _ in parts if isinstance(part, Passage)]
        listed = _listed(reading, passages) if kind in (PassageKind.ROW, PassageKind.ITEM) else frozenset[int]()
        if kind in (PassageKind.ROW, PassageKind.ITEM):
            yield from members(reading, passages, parts[0][1], names)
        for part, around in parts:
            if isinstance(part, CodeBlock):
                yield from _code(reading, part, names)
                continue
            yield from _messages(reading, part, names, listed)
            yield from _entries(reading, part, names)
            yield from fields(reading, part, around, names)
            yield from qualified(reading, part, names)


def unknown_names(reading: Reading) -> Iterator[str]:
    """The names in a document that may be those of messages, and that its dialect does not have."""
    texts = [passage.text for passage in reading.prose.passages]
    texts += [line.text for code in reading.prose.code for line in code.lines]
    for text in texts:
        yield from (found[0] for found in _CONSTANT.finditer(text) if found[0] not in reading.messages)


def _listed(reading: Reading, passages: Sequence[Passage]) -> frozenset[int]:
    """The passages of a run whose beginnings are names of messages: at least one of them is known."""
    begun = [(passage, found["name"]) for passage in passages if (found := first(passage)) and found["name"].isupper()]
    if sum(name in reading.messages for _, name in begun) * 2 < len(begun):
        return frozenset()
    return frozenset(id(passage) for passage, _ in begun)


def _messages(reading: Reading, passage: Passage, names: Names, listed: Collection[int]) -> Iterator[Diagnostic]:
    """Names of messages that no dialect has, where what stands around them is about messages."""
    for found in (*UPPER.finditer(passage.text), *_WORD.finditer(passage.text)):
        name = found[0]
        if not is_unknown(name, names):
            continue
        low, high = passage.sentence(found.start(), found.end())
        if _OWN.search(passage.text, low, high):
            continue
        following = _following_id(reading, passage) if passage.text.strip() == name else None
        numbered = numbered_message(passage.text, *found.span(), names.messages, following)
        if numbered is not None:
            yield _no_message(reading, passage.place_at(found.start()), name, numbered)
            continue
        is_alone = passage.kind is PassageKind.HEADING and passage.text.strip() == name and reading.sightings
        is_begun = is_alone or (id(passage) in listed and not passage.text[: found.start()].strip(" |*`-"))
        is_beside = _BEFORE.search(passage.text, max(low, found.start() - 20), found.start()) or _BEHIND.match(
            passage.text, found.end()
        )
        mentions = between(reading.mentioned(passage), low, high)
        is_told = mentions and _SENT.search(passage.text, low, high)
        is_joined = any(
            _JOINED.fullmatch(passage.text[min(found.end(), each.end) : max(found.start(), each.start)])
            for each in mentions[:_NEAR]
        )
        is_same = reading.sightings and (
            is_spelled_so(name, names.messages) or shortened_message(name, names.messages) is not None
        )
        near = shortened_message(name, names.messages) or near_message(name, names)
        has_field = near is not None and names_field_of(passage, low, high, names.messages[near])
        if not (is_begun or is_beside or is_told or is_joined or is_same or has_field):
            continue
        if _PARAMETER.match(name):
            continue
        is_row = is_begun and passage.kind is not PassageKind.HEADING
        is_sent = _SENDS.search(passage.text, max(low, found.start() - 20), found.start()) is not None
        is_sent = is_sent or (is_joined and _SENT.search(passage.text, low, high) is not None)
        is_sure = is_row or is_sent or _IS_SENT.match(passage.text, found.end()) is not None
        if near is None and is_sure and reading.sightings and not is_successor(name, names):
            near = next(iter(get_close_matches(name, names.messages, cutoff=_SURE)), None)
        if near is not None:
            yield _no_message(reading, passage.place_at(found.start()), name, near)


@once
def _below(reading: Reading) -> Mapping[int, str]:
    """By the identity of each heading what follows it directly."""
    parts = reading.prose.parts
    return {
        id(part): following.text
        for part, following in pairwise(parts)
        if isinstance(part, Passage) and part.kind is PassageKind.HEADING and isinstance(following, Passage)
    }


def _following_id(reading: Reading, passage: Passage) -> int | None:
    """The id with which the passage below a heading begins."""
    found = _ID_BELOW.match(_below(reading).get(id(passage), ""))
    return int(found["id"]) if found is not None else None


_ID_BELOW = pattern(r"(?:message |msg )?id:? #?(?P<id>\d{1,5})\b", re.IGNORECASE)


def _no_message(reading: Reading, place: Place, name: str, near: str) -> Diagnostic:
    return reading.found(NO_MESSAGE, place, name, f"there is no message {name}", f"did you mean {near}?")


def _entries(reading: Reading, passage: Passage, names: Names) -> Iterator[Diagnostic]:
    for found in UPPER.finditer(passage.text):
        low, high = passage.sentence(found.start(), found.end())
        if not _OWN.search(passage.text, low, high):
            yield from _entry(reading, passage.place_at(found.start()), found[0], names)


def _entry(reading: Reading, place: Place, name: str, names: Names) -> Iterator[Diagnostic]:
    """A name that begins as the entries of an enum do, and is none of them."""
    start = entry_start(name, names)
    if name in names.known or name in names.messages or name.endswith(_BEHIND_LAST):
        return
    if not start:
        yield from _turned(reading, place, name)
        return
    entries = names.entries[start]
    if sum(entry.startswith(f"{name}_") for entry in entries) >= FAMILY:
        return
    words = set(name.split("_"))
    near = [entry for entry in entries if words < set(entry.split("_"))][:1]
    near = near or get_close_matches(name, entries, n=1, cutoff=_KIN)
    if near:
        yield reading.found(NO_ENTRY, place, name, f"{start[:-1]} has no entry {name}", f"did you mean {near[0]}?")


_BEHIND_LAST = "_ENUM_END"
"""Libraries in C and other languages have a last entry of that name in each enum."""


def _turned(reading: Reading, place: Place, name: str) -> Iterator[Diagnostic]:
    """A long name with the words of an entry in another order, or without one of its letters."""
    words = name.split("_")
    if len(words) < _LONG:
        return
    names = _long_entries(reading.reference.dialect)
    near = next((each for each in names.get(len(name), ()) if sorted(each.split("_")) == sorted(words)), None)
    near = near or next((each for each in names.get(len(name) + 1, ()) if is_spelled_so(name, (each,))), None)
    enum = next((enum.name for enum in reading.enums.values() if near and enum.entry(near)), None)
    if enum is not None and near is not None:
        yield reading.found(NO_ENTRY, place, name, f"{enum} has no entry {name}", f"did you mean {near}?")


@once
def _long_entries(dialect: Dialect) -> Mapping[int, Sequence[str]]:
    """The entries with long names, by the length of these."""
    found: dict[int, list[str]] = {}
    for enum in dialect.enums.values():
        for entry in enum.entries:
            if entry.name.count("_") >= _LONG - 1:
                found.setdefault(len(entry.name), []).append(entry.name)
    return found


_LONG = 3
"""Words of a name that is hardly that of anything else."""


def _code(reading: Reading, code: CodeBlock, names: Names) -> Iterator[Diagnostic]:
    """Names that code asks for by their message, and members of what it got."""
    quoted = [(line, found) for line in code.lines for found in _QUOTED.finditer(line.text)]
    asked = [(line, found) for line in code.lines for found in _IN_CODE.finditer(line.text)]
    are_messages = any(found["name"] in names.messages for _, found in quoted)
    for line, found in (*asked, *(quoted if are_messages else ())):
        group = found.lastgroup or ""
        name = _OF_LIBRARY.sub("", found[group]) if group == "constant" else found[group]
        near = near_message(name, names) if is_unknown(name, names) and "_" in name else None
        if near is not None:
            yield _no_message(reading, _at(line, found.start(group)), name, near)
    yield from _read(reading, code, names)
    yield from keyed_fields(reading, code, names)
    for line in code.lines:
        for found in _CONSTANT.finditer(line.text):
            yield from _entry(reading, _at(line, found.start()), found[0], names)


def _read(reading: Reading, code: CodeBlock, names: Names) -> Iterator[Diagnostic]:
    """Members of what code got as a message that it named."""
    variables: dict[str, WireMessage] = {}
    for line in code.lines:
        for taken in (_TAKEN.search(line.text), _DECLARED.search(line.text)):
            message = names.messages.get(taken["message"].upper()) if taken else None
            if taken is not None and message is not None:
                variables[taken["variable"]] = message
        for found in _MEMBER.finditer(line.text) if variables else ():
            message = variables.get(found["variable"])
            if message is not None and not message.field(found["field"]) and near_fields(found["field"], message):
                yield no_field(reading, _at(line, found.start("field")), message, found["field"])


def _at(line: Line, offset: int) -> Place:
    return line.place._replace(column=line.place.column + offset)
