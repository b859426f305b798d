"""Values that sentences and lists name for a field: entries of its enum, and what stands for unknown."""

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from codegen.claims.about import Said, Surroundings, said_in, surroundings
from codegen.claims.enum_words import entry_claim, is_entry
from codegen.claims.field_notes import field_notes
from codegen.claims.identifier import ENTRY_VALUE
from codegen.claims.reading import Reading
from codegen.claims.sentinel import SENTINEL
from codegen.claims.unknown_value import number_of, unknown_values
from codegen.diagnostics import Diagnostic
from codegen.load.prose import Passage, PassageKind
from codegen.model.dialect.dialect import EnumDefinition, WireMessage
from codegen.model.dialect.literals import same_number

ENTRY = re.compile(
    r"(?<![\w.\-+])(?P<value>\d{1,3})\s*(?:=|:|\(|\u2013|-)?\s*"
    r"(?P<words>(?:(?:is|are|for|means|an?|the) )*(?:\dD )?[A-Za-z][A-Za-z0-9 /-]{1,44}?(?: \([a-z ]{3,20}\))?)"
    r"\)?(?=\s*(?:[,.;:|)]|\*/|$| and \d| or \d))"
)
_NAMED = re.compile(r"(?<![\w.])(?P<value>\d{1,3})\s*\((?P<name>[A-Z][A-Z0-9_]{3,80})\)")
_ITEM = re.compile(
    r"\s*(?P<value>\d{1,3})\s*(?:=|:|\u2013|-)?\s*(?P<words>(?:\dD )?[A-Za-z][A-Za-z0-9 ()/-]{1,44}?)\s*$"
)
_WORDS_FIRST = re.compile(
    r"(?P<words>(?:\dD )?[A-Za-z][A-Za-z-]{1,20}(?: [A-Za-z-]{1,20}){0,2}) ?(?:[(=:]|is) ?(?P<value>\d{1,3})"
    r"(?=\s*(?:[),.;]|$))"
)
_ROW = re.compile(r"[\s|]*(?P<value>\d{1,3})\s*\|\s*(?P<words>(?:\dD )?[A-Za-z][A-Za-z0-9 ()/-]{1,44}?)\s*(?:\||$)")
_FIRST = re.compile(r"[\s:]*(?P<value>\d{1,3}), (?P<words>(?:\dD )?[A-Za-z][A-Za-z0-9 /-]{1,44}?)\s*$")
_TURNED = re.compile(r"[\s|]*(?P<words>(?:\dD )?[A-Za-z][A-Za-z0-9 ()/-]{1,44}?)\s*\|\s*(?P<value>\d{1,3})\s*(?:\||$)")
_ENUM_NAME = re.compile(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+")
_FEWEST = 2
"""Values that have to be right before another one is wrong, where no field is named."""
_VALUE = r"(?P<value>U?INT(?:8|16|32|64)_M(?:AX|IN)|NaN|0x[fF]{2,16}|(?<![\w.+-])-?\d{1,6}(?![\w.]|,\d))"
_UNKNOWN = re.compile(
    rf"{_VALUE}\s*[\[(]?\s*(?:=|:|if|when|where|for|is|means|stands for|marks|says)?\s*(?:an? |the )?"
    r"(?:it |value |field |current |this )?"
    r"(?:is |are |there is )?(?P<words>unknown|unavailable|invalid"
    r"|no [a-z]{2,15} is (?:present|there|available|connected)|no (?:estimate|data|value|measurement|reading|sensor)"
    r"|not (?:known|provided|available|measured|valid|there|used|set))\b",
    re.IGNORECASE,
)
_AFTER = re.compile(rf"\b(?:unknown|invalid)(?: is|:| =|=| as)\s*{_VALUE}", re.IGNORECASE)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every value that is said of a field; runs of items and rows are looked at together with what stands above."""
    yield from _members(reading)
    above: Passage | None = None
    said: list[Said] = []
    around = Surroundings((), ())
    for kind, run in groupby(surroundings(reading), lambda each: getattr(each[0], "kind", None)):
        parts = list(run)
        passages = [part for part, _ in parts if isinstance(part, Passage)]
        if kind in (PassageKind.ITEM, PassageKind.ROW) and above is not None:
            yield from _below(reading, passages, _subject(reading, above, said, passages, around))
        for part, around in parts:
            if not isinstance(part, Passage) or part.kind is PassageKind.ROW:
                above, said = None, []
                continue
            above, said = part, list(said_in(reading, part, around))
            for each in said:
                yield from _entries(reading, each)
                yield from _sentinels(reading, each)
            if not any(_enum_of(reading, each) for each in said):
                yield from _unnamed(reading, part)


def _members(reading: Reading) -> Iterator[Diagnostic]:
    """Comments beside the members of a struct."""
    for notes in field_notes(reading):
        for note, field in notes.pairs():
            enum = reading.enums.get(field.definition.enum or "") if note.type is not None else None
            for found in ENTRY.finditer(note.passage.text, note.start) if enum else ():
                if enum is not None:
                    yield from entry_claim(reading, f"{notes.message.name}.{field.name}", enum, note.passage, found)


_Subject = tuple[str, EnumDefinition]
"""What values are said of, and its enum."""


def _enum_of(reading: Reading, said: Said) -> EnumDefinition | None:
    return reading.enums.get(said.field.definition.enum or "")


def _of_message(reading: Reading, message: WireMessage) -> list[_Subject]:
    """The fields of a message that have an enum."""
    found = [
        (f"{message.name}.{field.name}", reading.enums.get(field.definition.enum or "")) for field in message.fields
    ]
    return [(name, enum) for name, enum in found if enum is not None]


def _subject(
    reading: Reading, above: Passage, said: Sequence[Said], passages: Sequence[Passage], around: Surroundings
) -> _Subject | None:
    """What a list or a table tells the values of: the field above it, the enum of the heading, or a message's field."""
    named = next((each for each in reversed(said) if _enum_of(reading, each) is not None), None)
    if named is not None:
        enum = _enum_of(reading, named)
        return None if enum is None else (named.name, enum)
    enums = [reading.enums[word] for word in _ENUM_NAME.findall(above.text) if word in reading.enums]
    if enums:
        return enums[0].name, enums[0]
    if above.kind is PassageKind.HEADING or above.text.rstrip().endswith(":"):
        messages = reading.named(above)[:1] or around.headings[:1]
        pairs = [found for passage in passages if (found := _pair(passage)) is not None]
        return _most_right([each for message in messages for each in _of_message(reading, message)], pairs)
    return None


def _below(reading: Reading, passages: Sequence[Passage], subject: _Subject | None) -> Iterator[Diagnostic]:
    """A list or a table of values and words."""
    for passage in passages if subject else ():
        found = _pair(passage)
        if found is not None and subject is not None:
            yield from entry_claim(reading, *subject, passage, found)


def _pair(passage: Passage) -> "re.Match[str] | None":
    if passage.kind is PassageKind.ITEM:
        return _ITEM.match(passage.text)
    return _ROW.match(passage.text) or _TURNED.match(passage.text)


def _most_right(subjects: Sequence[_Subject], pairs: "Sequence[re.Match[str]]") -> _Subject | None:
    """The enum that most pairs are right about: half of them at least, and two."""
    for subject in subjects:
        right = sum(is_entry(subject[1], found["words"], int(found["value"])) for found in pairs)
        if right >= _FEWEST and 2 * right >= len(pairs):
            return subject
    return None


def _unnamed(reading: Reading, passage: Passage) -> Iterator[Diagnostic]:
    """ "NAME answers 0 (accepted), 1 (denied)": values of a field that the sentence does not name."""
    messages = reading.named(passage)
    pairs = list(ENTRY.finditer(passage.text)) if len(messages) == 1 else []
    subject = _most_right(_of_message(reading, messages[0]), pairs) if len(pairs) > _FEWEST else None
    for found in pairs if subject else ():
        if subject is not None:
            yield from entry_claim(reading, *subject, passage, found)


def _entries(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    enum = _enum_of(reading, said)
    if enum is None:
        return
    for found in _NAMED.finditer(said.passage.text, said.end, said.until):
        named = enum.entry(found["name"])
        if named is not None and named.value != int(found["value"]):
            text = f"{said.name}: {named.name} is {named.value}, not {found['value']}"
            place = said.passage.place_at(found.start("value"))
            yield reading.found(ENTRY_VALUE, place, f"{said.name} {found[0]}", text)
    first = _FIRST.match(said.passage.text, said.end, said.until)
    if first is not None:
        yield from entry_claim(reading, said.name, enum, said.passage, first)
    for form in (ENTRY, _WORDS_FIRST):
        for found in form.finditer(said.passage.text, said.end, said.until):
            yield from entry_claim(reading, said.name, enum, said.passage, found)


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
