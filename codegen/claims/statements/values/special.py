"""Values with a meaning of their own, as descriptions tell them in passing: "255 for all LEDs", "zero for end of log".

A document that gives the same meaning to another value is compared by the words of the meaning.
"""

import math
from collections.abc import Iterator
from functools import cache

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, DENIED, MISTAKEN, OWN, PAST, REPLACED, SHOWN, SUPPOSED, words
from codegen.claims.rules import SENTINEL, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.subjects import about
from codegen.claims.unknown_value import number_of
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_MEANS = r"(?:indicates?|means?|is|are|for|if|when|to|marks?|:|=|stands? for|signals?|disables?|denotes?)"
_TOLD = pattern(
    rf"(?<![\w.\[-])(?P<value>-?\d+|zero|U?INT\d+_MAX|NaN)(?: value)? ?,? ?{_MEANS} "
    r"(?P<words>[A-Za-z][A-Za-z _'-]{2,60})"
)
_SAID = pattern(
    r"(?<![*/+\u00d7] )(?P<value>[NS])(?: value)? ?,? ?(?:(?:(?:which|that) )?(?:means?|meaning|is|are|for|if|when|to"
    r"|marks?|:|=|stands? for|signals?|indicates?|denotes?|tells(?: that)?) ?)+(?P<words>[a-zFPM][a-zFPM _'-]{2,60})"
)
_IDLE = frozenset((
    "the", "a", "an", "is", "are", "be", "to", "of", "for", "if", "no", "not", "this", "that", "it", "in", "on", "by",
    "as", "with", "and", "or", "field", "value", "use", "used", "set", "when", "will", "was", "have", "has", "from",
    "at", "its", "should", "must", "can", "any", "other", "first", "one", "only", "message", "current", "unknown",
    "available", "known", "invalid", "unused", "provided", "supported", "default", "mode", "valid", "number", "data",
))  # fmt: skip
_RULED_OUT = words(DENIED, REPLACED, PAST, OWN[:3], MISTAKEN, ASKED, SHOWN, SUPPOSED, r"\bonly\b", r"\bversion\b")
_WORD = pattern(r"[a-z]+")


@dataclass(frozen=True, slots=True)
class Special:
    """A value of a field with the words for what it means."""

    value: float
    written: str
    told: str
    words: frozenset[str]


@cache
def specials(description: str) -> tuple[Special, ...]:
    """Return the values that a description gives a meaning of its own."""
    found = []
    for each in _TOLD.finditer(description):
        value = 0 if each["value"] == "zero" else number_of(each["value"])
        meant = content(each["words"])
        if value is not None and meant:
            found.append(Special(float(value), each["value"], each["words"].strip(), meant))
    return tuple(found)


def content(text: str) -> frozenset[str]:
    """Return the words of a meaning, without those that are everywhere and without endings."""
    return frozenset(
        word.removesuffix("s").removesuffix("d") for word in _WORD.findall(text.lower()) if word not in _IDLE
    )


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every such value beside the name of a field without an enum."""
    if span.is_code and not span.is_comment:
        return
    for found in _SAID.finditer(span.text):
        at = found.start("value")
        low, high = (0, len(span.text)) if span.kind is PassageKind.ROW else span.bounds(at)
        names = [offset for offset, _ in span.sentence.within(low, at, "FP")]
        one = about(reading, span, names[-1]) if names else None
        value = number(span.sentence.term(at))
        if one is None or value is None or one.field.definition.enum or _RULED_OUT.search(span.text, low, high):
            continue
        known = specials(one.field.definition.description)
        meant = content(span.source_text(*found.span("words")))
        same = [each for each in known if _is_like(meant, each.words)]
        if len(same) != 1 or any(is_value(each, float(value)) for each in known):
            continue
        others = [each for other in one.others for each in specials(other.definition.description)]
        if any(_is_like(meant, each.words) and is_value(each, float(value)) for each in others):
            continue
        written = span.sentence.term(at).written
        told = same[0].told
        text = f'{one.name}: for "{told}" it is {same[0].written}, not {written}'
        yield reading.found(as_sure(SENTINEL, is_sure=False), span.place(at), f"{one.name} {told} {written}", text)


def is_value(known: Special, value: float) -> bool:
    """Return whether a special value is this number; NaN, which equals nothing, is NaN."""
    return known.value == value or (math.isnan(known.value) and math.isnan(value))


def _is_like(meant: frozenset[str], known: frozenset[str]) -> bool:
    """Return whether one of two meanings has all words of the other."""
    return bool(meant and known) and (known <= meant or (len(meant) > 1 and meant <= known))
