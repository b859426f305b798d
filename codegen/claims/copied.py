"""Findings in text that the dialect itself has: a description that was copied is none of the document's own claims.

Generated libraries, and pages made of the XML, have the descriptions of all fields word by word. Such a sentence says
of other fields, of parts of an array and of older versions what the dialect says of them, and is right by definition.
"""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from codegen.claims.reading import Reading, parts_at
from codegen.diagnostics import Diagnostic
from codegen.load.prose import CodeBlock, Passage
from codegen.model.dialect.dialect import Dialect
from codegen.once import once
from codegen.pattern import pattern
from codegen.source import Place

_WORD = pattern(r"-?\w+")
_END = pattern(r"(?<=[.;!?])\s+")
_FIRST = 3
"""Words by which a sentence is found, and the fewest of a whole description of a field."""
_FEWEST = 5
"""Words of any other sentence: "0 if unknown" and "16-bit unsigned integer" may be said of anything."""
_XML = ("xml", "html")
"""Languages of definitions, which state attributes beside their descriptions: whether these agree is a claim."""

_Words = tuple[str, ...]


class _Text(NamedTuple):
    """The words of a part of a document, and where each of them begins and ends: a line and a column."""

    words: _Words
    places: tuple[tuple[int, int], ...]


def is_copied(reading: Reading, finding: Diagnostic) -> bool:
    """Return whether a finding is within a sentence of a description in the dialect, word by word."""
    place = finding.place
    return any(
        _is_within(reading.reference.dialect, _text_of(part), place)
        for part in parts_at(reading, place.line)
        if isinstance(part, Passage) or part.language not in _XML
    )


def _is_within(dialect: Dialect, text: _Text, place: Place) -> bool:
    line = slice(bisect_left(text.places, (place.line, 0)), bisect_left(text.places, (place.line + 1, 0)))
    if text.words[line] in _whole(dialect):
        return True
    at = bisect_right(text.places, (place.line, place.column)) - 1
    sentences = _sentences(dialect)
    return any(
        start + len(sentence) > at and text.words[start : start + len(sentence)] == sentence
        for start in range(max(0, at + 1 - _longest(dialect)), at + 1)
        for sentence in sentences.get(text.words[start : start + _FIRST], ())
    )


@once
def _text_of(part: Passage | CodeBlock) -> _Text:
    if isinstance(part, Passage):
        found = [(each[0], part.place_at(each.start())[1:]) for each in _WORD.finditer(part.text)]
    else:
        found = [
            (each[0], (line.place.line, line.place.column + each.start()))
            for line in part.lines
            for each in _WORD.finditer(line.text)
        ]
    return _Text(tuple(word for word, _ in found), tuple(at for _, at in found))


@once
def _spoken(dialect: Dialect) -> Mapping[str, _Words]:
    """Return the words of each description."""
    return {text: tuple(_WORD.findall(text)) for text in _descriptions(dialect)}


@once
def _sentences(dialect: Dialect) -> Mapping[_Words, tuple[_Words, ...]]:
    """Return the sentences of all descriptions, and the whole ones of fields, by their first words."""
    found: dict[_Words, set[_Words]] = defaultdict(set)
    of_fields = {field.definition.description for message in dialect.messages.values() for field in message.fields}
    for text, spoken in _spoken(dialect).items():
        if len(spoken) >= (_FIRST if text in of_fields else _FEWEST):
            found[spoken[:_FIRST]].add(spoken)
        parts = _END.split(text)
        for sentence in (tuple(_WORD.findall(part)) for part in parts) if len(parts) > 1 else ():
            if len(sentence) >= _FEWEST:
                found[sentence[:_FIRST]].add(sentence)
    return {first: tuple(those) for first, those in found.items()}


@once
def _longest(dialect: Dialect) -> int:
    """Return the number of words of the longest sentence."""
    return max((len(words) for those in _sentences(dialect).values() for words in those), default=0)


@once
def _whole(dialect: Dialect) -> frozenset[_Words]:
    """Return the words of each description that is of two or more, which may be all of a comment: "/// Servo 16"."""
    return frozenset(words for words in _spoken(dialect).values() if len(words) > 1)


def _descriptions(dialect: Dialect) -> Iterator[str]:
    """Yield the descriptions of messages, fields, enums, entries and parameters; some of them more than once."""
    for message in dialect.messages.values():
        yield message.definition.description
        yield from (field.definition.description for field in message.fields)
    for enum in dialect.enums.values():
        yield enum.description
        for entry in enum.entries:
            yield entry.description
            yield from (parameter.description for parameter in entry.parameters)
