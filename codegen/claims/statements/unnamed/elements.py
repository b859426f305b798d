"""Values of elements that nobody fills: "sectors without a measurement are 0", "65535 marks a cell that is not fitted".

The subject is an element of an array, or one of several fields of the same kind (channels, axes), by its everyday name.
"""

import re
from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import MISTAKEN, PAST, PROPOSED, REPLACED, words
from codegen.claims.rules import SENTINEL, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.subjects import About, about, subjects
from codegen.claims.statements.unknown import is_unknown
from codegen.claims.unknown_value import unknown_values
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage

_NOUN = (
    r"(?P<noun>sectors?|elements?|slots?|cells?|channels?|bins?|entry|entries|positions?|places?|cores?|fans?|bearings?|axis"
    r"|axes)"
)
_EMPTY = (
    r"(?:\bwithout (?!extension)[a-z]+|\bunused\b|\bempty\b|\binvalid\b|\bunknown\b|\bmissing\b|\babsent\b|\bunserved\b"
    r"|\b(?:is|are|was|were|has|have|does|do|being) not\b|\bnot (?:used|fitted|served|there|known|measured|covered"
    r"|connected)\b"
    r"|\b(?:isnt|arent|dont|doesnt)\b|\bnobody\b|\bno [a-z]+ (?:for|behind|in|at|on)\b"
    r"|\b(?:above|beyond|behind|after|past|over) (?:the |your )?(?:real |actual |last |used )?(?:number|count|last"
    r"|end|cell count)\b)"
)
_ANY = re.compile(r"\b(?:sector|element|slot|cell|channel|bin|entr(?:y|ie)|position|place|core|fan|bearing|ax[ei])s?\b")
"""The cheap test before the forms."""
_HOLDS = (
    r"(?:is|are|has|have|holds?|contains?|stays?|remains?|reads?|gets?|carr(?:y|ies)|shows?|set|filled|kept|left|sent|marked"
    r"|coded|must be|shall be|should be)(?: (?:always|then|all|just|set|filled|kept|sent|be|left|marked|coded))*"
    r"(?: (?:at|to|by|with|as|the value))*"
)
_FORMS = (
    re.compile(
        rf"\b{_NOUN} (?:(?:of|in) (?:the )?[FM](?: (?:of|in) M)? ?)?[^.;:|]{{0,60}}?{_EMPTY}[^.;:"
        rf"|NS]{{0,50}}?\b{_HOLDS} (?P<value>[NS])"
    ),
    re.compile(
        rf"\b(?:unused|empty|invalid|unknown|missing|absent|unfilled|other|remaining) {_NOUN}(?: (?:of|in) (?:the"
        rf" )?[FM])?"
        rf"(?: (?:of|in) M)? (?:[a-z]+ ){{0,2}}?{_HOLDS} (?P<value>[NS])"
    ),
    re.compile(
        rf"(?P<value>[NS]),? (?:marks|stands for|means|says|denotes|is for|is the value (?:for|of)) (?:an? |the "
        rf"|that the |that an? )?"
        rf"(?:unused |empty |missing |invalid )?{_NOUN} [^.;:|NS]{{0,40}}?{_EMPTY}"
    ),
)
_NO_VALUE = re.compile(r" ?(?:[-+*/%\u00d7]|U\b|[NS]\b|\.\.|to N|bytes|times|of\b|or\b|[a-z]+s\b(?<!\bas))|,? and N")
_RULED_OUT = words(
    PAST[:1], MISTAKEN, PROPOSED, REPLACED[:1], r"\bnot N\b", r"\bnot S\b", r"\bour (?!driver)", r"\bnever\b", r"\?",
    r"\bbytes?\b",
    r"\b(?:show|display|plot|log|print)", r"\bwrong\b",
)  # fmt: skip


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every value that elements without a content are said to have."""
    if (span.is_code and not span.is_comment) or not _ANY.search(span.text):
        return
    for form in _FORMS:
        for found in form.finditer(span.text):
            at = found.start("value")
            low, high = span.bounds(found.start())
            if _NO_VALUE.match(span.text, at + 1) or _RULED_OUT.search(span.text, low, high):
                continue
            value, own = number(span.sentence.term(at)), _candidates(reading, span, found)
            if value is None or not own or any(is_unknown(each.field, float(value)) for each in own):
                continue
            first, written = own[0], span.sentence.term(at).written
            known = unknown_values(first.field)
            text = f"{first.name} is unknown when it is {known[1] if known else ''}, not {written}"
            yield reading.found(as_sure(SENTINEL, is_sure=False), span.place(at), f"{first.name} {written}", text)


def _candidates(reading: Reading, span: Span, found: "re.Match[str]") -> list[About]:
    """Return the fields whose elements may be meant: those that the sentence names, or all that have such elements."""
    low, high = span.bounds(found.start())
    for start, end in ((low, high), (max(low - _FAR, 0), low)):
        named = [about(reading, span, at) for at, _ in span.sentence.within(start, end, "F")]
        own = [each for each in named if each is not None and _has_elements(each.field, found["noun"])]
        if own:
            return own if all(unknown_values(each.field) is not None for each in own) else []
    messages, is_sure = subjects(reading, span, found.start())
    return [*_of(messages[0], found["noun"])] if messages and is_sure and span.kind is not PassageKind.ROW else []


_FAR = 300
"""Characters before a sentence in which the array that it goes on about is named."""
_CHANNEL = re.compile(r"chan\d+_")


def _has_elements(field: WireField, noun: str) -> bool:
    if noun.startswith("channel"):
        return _CHANNEL.match(field.name) is not None or field.is_array
    if noun.startswith("ax"):
        return not field.is_array and "axis" in field.definition.description.lower()
    return field.is_array and field.type.name != "char"


def _of(message: WireMessage, noun: str) -> Iterator[About]:
    """The fields of a message that have such elements and a value for unknown."""
    for field in message.fields:
        if _has_elements(field, noun) and unknown_values(field) is not None:
            yield About(message, field, (), is_sure=False)
