"""Values that a field is said to have while nothing is known: "without a sensor `alt` is 0", "-1 marks no `id`"."""

import re
from collections.abc import Iterator
from functools import partial

from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, MISTAKEN, PAST, PROPOSED, REPLACED, words
from codegen.claims.rules import SENTINEL, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.sentence import NamedField
from codegen.claims.statements.spans import Span, is_data
from codegen.claims.statements.subjects import About, about
from codegen.claims.statements.unknown import NOTHING, is_unknown
from codegen.claims.unknown_value import unknown_values
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind

_ABSENT = re.compile(
    rf"\b{NOTHING}|\b(?:no|without an?|without) (?:[a-z]+ ){{0,2}}(?:sensor|data|fix|gps|estimate|measurement"
    rf"|value|reading"
    r"|module|receiver|input|signal|device)\b|\babsent\b|\bmissing\b|\b(?:lacks?|has no) an? |\bnothing\b"
    r"|\b(?:cannot|can't|do not|don't) (?:fill|know|measure|tell|have)\b|\buntil (?:an? |the )?[a-z]+ is (?:known"
    r"|there|available)|\bno \w+ is (?:fitted|connected|present|known|available)"
)
_VERB = (
    r"(?:is|are|=|==|:|equals|reads?|shows?|stays?(?: at)?|remains?(?: at)?|keeps?|must be|has to be|have to be"
    r"|should be|shall be|reported as|has"
    r"|becomes|gets|holds?|carries|contains|will be|goes to|(?:is |are )?(?:set|filled|left|sent|marked)"
    r"(?: to| with| as| at)?|to|with|at|as)"
)
_TO_VALUE = re.compile(
    rf"(?P<name>[FP])(?: (?:of|in) M)?(?: field)?,? {_VERB}(?: (?:the )?(?:value|number|fixed))? ?(?P<value>[NS])"
    r"(?=\s*(?:[,;.)!]|$|#|//|/\*|\*/|(?:if|when|as long as|while|until|unless|and|as|because|for|then|on|without)\b))"
)
_TO_FIELD = re.compile(
    r"(?<![-+*/<>] )(?P<value>[NS]) (?:(?:in|for|as|into|marks?|means|of|is|says|stands|signals|tells|to|an?|the"
    r"|missing|unknown"
    r"|invalid|absent|field|fields|value|that) )*(?P<name>[FP])(?! ?(?:[-+*/]|(?:is|are|=) ?[NS]))"
)
_TO_SEND = re.compile(
    r"\b(?:use|send|put|write|set|take) (?P<value>[NS]) (?:if|when|where|while|unless) [^.;"
    r"|()NS]{0,40}?(?P<name>F)(?! ?[-+*/])"
)
_CONDITION = re.compile(
    r"\b(?:if|when|while|without|unless|until|no|unknown|absent|missing|invalid|lacks?|marks?|has no)\b"
)
_RULED_OUT = words(
    PAST, MISTAKEN, PROPOSED, REPLACED[:1], ASKED, r"\bnot (?:N|S)\b", r"\bour\b", r"\bignor(?:es|ing)\b",
    r"\bdefault\b", r"\bstart(?:s|ed)? (?:at|with)\b",
)  # fmt: skip
_SMALL = (0, 1)
"""Numbers that a field may really have while something else is unknown."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every value that a sentence about something unknown gives a field."""
    for low, high in _sentences(span):
        if not _ABSENT.search(span.text, low, high) or _RULED_OUT.search(span.text, low, high):
            continue
        told: set[int] = set()
        for form in (_TO_VALUE, _TO_FIELD, _TO_SEND):
            for found in form.finditer(span.text, low, high):
                if found.start("name") not in told:
                    told.add(found.start("name"))
                    yield from _found(reading, span, found, (low, high))


def _sentences(span: Span) -> Iterator[tuple[int, int]]:
    """The sentences of a part; an item, a row and a line are one."""
    if is_data(span):
        return
    if span.kind is PassageKind.ROW or span.is_code:
        yield 0, len(span.text)
        return
    low = 0
    while low < len(span.text):
        _, high = span.bounds(low)
        yield low, high
        low = max(high + 1, low + 1)


def _found(reading: Reading, span: Span, found: "re.Match[str]", sentence: tuple[int, int]) -> Iterator[Diagnostic]:
    term = span.sentence.term(found.start("value"))
    one, value = about(reading, span, found.start("name")), number(term)
    if one is None or value is None or _is_element(span, found.start("name")) or one.field.definition.enum:
        return
    known = unknown_values(one.field)
    if known is None or not one.is_wrong(partial(is_unknown, value=float(value))):
        return
    rest = span.text[sentence[0] : found.start()] + " " + span.text[found.end() : sentence[1]]
    if not (_ABSENT.search(rest) or _ABSENT.search(found[0])) or _others(span, found, sentence, one):
        return
    is_sure = one.is_sure and (float(value) not in _SMALL or _is_told(span, sentence))
    text = f"{one.name} is unknown when it is {known[1]}, not {term.written}"
    yield reading.found(
        as_sure(SENTINEL, is_sure=is_sure), span.place(found.start("value")), f"{one.name} {term.written}", text
    )


def _is_element(span: Span, offset: int) -> bool:
    value = span.sentence.term(offset).value
    return isinstance(value, NamedField) and value.elements is not None


def _is_told(span: Span, sentence: tuple[int, int]) -> bool:
    """Whether the sentence says of the value itself that it stands for nothing."""
    return (
        re.search(
            r"unknown|invalid|marks?\b|sentinel|no data|not (?:known|available|measured)", span.text[slice(*sentence)]
        )
        is not None
    )


def _others(span: Span, found: "re.Match[str]", sentence: tuple[int, int], one: About) -> bool:
    """Whether another value of the sentence is the right one, or it is about another field's."""
    values = [number(term) for at, term in span.sentence.within(*sentence, "NS") if at != found.start("value")]
    return any(
        value is not None and float(value) not in _SMALL and is_unknown(one.field, float(value)) for value in values
    )
