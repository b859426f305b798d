"""Types of fields that are only described: "the altitude is an int16_t", "current in cA, each as int16_t".

The words are those of the field's name; its message is the one that the sentence is about. Every field of the message
that these words may mean has to have another type.
"""

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from codegen.claims.layout import typed
from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import (
    ASKED,
    CHANGED,
    COMPARED,
    DENIED,
    MISTAKEN,
    OWN,
    PAST,
    PROPOSED,
    REPLACED,
    SUPPOSED,
    TEMPORARY,
    words,
)
from codegen.claims.rules import TYPE, as_sure
from codegen.claims.statements.fields import stated_type
from codegen.claims.statements.nouns import IDLE, OF_ELSE, is_like
from codegen.claims.statements.subjects import about, subjects
from codegen.claims.statements.types import has_type
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.pattern import pattern

_IS = pattern(
    r"(?P<noun>(?:[a-zP][a-zP-]{1,24} ){0,2}(?:[a-z][a-z-]{2,24}|P))(?: (?:values?|fields?|counters?|readings?"
    r"|numbers?))?"
    r"(?: (?:of|in) M)?(?:,? (?:is|are|comes?|goes|travels?|arrives?|as|an?|in|sent|the|which|that|each|all|only"
    r"|just|whole|full"
    r"|U|arrays? of|given|reported|again|here|just|one|too|also|both|on the wire))+ (?P<type>T)\b(?!,? (?:or|and) T)"
)
_LINKED = pattern(r"\b(?:is|are|comes?|goes|travels?|arrives?|as|in an?|each)\b[^.;]*$")
_NOT = words(
    DENIED, REPLACED, PAST, CHANGED[:2], MISTAKEN, SUPPOSED, COMPARED, OWN, TEMPORARY[:1], ASKED, PROPOSED,
    r"\bcast", r"\bconvert", r"\bcopied\b", r"\bread\b", r"\bfrom\b", r"\bparam", r"\bfile\b", r"\bcolumn",
    r"\bfirmware\b",
    r"\bsensor", r"\bdriver", r"\bregister", r"\bstor", r"\bkeep", r"\bkept\b", r"\bvariable", r"\bserial\b",
    r"\blogs?\b",
    r"\bwhere(?:as)?\b", r"\bwhile\b", r"\bif\b", r"\bwhen\b", r"\binternal", r"\bsum\b", r"\bdatabase\b",
)  # fmt: skip
_CONTRAST = 80
"""Characters before a sentence in which the field's own type is told, so that another one is of another thing."""
_BEHIND = 20
"""Characters behind a type in which a word can still rule it out."""
_MOST_WORDS = 3
"""The last words before a type that can be the name of a field."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every type that a part states of what it only describes."""
    if span.kind is PassageKind.ROW or span.is_code:
        return
    for found in _IS.finditer(span.text):
        low, high = span.bounds(found.start())
        at = found.start("type")
        gap = span.text[found.end("noun") : at]
        if (
            not _LINKED.search(gap)
            or _BUT.search(found["noun"])
            or _NOT.search(span.text, low, min(high, at + _BEHIND))
            or OF_ELSE.search(span.text, low, high)
        ):
            continue
        if "F" in span.text[_clause(span.text, low, found.start()) : at]:
            continue
        if _PRONOUN.search(found["noun"]):
            yield from _told_before(reading, span, found.start(), at)
            continue
        messages, is_sure = subjects(reading, span, found.start())
        noun = span.source_text(*found.span("noun")).lower()
        words_of = [word for word in pattern(r"[a-z]+").findall(noun) if word not in IDLE]
        stated = stated_type(span.sentence.term(at))
        meant = _called(messages[:1], words_of)
        if stated.length is not None and not any(field.is_array for field in meant):
            stated = replace(stated, length=None)  # "three int32" are as many fields
        told = (stated_type(term) for _, term in span.sentence.within(max(low - _CONTRAST, 0), at, "T"))
        if any(has_type(field, each) for each in told for field in meant):
            continue  # its own type is told before that of another one
        if not meant or not is_sure or any(has_type(field, stated) for field in _called(messages, words_of)):
            continue
        name, written = f"{messages[0].name}.{meant[0].name}", span.sentence.term(at).written
        text = f"{name} is {typed(meant[0].definition)}, not {written}"
        yield reading.found(as_sure(TYPE, is_sure=False), span.place(at), f"{name} {written}", text)


_BUT = pattern(r"\b(?:but|except|save)\b")
"""Within what is described: "all fields but the health are floats"."""
_PRONOUN = pattern(
    r"(?:^|\b(?:and|but|so|because|since|as) )(?:it|that|this|the field|the value|the number|the counter)$"
)
_FAR = 200
"""Characters before a pronoun in which the field that it may mean is named."""


def _told_before(reading: Reading, span: Span, offset: int, at: int) -> Iterator[Diagnostic]:
    """Yield what is wrong in "that is a 16-bit counter", where all fields named before it have another type."""
    named = [about(reading, span, name) for name, _ in span.sentence.within(max(offset - _FAR, 0), offset, "F")]
    own = [each for each in named if each is not None]
    names = [term.letter for _, term in span.sentence.within(max(offset - _FAR, 0), offset, "FMC")]
    if names[-1:] != ["F"]:
        return
    stated = stated_type(span.sentence.term(at))
    if own and all(each.is_wrong(partial(has_type, stated=stated)) for each in own):
        one, written = own[-1], span.sentence.term(at).written
        text = f"{one.name} is {typed(one.field.definition)}, not {written}"
        yield reading.found(as_sure(TYPE, is_sure=False), span.place(at), f"{one.name} {written}", text)


def _clause(text: str, low: int, high: int) -> int:
    """Return the offset at which the clause before an offset begins."""
    return max(text.rfind(";", low, high), text.rfind(":", low, high), text.rfind(", ", low, high), low)


def _called(messages: tuple[WireMessage, ...], words_of: list[str]) -> list[WireField]:
    """The fields whose names have the last words before a type, as many of them as any name has."""
    fields = [field for message in messages for field in message.fields]
    for count in range(min(len(words_of), _MOST_WORDS), 0, -1):
        own = [field for field in fields if _has_words(field, words_of[-count:])]
        if own and (count == len(words_of) or all(_is_made_of(field, words_of) for field in own)):
            return own
    return []


def _is_made_of(field: WireField, words_of: list[str]) -> bool:
    """Return whether all words of a field's name are among some words."""
    return all(any(is_like(word, token) for word in words_of) for token in re.findall(r"[a-z]+", field.name.lower()))


def _has_words(field: WireField, words_of: list[str]) -> bool:
    tokens = pattern(r"[a-z]+").findall(field.name.lower().replace("_", " "))
    return all(any(is_like(word, token) for token in tokens) for word in words_of)
