"""Which field of which message a place in a text is about, and how far what is said of it reaches."""

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence

from codegen.claims.reading import Mention, Reading, between
from codegen.frozen import dataclass
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.once import once

_NAME = re.compile(r"(?<![\w./\-])[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)*(?![\w(/-])(?:\[\d{0,3}\])?")
_QUALIFIED = re.compile(r"(?<![\w.])(?P<message>[A-Z][A-Z0-9_]{2,60})\.(?P<field>[a-z]\w{0,60})(?:\[\d{0,3}\])?")
_OF = re.compile(r"\s*(?:field )?(?:of|in|from|inside) (?:the |a |an )?(?P<message>[A-Z][A-Z0-9_]{2,60})\b")
_LEADS = re.compile(r"[\s|*>-]*(?:(?:the|field|fields|its) )?", re.IGNORECASE)
_JOINS = re.compile(r"\s*(?:,|and|or|&|/|,\s*and|to|\.\.\.?)\s*")
_LONGEST = 400
"""How far what is said of a field reaches, in characters."""


@dataclass(frozen=True, slots=True)
class Said:
    """What a passage says of a field: its name stands from ``start`` to ``end``, and what is said ends at ``until``.

    ``is_named``: the message is named beside it, or by the heading. ``is_joined``: it is one of several names.
    """

    message: WireMessage
    field: WireField
    passage: Passage
    start: int
    end: int
    until: int
    is_named: bool
    is_joined: bool = False

    @property
    def text(self) -> str:
        """What is said."""
        return self.passage.text[self.end : self.until]

    @property
    def name(self) -> str:
        """``MESSAGE.field``."""
        return f"{self.message.name}.{self.field.name}"


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The messages that the headings around a passage name, the nearest first, and those of its section before it."""

    headings: tuple[WireMessage, ...]
    earlier: tuple[WireMessage, ...]

    @property
    def first(self) -> WireMessage | None:
        """The message that the passage is about if it names none."""
        return next(iter((*self.headings, *self.earlier)), None)


@once
def surroundings(reading: Reading) -> tuple[tuple[Passage | CodeBlock, Surroundings], ...]:
    """Each part of a document with what stands around it."""
    return tuple(_surroundings(reading))


def _surroundings(reading: Reading) -> Iterator[tuple[Passage | CodeBlock, Surroundings]]:
    open_headings: list[tuple[int, tuple[WireMessage, ...]]] = []
    earlier: dict[str, WireMessage] = {}
    only = {name for _, name in reading.sightings}
    alone = (reading.messages[next(iter(only))],) if len(only) == 1 else ()
    for part in reading.prose.parts:
        if isinstance(part, Passage) and part.kind is PassageKind.HEADING:
            named = reading.named(part)
            open_headings = [each for each in open_headings if each[0] < part.level]
            open_headings.append((part.level, named if len(named) == 1 else ()))
            earlier = {}
        headings = tuple(message for _, named in reversed(open_headings) for message in named)
        others = () if earlier else alone
        yield part, Surroundings(headings, (*reversed(earlier.values()), *others))
        for message in reversed(reading.named(part)) if isinstance(part, Passage) else ():
            earlier.pop(message.name, None)
            earlier[message.name] = message


@once
def _field_names(reading: Reading) -> frozenset[str]:
    """The names of the fields of all messages."""
    return frozenset(field.name for message in reading.messages.values() for field in message.fields)


def said_of_fields(reading: Reading) -> Iterator[Said]:
    """Everything that passages say of fields, in order."""
    for part, around in surroundings(reading):
        if isinstance(part, Passage) and part.kind is not PassageKind.HEADING:
            yield from said_in(reading, part, around)


def said_in(reading: Reading, passage: Passage, around: Surroundings) -> Iterator[Said]:
    """What one passage says of fields."""
    found = list(_references(reading, passage, around))
    last_of = list(range(len(found)))  # by name the last one of its list of names
    for index in range(len(found) - 2, -1, -1):
        if _JOINS.fullmatch(passage.text, found[index][1], found[index + 1][0]):
            last_of[index] = last_of[index + 1]
    for index, (start, _, message, field, is_named) in enumerate(found):
        last = last_of[index]
        end = found[last][1]
        limit = found[last + 1][0] if last + 1 < len(found) else len(passage.text)
        until = max(min(_end_of(passage, end), limit, end + _LONGEST), end)
        yield Said(message, field, passage, start, end, until, is_named, is_joined=last != index)


_Reference = tuple[int, int, WireMessage, WireField, bool]


def _end_of(passage: Passage, end: int) -> int:
    """Where the sentence ends, or, for a name that is a paragraph's beginning alone, the next one."""
    if passage.kind is PassageKind.ROW:
        return len(passage.text)
    _, high = passage.sentence(end, end + 1)
    return high


