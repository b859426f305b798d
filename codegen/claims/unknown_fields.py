"""Names of fields that messages do not have, and that look like one that they have."""

import re
from collections.abc import Iterator, Sequence

from codegen.claims.about import Surroundings, message_about
from codegen.claims.known_names import SHORT, Names, is_of_field, near_fields, same_field
from codegen.claims.membership import is_among_fields, is_joined_to_fields, owner_of
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import is_aside
from codegen.claims.rules import NO_FIELD
from codegen.diagnostics import Diagnostic, did_you_mean
from codegen.load.prose import Passage, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern
from codegen.source import Place

_ELSE = pattern(
    r"\b(?:topic|param|parameter|variable|function|macro|attribute|argument|option|setting|file|method|class|constant"
    r"|signal|script|module|column|table|key)s?\s+$",
    re.IGNORECASE,
)
_IS_ELSE = pattern(
    r" is (?:an?|the|our) (?:[a-z]+ )?(?:topic|param|variable|function|macro|option|setting|file|method|class|script)"
)
_SNAKE = pattern(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)+")
_FIELD = pattern(r"\b(?:fields?|extensions?)\s+[`]?$", re.IGNORECASE)
_INTO = pattern(r"\b(?:in|into)\s+[`]?$", re.IGNORECASE)
_QUALIFIED = pattern(r"(?<![\w./])(?P<message>[A-Z][A-Z0-9_]{2,60})\.(?P<field>[a-z]\w{1,60})(?![\w(/.-])")
_FILES = frozenset(
    [
        "msg",
        "msgid",
        "id",
        "name",
        "payload",
        "md",
        "yaml",
        "yml",
        "py",
        "c",
        "h",
        "hpp",
        "cpp",
        "rs",
        "ts",
        "js",
        "json",
        "xml",
        "html",
        "txt",
        "csv",
    ]
)
_BEGINNING = pattern(r"[\s|*-]*(?P<name>[A-Za-z]\w{1,60})(?:\[\d*\])?(?=\s*(?:$|[|:(,=\u2013-]|and\b|or\b))")
_OF_FIELDS = pattern(r"\s*\|?\s*(?:field|name|member|variable|field name)s?\s*\|", re.IGNORECASE)


def first(passage: Passage) -> "re.Match[str] | None":
    """Match the name or words that a row or an item begins with; None where it begins with none."""
    return _BEGINNING.match(passage.text)


def fields(reading: Reading, passage: Passage, around: Surroundings, names: Names) -> Iterator[Diagnostic]:
    """Names in code spans that look like a field of the message that the passage is about."""
    for low, high in passage.codes:
        name = passage.text[low:high]
        owner = owner_of(passage.text, low, high, names)
        if name in names.fields and owner is None:
            yield from _called(reading, passage, around, (low, high))
            continue
        is_word = _SNAKE.fullmatch(name) is None
        message = owner or message_about(reading, passage, around, low, high)
        if message is None or message.field(name):
            continue
        is_end = is_word and _INTO.search(passage.text, max(low - 12, 0), low) and _is_end(name, message)
        is_listed = is_joined_to_fields(passage, low, high, message)
        if is_word and owner is None and not (is_end or is_listed or _is_meant(name, message)):
            continue
        if message is None or message.name in names.followed or _ELSE.search(passage.text, max(low - 12, 0), low):
            continue
        if _IS_ELSE.match(passage.text, high) or is_aside(passage.text[slice(*passage.sentence(low, high))].lower()):
            continue
        is_called = _FIELD.search(passage.text, max(low - 12, 0), low)
        if any(each in passage.text for each in same_field(name, message)) and owner is None:
            continue  # the other side of a mapping
        if passage.kind is PassageKind.ROW and owner is None and _is_mapped(passage.text, name, low, high, message):
            continue
        is_listed = is_listed or bool(is_end) or is_among_fields(passage, low, high, message)
        if near_fields(name, message) or (is_called and reading.named(passage)) or owner is not None or is_listed:
            yield no_field(reading, passage.place_at(low), message, name)


_CALLED = pattern(r"\b(?:is|are|was) (?:named|called) `?$|\bgoes by the name of `?$", re.IGNORECASE)
_NOT_CALLED = pattern(r"\b(?:not|in our|our|log|topic|there)\b", re.IGNORECASE)


def _called(reading: Reading, passage: Passage, around: Surroundings, span: tuple[int, int]) -> Iterator[Diagnostic]:
    """ "The time stamp is named `time_usec`" below the heading of a message that has no field of that name."""
    low, high = span
    start, end = passage.sentence(low, high)
    message = around.headings[0] if len(around.headings) == 1 and not reading.named(passage) else None
    name = passage.text[low:high]
    if message is None or message.field(name) is not None or not _CALLED.search(passage.text, start, low):
        return
    if not _NOT_CALLED.search(passage.text, start, end) and not is_aside(passage.text[start:end].lower()):
        yield no_field(reading, passage.place_at(low), message, name)


def _is_mapped(row: str, name: str, low: int, high: int, message: WireMessage) -> bool:
    """Return whether a row names the field elsewhere that a name is like: what somebody calls it."""
    rest = f"{row[:low]}|{row[high:]}"
    return any(re.search(rf"\b{re.escape(each)}\b", rest) is not None for each in near_fields(name, message))


def _is_meant(name: str, message: WireMessage) -> bool:
    """Return whether a plain word in a code span is another word for a field."""
    return name.isidentifier() and name.islower() and bool(same_field(name, message))


def _is_end(name: str, message: WireMessage) -> bool:
    """Return whether a word is the last one of the name of one field: `frame` of ``coordinate_frame``."""
    return sum(field.name.endswith(f"_{name}") for field in message.fields) == 1


def no_field(reading: Reading, place: Place, message: WireMessage, name: str) -> Diagnostic:
    text = f"{message.name} has no field {name}"
    hint = did_you_mean(name, [field.name for field in message.fields])
    return reading.found(NO_FIELD, place, f"{message.name} {name}", text, hint)


def qualified(reading: Reading, passage: Passage, names: Names) -> Iterator[Diagnostic]:
    """``MESSAGE.field`` of a known message that has no such field."""
    for found in _QUALIFIED.finditer(passage.text):
        message, name = names.messages.get(found["message"]), found["field"]
        if message is None or message.field(name) or name in _FILES or message.name in names.followed:
            continue
        if not is_aside(passage.text[slice(*passage.sentence(*found.span()))].lower()):
            yield no_field(reading, passage.place_at(found.start("field")), message, name)


def members(reading: Reading, passages: Sequence[Passage], around: Surroundings, names: Names) -> Iterator[Diagnostic]:
    """Rows and items of which most begin with fields of the message that the heading names: the others are none."""
    message = around.first
    begun = [(passage, found) for passage in passages if (found := first(passage)) and not found["name"].isupper()]
    own = [(passage, found) for passage, found in begun if message is not None and message.field(found["name"])]
    is_table = bool(passages) and _OF_FIELDS.match(passages[0].text) is not None
    if message is None or len(own) + is_table < 2 or not own or message.name in names.followed:
        return
    for passage, found in begun:
        name = found["name"]
        is_begun = any(field.name.startswith(f"{name}_") for field in message.fields)
        is_like = len(name) > SHORT and near_fields(name, message)
        is_odd = is_table and len(own) > 2 and 2 * len(own) > len(begun) and _SNAKE.fullmatch(name) is not None
        if is_of_field(name, [field.name for field in message.fields]):
            continue
        if name not in names.fields and (is_begun or is_like or is_odd):
            yield no_field(reading, passage.place_at(found.start("name")), message, name)
