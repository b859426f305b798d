"""Entries of an enum by words beside their numbers: "healthy 1, moving 4", "Yaw lock is 64", "axis 4 is steering".

Which enum that is, say the entries that the passage names in full, the field in front, or the most of a list: half of
it at least has to be right.
"""

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from codegen.claims.enum_names import enums_of_entries
from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import DENIED, MISTAKEN, PAST, SUPPOSED, words
from codegen.claims.rules import ENTRY_VALUE, as_sure
from codegen.claims.statements.fields import number, said_of_fields
from codegen.claims.statements.meaning import meaning
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import EnumDefinition
from codegen.pattern import pattern

_WORDS = r"(?!(?:and|or|but|with|to|from|of|as|at|which|that|so|then|per|is|than)\b)[a-zPC][a-zPC -]{1,36}?"
_LISTED = pattern(
    rf"(?:(?<=[:.,;(\u00b7] )|(?<=\()|(?<=\band )|(?<=\bor ))(?P<words>{_WORDS}) (?P<value>N)"
    r"(?=\s*(?:[,.;)]|$|and\b|or\b|\u00b7))"
)
_DOTTED = pattern(r"(?:(?<=[:\u00b7] )|^)(?P<value>N) (?P<words>[a-zPC][a-zPC -]{1,36}?)(?=\s*(?:\u00b7|\.(?:\s|$)|$))")
_ITEM = pattern(r"[\s*-]*(?P<words>[a-zPC][a-zPC -]{1,36}?),? (?P<value>N)\s*\.?\s*$")
_SAID = pattern(
    rf"(?:(?<=[.;,:] )|^|(?<=\band ))(?:the )?(?P<words>{_WORDS})(?:, which)? (?:is|has|=|equals)(?: the| value| bit)*"
    r" (?P<value>N)(?=\s*(?:[.;,)]|$|and\b))"
)
_END = pattern(r"(?P<words>C)(?:,? (?:which|that))?(?: \(| =| is| has(?: the)? value|:)+ ?(?P<value>N)\b")
"""The end of the name of an entry, "RTK_FIXED, which is 6"."""
_NUMBERED = pattern(
    r"(?P<name>P) (?P<value>N) (?:is|means|stands for|=|:)(?: the| for)? (?P<words>[a-z][a-z -]{1,30}?)"
    r"(?=\s*(?:[.;,)]|$))"
)
_RULED_OUT = words(DENIED[:2], PAST, MISTAKEN, SUPPOSED, r"\bour\b", r"\bown\b", r"\bversion\b", r"\bparam")
_FEWEST = 2
"""Right ones that make a list one of an enum."""

_Pair = tuple[int, str, Span, int]
"""A value, the words beside it, and where it stands."""


def check(reading: Reading, parts: Sequence[Span]) -> Iterator[Diagnostic]:
    """Every number of an entry that a document gives words for."""
    above: Span | None = None
    for is_list, run in groupby(parts, lambda span: span.kind is PassageKind.ITEM and not span.is_code):
        *_, last = all_of = list(run)
        spans = [span for span in all_of if "N" in span.text and not span.is_code]
        for span in spans:
            yield from _of_span(reading, span)
        if is_list and above is not None and len(spans) > _FEWEST:
            pairs = [pair for span in spans for pair in _pairs(_ITEM, span)]
            yield from _of_list(reading, pairs, [*_of_fields(reading, above), *_of_topic(reading, spans[0])])
        above = last


def _of_span(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    if span.kind is PassageKind.ROW or span.kind is PassageKind.HEADING:
        return
    is_list = span.text.count("N") > _FEWEST
    listed = _pairs(_DOTTED if "\u00b7" in span.text else _LISTED, span) if is_list else []
    if len(listed) > _FEWEST:
        yield from _of_list(reading, listed, [*_of_fields(reading, span), *_of_topic(reading, span)])
    if "V" in span.text:
        named = {str(term.value) for _, term in span.sentence.within(0, len(span.text), "V")}
        enums = {name for entry in named for name in enums_of_entries(reading.enums).get(entry, ())}
        if len(enums) == 1:
            yield from _compared(reading, reading.enums[enums.pop()], _pairs(_SAID, span))
    if "C" in span.text and (ends := _pairs(_END, span)):
        for own in [*_of_fields(reading, span)][:1]:
            yield from _compared(reading, own, ends)
    for found in _NUMBERED.finditer(span.text) if "P N" in span.text else ():
        one = about(reading, span, found.start("name"))
        enum = reading.enums.get(one.field.definition.enum or "") if one is not None else None
        if enum is not None and one is not None and all(each.definition.enum == enum.name for each in one.others):
            yield from _compared(reading, enum, _pairs(_NUMBERED, span))


def _pairs(form: "re.Pattern[str]", span: Span) -> list[_Pair]:
    found = []
    for each in form.finditer(span.text):
        value = number(span.sentence.term(each.start("value")))
        low, high = span.bounds(each.start("value"))
        if value is not None and value == int(value) and value >= 0 and not _RULED_OUT.search(span.text, low, high):
            said = span.source_text(each.start("words"), each.end("words"))
            found.append((int(value), said, span, each.start("value")))
    return found


def _of_fields(reading: Reading, span: Span) -> Iterator[EnumDefinition]:
    """The enums of the fields that a part names, the last one first."""
    for said in reversed(said_of_fields(span)):
        one = about(reading, span, said.names[-1])
        enum = reading.enums.get(one.field.definition.enum or "") if one is not None else None
        if enum is not None:
            yield enum


def _of_topic(reading: Reading, span: Span) -> Iterator[EnumDefinition]:
    """The enums of the fields of the messages that a part may be about."""
    own = [reading.messages[name] for _, name in span.named(0, len(span.text))]
    for message in (*own, *span.topic.around[:3]):
        for field in message.fields:
            if (enum := reading.enums.get(field.definition.enum or "")) is not None:
                yield enum


def _of_list(reading: Reading, pairs: Sequence[_Pair], enums: Sequence[EnumDefinition]) -> Iterator[Diagnostic]:
    """The wrong ones of a list, by the enum that it is right about in half of its lines or more."""
    for enum in enums if len(pairs) > _FEWEST else ():
        right = [pair for pair in pairs if meaning(enum).is_named(pair[0], pair[1])]
        if len(right) >= _FEWEST and 2 * len(right) >= len(pairs):
            yield from _compared(reading, enum, pairs)
            return


def _compared(reading: Reading, enum: EnumDefinition, pairs: Sequence[_Pair]) -> Iterator[Diagnostic]:
    known = meaning(enum)
    for value, said, span, at in pairs:
        meant = known.meant_otherwise(value, said)
        if meant is not None and known.is_sure(meant, said):
            text = f"{enum.name}: {meant.name} is {meant.value}, not {value}"
            claim = f"{enum.name} {value} {said.strip()}"
            yield reading.found(as_sure(ENTRY_VALUE, is_sure=False), span.place(at), claim, text)
