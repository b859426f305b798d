"""One document beside the dialect that its claims are compared with."""

import os
import re
from bisect import bisect_left
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Protocol, TypeVar

from codegen.claims.quoted import Quoted, quoted_definitions
from codegen.decode.decoded import decoded
from codegen.diagnostics import Diagnostic, Report, Rule
from codegen.findings.fingerprint import fingerprint
from codegen.frozen import dataclass
from codegen.load.prose import CodeBlock, Passage, PassageKind, Prose, read_prose
from codegen.model.dialect.dialect import Dialect, EnumDefinition, KnownMessage, WireMessage
from codegen.model.price import Range
from codegen.model.stated_parameter import StatedParameter
from codegen.model.system import System
from codegen.once import once
from codegen.pattern import pattern
from codegen.resolve.dialect.wire import wire_message
from codegen.source import Place

_NAME = pattern(r"(?<![\w-])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*(?![\w-])")
_WRONG = pattern(r"\W*(?:wrong|incorrect|do not copy|bad)\b\W", re.IGNORECASE, needs="bad|incorrect|not copy|wrong")
_ABOUT = pattern(r"mavlink|CRC[_ ]EXTRA", re.IGNORECASE)
_WORD = pattern(r"(?<![\w-])[A-Z][A-Z0-9]{3,}(?![\w-])")
_FRAMED = pattern(r"CRC_EXTRA|MAVLink|on the wire|payload", re.IGNORECASE)
_FEWEST = 3
"""Fields that a document names, to be about their message without its name."""
_SURE = pattern(r"(?<![\w-])(?:[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+|[A-Z]{8,})(?![\w-])")
_CONSTANT = pattern(
    r"(?<![\w-])(?:MAVLINK_)?MSG_(?:ID_)?(?P<name>[A-Z0-9_]+?)(?:_(?:ID|CRC|LEN|CRC_EXTRA))?(?![\w-])", needs="MSG"
)
"""Names that are hardly anything else than names of messages: of several words, or long ones."""
_TYPE_NAME = pattern(
    r"\b(?:struct|class|interface|impl|type|mod) (?P<camel>[A-Z][a-z0-9]+(?:[A-Z][a-z0-9]*)*)\b"
    r"|\b(?:def|fn|func|function|void) (?:parse|decode|unpack|pack|encode|read|handle|on|send|make|build)_"
    r"(?P<function>[a-z0-9_]{3,60}?)(?=\s*[(<])"
    r"|\bmavlink_(?:msg_)?(?P<c>[a-z0-9_]{3,60}?)_(?:t|send|pack|decode|encode)\b"
    r"|\.mav\.(?P<python>[a-z0-9_]{3,60}?)_(?:send|encode)\b"
    r"|\b(?P<data>[A-Z][A-Z0-9_]{2,60})_DATA\b|\bMSG_(?:ID_)?(?P<constant>[A-Z0-9_]{3,60}?)(?:_(?:ID|LEN|CRC"
    r"|CRC_EXTRA))?\b"
)
_CAMEL = pattern(r"(?<=[a-z0-9])([A-Z])")
_CITED = pattern(r"^ {0,3}>", re.MULTILINE)
_MOST_RELATED = 8
"""The most repetitions of a claim that are listed."""
_FAR = 300
"""The most mentions of messages that are searched for the one that a statement is about."""