def _references(reading: Reading, passage: Passage, around: Surroundings) -> Iterator[_Reference]:
    """The names of fields in a passage, each with its message."""
    mentions = reading.mentioned(passage)
    qualified = {found.start("field"): found for found in _QUALIFIED.finditer(passage.text)}
    for found in qualified.values():
        message = reading.messages.get(found["message"])
        field = message.field(found["field"]) if message else None
        if message is not None and field is not None:
            yield found.start(), found.end(), message, field, True
    starts = sorted(qualified)
    leads = _LEADS.match(passage.text)
    first = leads.end() if leads else 0
    is_list = passage.kind in (PassageKind.ITEM, PassageKind.ROW)
    names = _field_names(reading)
    for found in _NAME.finditer(passage.text):
        name = found[0].partition("[")[0]
        if name not in names:
            continue
        if _is_beside(passage, starts, found.start(), found.end()):
            continue  # who writes MESSAGE.field in a sentence means something else by a bare word
        code = bisect_right(passage.codes, (found.start(), len(passage.text))) - 1
        is_code = code >= 0 and found.end() <= passage.codes[code][1]
        if not is_code and (name[0].isupper() or "_" not in name) and not (is_list and found.start() == first):
            continue
        resolved = _message_of(reading, passage, mentions, around, name, found.start(), found.end())
        if resolved is not None:
            message, is_named = resolved
            field = message.field(name)
            if field is not None:
                of = _OF.match(passage.text, found.end())
                end = of.end() if of is not None and of["message"] == message.name else found.end()
                yield found.start(), end, message, field, is_named


def _is_beside(passage: Passage, starts: Sequence[int], start: int, end: int) -> bool:
    """Whether one of some places is in the sentence of another."""
    if not starts:
        return False
    low, high = passage.sentence(start, end)
    place = bisect_right(starts, low)
    return (place > 0 and starts[place - 1] == low) or (place < len(starts) and starts[place] < high)


def _message_of(
    reading: Reading,
    passage: Passage,
    mentions: Sequence[Mention],
    around: Surroundings,
    name: str,
    start: int,
    end: int,
) -> tuple[WireMessage, bool] | None:
    """The message that a name of a field belongs to: the one beside it, that of the heading, that of the section."""
    of = _OF.match(passage.text, end)
    if of is not None and of["message"] in reading.messages:
        message = reading.messages[of["message"]]
        return (message, True) if message.field(name) else None
    low, high = passage.sentence(start, end)
    beside = [reading.messages[each.name] for each in between(mentions, low, high)]
    before = [reading.messages[each.name] for each in between(mentions, low, start)]
    for message in reversed(before):
        if message.field(name):
            return message, len({each.name for each in beside}) == 1
    inside = reading.named(passage)
    for message in (*around.headings[:1], *beside, *inside):
        if message.field(name):
            return message, True
    if inside and not around.headings:
        return None
    for message in (*around.headings, *around.earlier):
        if message.field(name):
            return message, message in around.headings or len(around.earlier) == 1
    return None
