"""Values that sentences and lists name for a field: entries of its enum, and what stands for unknown."""

import re
from collections.abc import Iterator

from codegen.claims.about import Said, said_in, surroundings
from codegen.claims.identifier import ENTRY_VALUE
from codegen.claims.reading import Reading
from codegen.claims.sentinel import SENTINEL
from codegen.claims.unknown_value import number_of, unknown_values
from codegen.diagnostics import Diagnostic
from codegen.load.prose import Passage, PassageKind
from codegen.model.dialect import EnumDefinition
from codegen.model.literals import same_number

_ENTRY = re.compile(
    r"(?<![\w.\-+])(?P<value>\d{1,3})\s*(?:=|:|\(|\u2013|-)?\s*"
    r"(?P<words>(?:(?:is|are|for|means|an?|the) )*(?:\dD )?[A-Za-z][A-Za-z0-9 /-]{1,44}?(?: \([a-z ]{3,20}\))?)"
    r"\)?(?=\s*(?:[,.;:|)]|$| and \d| or \d))"
)
_NAMED = re.compile(r"(?<![\w.])(?P<value>\d{1,3})\s*\((?P<name>[A-Z][A-Z0-9_]{3,80})\)")
_ITEM = re.compile(
    r"\s*(?P<value>\d{1,3})\s*(?:=|:|\u2013|-)?\s*(?P<words>(?:\dD )?[A-Za-z][A-Za-z0-9 ()/-]{1,44}?)\s*$"
)
_IDLE = frozenset(
    [
        "a",
        "an",
        "the",
        "is",
        "are",
        "for",
        "means",
        "of",
        "to",
        "mode",
        "state",
        "type",
        "and",
        "value",
        "it",
        "in",
        "on",
        "if",
    ]
)
_UNITS = frozenset(
    [
        "hz",
        "m",
        "cm",
        "mm",
        "s",
        "ms",
        "us",
        "v",
        "mv",
        "a",
        "ma",
        "deg",
        "bytes",
        "byte",
        "bits",
        "times",
        "fields",
        "elements",
        "entries",
        "values",
    ]
)
_WORD = re.compile(r"[a-z0-9]+")
_VALUE = r"(?P<value>U?INT(?:8|16|32|64)_M(?:AX|IN)|NaN|0x[fF]{2,16}|(?<![\w.+-])-?\d{1,6}(?![\w.]|,\d))"
_UNKNOWN = re.compile(
    rf"{_VALUE}\s*[\[(]?\s*(?:=|:|if|when|where|for|is|means|stands for|marks|says)?\s*(?:an? |the )?"
    r"(?:it |value |field |current |this )?"
    r"(?:is |are |there is )?(?P<words>unknown|unavailable|invalid"
    r"|no (?:estimate|data|value|measurement|reading|sensor)|not (?:known|provided|available|measured|valid|there|used|set))\b",
    re.IGNORECASE,
)
_AFTER = re.compile(rf"\b(?:unknown|invalid)(?: is|:| =|=| as)\s*{_VALUE}", re.IGNORECASE)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every value that is said of a field, and those of lists that begin below a sentence about one."""
    listed: Said | None = None
    for part, around in surroundings(reading):
        if not isinstance(part, Passage) or part.kind in (PassageKind.HEADING, PassageKind.ROW):
            listed = None
            continue
        said = list(said_in(reading, part, around))
        if part.kind is PassageKind.ITEM and not said and listed is not None:
            yield from _items(reading, listed, part)
            continue
        listed = _introduced(part, said)
        for each in said:
            yield from _entries(reading, each)
            yield from _sentinels(reading, each)


def _introduced(passage: Passage, said: list[Said]) -> Said | None:
    """The field with an enum whose values are listed below a passage that ends with a colon."""
    if not passage.text.rstrip().endswith(":"):
        return None
    return next((each for each in reversed(said) if each.field.definition.enum), None)


def _enum_of(reading: Reading, said: Said) -> EnumDefinition | None:
    return reading.enums.get(said.field.definition.enum or "")


def _items(reading: Reading, said: Said, passage: Passage) -> Iterator[Diagnostic]:
    found = _ITEM.match(passage.text)
    enum = _enum_of(reading, said)
    if found is not None and enum is not None:
        yield from _entry(reading, said, passage, found, enum)


def _entries(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    enum = _enum_of(reading, said)
    for found in _NAMED.finditer(said.passage.text, said.end, said.until) if enum else ():
        named = enum.entry(found["name"]) if enum else None
        if named is not None and named.value != int(found["value"]):
            text = f"{said.name}: {named.name} is {named.value}, not {found['value']}"
            place = said.passage.place_at(found.start("value"))
            yield reading.found(ENTRY_VALUE, place, f"{said.name} {found[0]}", text)
    for found in _ENTRY.finditer(said.passage.text, said.end, said.until) if enum else ():
        if enum is not None:
            yield from _entry(reading, said, said.passage, found, enum)


def _entry(
    reading: Reading, said: Said, passage: Passage, found: "re.Match[str]", enum: EnumDefinition
) -> Iterator[Diagnostic]:
    words = [word for word in _WORD.findall(found["words"].lower()) if word not in _IDLE]
    if not words or set(words) & _UNITS:
        return
    stated = int(found["value"])
    tokens = _tokens(enum)
    at = next((entry for entry in enum.entries if entry.value == stated), None)
    meant = [entry for entry in enum.entries if words == tokens[entry.name]]
    is_exact = bool(meant)
    meant = meant or [entry for entry in enum.entries if _are_same(words, tokens[entry.name])]
    meant = meant or [entry for entry in enum.entries if _holds(tokens[entry.name], words)]
    if len(meant) != 1 or meant[0].value == stated:
        return
    if not is_exact and at is not None and _overlaps(words, tokens[at.name]):
        return  # another wording of the right one
    text = f"{meant[0].name} is {meant[0].value}, not {stated}"
    hint = f"{stated} is {at.name}" if at else None
    place = passage.place_at(found.start("value"))
    yield reading.found(ENTRY_VALUE, place, f"{said.name} {found[0].strip()}", f"{said.name}: {text}", hint)


def _tokens(enum: EnumDefinition) -> dict[str, list[str]]:
    """The words of each entry's name, without those that all of them begin with."""
    split = {entry.name: entry.name.lower().split("_") for entry in enum.entries}
    shared = 0
    while len({tuple(words[: shared + 1]) for words in split.values() if len(words) > shared + 1}) == 1 and all(
        len(words) > shared + 1 for words in split.values()
    ):
        shared += 1
    return {name: [word for word in words[shared:] if word not in _IDLE] for name, words in split.items()}