@dataclass(frozen=True, slots=True)
class Reference:
    """The dialect that documents are compared with, and the facts of a project, if there is one.

    ``sent`` has the bytes of whole frames as the project sends them, by message; ``listed`` are messages of other
    dialects that it knows of, ``parameters`` what its programs say of each of theirs, ``rates`` at how many Hz
    each sends a message at first, ``systems`` these programs. ``overlays`` are those of the project, as it writes them,
    ``others`` those that it could list: by name what documents are compared with then, or None where that cannot be
    told.
    """

    dialect: Dialect
    sent: Mapping[str, Range] = field(default_factory=dict)
    listed: tuple[KnownMessage, ...] = ()
    parameters: Mapping[str, tuple[StatedParameter, ...]] = field(default_factory=dict)
    rates: Mapping[str, tuple[Fraction, ...]] = field(default_factory=dict)
    systems: tuple[System, ...] = ()
    overlays: tuple[str, ...] = ()
    others: Mapping[str, "Callable[..., Reference | None]"] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Mention:
    """A message that a passage names: its name, and where it stands in the text."""

    name: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Reading:
    """A document with all that its claims may be about.

    ``quoted`` are the definitions of its XML, and ``proposed`` its messages as they would go over the wire; for the
    rest of the document they take the place of messages of the dialect. ``messages`` has all of them by name,
    ``sightings`` the lines that name one, in order, ``cited`` the lines that repeat what somebody else wrote ("> ...").
    """

    prose: Prose
    reference: Reference
    quoted: Quoted
    proposed: tuple[WireMessage, ...]
    messages: Mapping[str, WireMessage]
    enums: Mapping[str, EnumDefinition]
    mentions: Mapping[int, tuple[Mention, ...]]
    once: Mapping[int, tuple[WireMessage, ...]]
    sightings: tuple[tuple[int, str], ...]
    cited: frozenset[int] = frozenset()

    def mentioned(self, passage: Passage) -> tuple[Mention, ...]:
        """The messages that a passage names, in order."""
        return self.mentions.get(id(passage), ())

    def named(self, passage: Passage) -> tuple[WireMessage, ...]:
        """The messages that a passage names, each once, the last one first."""
        return self.once.get(id(passage), ())

    def passages_with_messages(self) -> Iterator[tuple[Passage, tuple[Mention, ...]]]:
        """The passages that name a message, with the mentions."""
        for passage in self.prose.passages:
            if found := self.mentioned(passage):
                yield passage, found

    @property
    def quoted_as_wrong(self) -> frozenset[int]:
        """The lines of what a document itself calls wrong: a warning is no claim."""
        passages = [part for part in self.prose.passages if _WRONG.match(part.text)]
        lines = {place.line for passage in passages for _, place in passage.anchors}
        for code in self.prose.code:
            if code.lines and _WRONG.match(code.lines[0].text):
                lines |= {line.place.line for line in code.lines}
        return frozenset(lines)

    def named_near(self, line: int) -> Iterator[WireMessage]:
        """The messages that the document names, each once: first those up to a line, nearest first, then the others."""
        start = bisect_left(self.sightings, (line + 1, ""))
        near = [*reversed(self.sightings[max(start - _FAR, 0) : start]), *self.sightings[start : start + _FAR]]
        return (self.messages[name] for name in dict.fromkeys(name for _, name in near))

    def message_with(self, fields: Collection[str], line: int) -> WireMessage | None:
        """The message near a line that a list of field names is about: the first that has most of them."""
        for message in self.named_near(line):
            known = sum(message.field(name) is not None for name in fields)
            if known and known * 2 > len(fields):
                return message
        return None

    def found(
        self,
        rule: Rule,
        place: Place,
        claim: str,
        message: str,
        hint: str | None = None,
        related: Iterable[tuple[Place, str]] = (),
    ) -> Diagnostic:
        """A finding about ``claim``, the words by which a waiver knows it."""
        mark = fingerprint(rule.id, self.prose.path, claim)
        return Diagnostic(place, rule, message, hint, tuple(related), mark)


def read_document(text: str, path: str, reference: Reference) -> Reading:
    """The document of a text; places name the absolute form of ``path``."""
    path = os.path.abspath(path)
    prose = decoded("prose", text, path, lambda _: read_prose(text, path), Report())
    assert prose is not None  # every text is Markdown
    return read_parts(text, prose, reference)


def read_parts(text: str, prose: Prose, reference: Reference) -> Reading:
    """The same of a text whose Markdown has been read: ``prose``."""
    quoted = reduce(add, (quoted_definitions(code) for code in prose.code), Quoted())
    enums, messages = reference.dialect.enums, reference.dialect.messages
    if quoted.enums:  # else they stay the same object, about which much is found only once
        enums = {**enums, **{enum.name: enum for enum in quoted.enums}}
    proposed = tuple(wire_message(message, enums, {}, Report()) for message in quoted.messages if message.fields)
    if proposed:
        messages = {**messages, **{message.name: message for message in reversed(proposed)}}
    is_about_mavlink = _ABOUT.search(text) is not None or any(found[0] in messages for found in _SURE.finditer(text))
    is_about_mavlink |= any(found["name"] in messages for found in _CONSTANT.finditer(text))
    names = {name for name in messages if is_about_mavlink or "_" in name}
    names |= {found[0] for found in _WORD.finditer(text) if _is_told_by_fields(messages.get(found[0]), text)}
    mentions = {id(passage): tuple(_mentions(passage.text, names)) for passage in prose.passages}
    mentions.update(_of_headings(prose, messages, mentions))
    seen = [(message.definition.place.line, message.name) for message in proposed]
    for part in prose.parts:
        seen.extend(_sightings(part, names, mentions))
    if not seen and (alone := _only_by_fields(prose, messages, text)) is not None:
        seen = [(1, alone.name)]
    return Reading(
        prose=prose,
        reference=reference,
        quoted=quoted,
        proposed=proposed,
        messages=messages,
        enums=enums,
        mentions={key: found for key, found in mentions.items() if found},
        once={
            key: tuple(messages[name] for name in dict.fromkeys(each.name for each in reversed(found)))
            for key, found in mentions.items()
            if found
        },
        sightings=tuple(sorted(seen)),
        cited=frozenset(text.count("\n", 0, found.start()) + 1 for found in _CITED.finditer(text)),
    )