def _holds(tokens: list[str], words: list[str]) -> bool:
    """Whether a name has all the words and one more, such as the kind of thing that it is."""
    return len(tokens) == len(words) + 1 and all(any(_is_like(word, token) for token in tokens) for word in words)


def _are_same(words: list[str], tokens: list[str]) -> bool:
    """Whether the words are those of a name, in any order, shortened or not."""
    if len(words) != len(tokens):
        return False
    left = list(tokens)
    for word in words:
        same = next((token for token in left if _is_like(word, token)), None)
        if same is None:
            return False
        left.remove(same)
    return True


def _is_like(word: str, token: str) -> bool:
    short, long = sorted((word, token), key=len)
    return short == long or (len(short) > 2 and long.startswith(short))


def _overlaps(words: list[str], tokens: list[str]) -> bool:
    return any(_is_like(word, token) for word in words for token in tokens)


def _sentinels(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """The first value that is wrong, if none of those that are named is right."""
    known = unknown_values(said.field)
    if known is None:
        return
    values, written = known
    found = [*_UNKNOWN.finditer(said.passage.text, said.end, said.until)]
    found += _AFTER.finditer(said.passage.text, said.end, said.until)
    stated = [(each, number_of(each["value"])) for each in found]
    if any(value is not None and same_number(value, each) for _, value in stated for each in values):
        return
    for each, value in stated[:1]:
        if value is None or (value == 0 and said.field.definition.enum):
            continue
        text = f"{said.name} is unknown when it is {written}, not {each['value']}"
        yield reading.found(SENTINEL, said.passage.place_at(each.start("value")), f"{said.name} {each['value']}", text)