def _of_headings(
    prose: Prose, messages: Mapping[str, WireMessage], mentions: Mapping[int, tuple[Mention, ...]]
) -> Iterator[tuple[int, tuple[Mention, ...]]]:
    """The headings that name a message by the end of its name, where the document names others of its family."""
    named = [name.split("_") for name in {each.name for found in mentions.values() for each in found}]
    families = {"_".join(words[:end]) for words in named for end in range(_FAMILY, len(words))}
    for passage in prose.passages if families else ():
        if passage.kind is PassageKind.HEADING and not mentions[id(passage)] and _END.fullmatch(passage.text.strip()):
            end = passage.text.strip().upper().replace(" ", "_")
            name = next((name for family in families if (name := f"{family}_{end}") in messages), None)
            if name is not None:
                yield id(passage), (Mention(name, 0, len(passage.text)),)


_END = pattern(r"[A-Za-z]+(?: [A-Za-z]+){0,3}")
_FAMILY = 2
"""Words that names of messages share at the beginning, to be of a family."""


def _is_told_by_fields(message: WireMessage | None, text: str) -> bool:
    """Return whether a text has a field's name with an underscore: the message's name is no everyday word in it."""
    if message is None:
        return False
    return any("_" in field.name and f"`{field.name}`" in text for field in message.fields)


def _only_by_fields(prose: Prose, messages: Mapping[str, WireMessage], text: str) -> WireMessage | None:
    """The message that a document is about which names none: the only one that has all the fields which it names."""
    if not _FRAMED.search(text):
        return None
    spans = {part.text[low:high] for part in prose.passages for low, high in part.codes}
    called = {field.name for message in messages.values() for field in message.fields} & spans
    found = [each for each in messages.values() if len(called) >= _FEWEST and all(each.field(name) for name in called)]
    return found[0] if len(found) == 1 else None


def _mentions(text: str, names: Collection[str]) -> Iterator[Mention]:
    for found in _NAME.finditer(text):
        if found[0] in names:
            yield Mention(found[0], found.start(), found.end())


def _sightings(
    part: Passage | CodeBlock, names: Collection[str], mentions: Mapping[int, tuple[Mention, ...]]
) -> Iterator[tuple[int, str]]:
    if isinstance(part, Passage):
        for mention in mentions[id(part)]:
            yield part.place_at(mention.start).line, mention.name
        return
    for line in part.lines:
        for mention in _mentions(line.text, names):
            yield line.place.line, mention.name
        for found in _TYPE_NAME.finditer(line.text):
            spelled = next(group for group in found.groups() if group)
            name = snake(spelled).upper()
            if name in names:
                yield line.place.line, name


def snake(name: str) -> str:
    """Return a name in small letters with underscores, "gps_raw_int" for "GpsRawInt"."""
    return _CAMEL.sub(r"_\1", name).lower()


def parts_at(reading: Reading, line: int) -> Sequence[Passage | CodeBlock]:
    """Return the parts of a document that a line is in."""
    return _by_line(reading).get(line, ())


@once
def _by_line(reading: Reading) -> dict[int, list[Passage | CodeBlock]]:
    found: dict[int, list[Passage | CodeBlock]] = {}
    for part in reading.prose.parts:
        for line in range(part.place.line, part.last_line + 1):
            found.setdefault(line, []).append(part)
    return found


class _Located(Protocol):
    """A part of a passage that begins at an offset."""

    @property
    def start(self) -> int: ...


_Part = TypeVar("_Part", bound=_Located)


def between(parts: Sequence[_Part], start: int, end: int) -> Sequence[_Part]:
    """Those of ``parts``, in their order, that begin between two offsets."""
    low = bisect_left(parts, start, key=lambda part: part.start)
    return parts[low : bisect_left(parts, end, key=lambda part: part.start)]


def merged(findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    """The findings by place, those about the same claim as one at its first place, to which the others are related."""
    by_claim: dict[str, list[Diagnostic]] = {}
    for finding in sorted(findings, key=lambda finding: finding.place):
        by_claim.setdefault(finding.fingerprint or "", []).append(finding)
    told = []
    for first, *others in by_claim.values():
        again = list(dict.fromkeys(other.place for other in others if other.place != first.place))
        related = [(place, "stated again") for place in again[:_MOST_RELATED]]
        if len(again) > _MOST_RELATED:
            related[-1] = (related[-1][0], f"stated again, and {len(again) - _MOST_RELATED} times more below")
        told.append(replace(first, related=(*first.related, *related)))
    return told
