"""Values that are said to stand for unknown in fields."""

import math
import re
from collections.abc import Iterator
from functools import partial

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import SENTINEL, as_sure
from codegen.claims.statements.fields import Said, claimed, number, said_of_fields
from codegen.claims.statements.subjects import about
from codegen.claims.unknown_value import described_unknowns, is_negative_unknown, unknown_values
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.literals import same_number
from codegen.pattern import pattern

NOTHING = (
    r"(?:unknown|unavailable|invalid|undefined|absent|missing|unmeasured|unset|unspecified|not (?:known|available"
    r"|provided|measured|valid|there|used|set|present|supported|estimated)"
    r"|isn't (?:known|available)|nothing is|no (?:data|value|estimate|measurement|reading|sensor|information|info)\b"
    r"|nobody knows|cannot be (?:measured|told|read)|unused|empty|ignored?\b|does(?: not|n't) (?:tell|know|say|report)"
    r"|(?:tells|sees|gives|reports|measures|knows) (?:nothing|none))"
)
_THERE = (
    r"(?:there (?:is|are) |an? |the |it is |it's |value |field |the (?:field|value|reading) |(?:that )?the"
    r" (?:sensor|source|sender|device|receiver|driver|estimator) |that is |is |are "
    r"|that (?:the|it) (?:is )?){0,8}"
)
_IS = (
    r"(?:[\s,:=(\[\u2013\u2014>*`-]|->|\b(?:if|when|where|for|is|means|meaning|stands for|stand for|marks?|says?|as"
    r"|while|signals?|indicates?|denotes?|tells|unless|=>|represents?|in case|the value|the marker|the sentinel"
    r"|marker|value|sentinel)\b){0,12}"
)
_FORMS = (
    pattern(rf"(?P<value>[NS]){_IS}{_THERE}(?:M )?(?:(?:[a-z]+ ){{1,3}}(?:is|are) )?{NOTHING}"),
    pattern(
        rf"{NOTHING}\)?(?: values?)?(?: (?:is|are|as|by|with|it|then|means|value|gives|has|use|set|to|sends?|sent"
        rf"|written|marked|shown|it is|use))*[\s:=,(\u2013\u2014>-]*(?P<value>[NS])(?! ?(?:bytes|=|is|:))"
    ),
    pattern(
        rf"(?P<value>[NS]),? (?:is the |the |its |which is the )?(?:value|marker|sentinel|number|code) for {NOTHING}",
        needs="code for|marker for|number for|sentinel for|value for",
    ),
    pattern(
        r"\b(?:sentinel|invalid value|invalid|\"invalid\")(?: value)?(?: is|:|=| of)*[\s\"]*(?P<value>[NS])",
        needs="invalid|sentinel",
    ),
    pattern(
        rf"(?:if|when|unless|without) [^.;,|()]{{0,40}}?(?:{NOTHING}|known|available|there is no \w+"
        rf"|without an? \w+|no \w+ is (?:fitted|connected|present))[^.;|()]{{0,30}}?\b(?:fill|send|set|put|write"
        rf"|use|is|it is|be|with|to|reads?|gives?)(?: [^.;|()NS]{{0,30}}?)? (?P<value>[NS])(?![ ]?[NSU%])"
    ),
    pattern(
        r"(?P<value>[NS]) (?:if|when|where|without) (?:there is no|no|an? \w+ (?:without|is missing)"
        r"|a) [a-z ]{2,30}?(?= ?(?:[,.;:)|]|$|\*/))",
        needs="if|when|where|without",
    ),
    pattern(rf"\|\s*(?P<value>[NS])\s*\|[^|.;NSU]{{0,40}}?\b(?:{NOTHING}|unused)\b"),
    pattern(
        r"\bif (?:there (?:is|was) )?no [^.;:|()NSFU]{1,24}: ?(?P<value>[NS])(?=\s*(?:[,.;)|]|$|\*/))",
        needs="if no|if there is no|if there was no",
    ),
)
_NOT = pattern(
    r"\bnot N\b|\bnot S\b|\binstead\b|\brather\b|\bold\b|\bunlike\b|\bour\b|\bwrong|\bwould\b|n't\b(?! known"
    r"| available)|\bnever\b|\bvalid\b(?<!invalid)"
)


_NEXT_STATE = pattern(rf"[NS] ?(?:is |means |=|:|-|\u2013)? ?{NOTHING}, $")
"""Before the value of another state: "255 unknown, 0 empty"."""
_DO_NOT = pattern(
    r"\b(?:never|do not|don't|must not|should not) (?:ever )?(?:send|use|set|write|fill|put|treat|take) [a-z ]*$"
)
_INVALID = pattern(rf"\b{NOTHING}(?: [a-z]+){{0,2}} (?:in|of|for) (?:the )?(?:fields? )?$")
_IS_VALUE = pattern(r"(?: of M)?(?: is| has|:| =) ?(?P<value>[NS])(?=\s*(?:[,.;)|]|$|\*/))")
_COMMON = 1
"""Numbers up to this one stand beside a field for anything."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every value for unknown of a part."""
    for said in said_of_fields(span):
        if not _DO_NOT.search(span.text, max(said.before, said.start - 40), said.start):
            yield from _said(reading, said)


def is_unknown(field: WireField, value: float) -> bool:
    """Return whether a value stands for unknown in a field, or the dialect does not tell."""
    known = unknown_values(field)
    if known is None:
        return True
    if (value == 0 and field.definition.enum) or (value < 0 and is_negative_unknown(field)):
        return True
    # Floats on both sides: no float is UINT64_MAX, which a document may name.
    return any(same_number(value, float(each)) for each in (*known[0], *described_unknowns(field)))


def _said(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    span, text = said.span, said.span.text
    found = [each for form in _FORMS for each in form.finditer(text, said.end, said.until)]
    found = [
        each for each in found if not _NEXT_STATE.search(text[max(said.end, each.start() - 14) : each.start("value")])
    ]
    head = re.search(
        rf"(?P<value>[NS])(?: is| stands| means)?(?: the)? {NOTHING}(?: value)? (?:in|for|of)(?: the)?(?: fields?)? $",
        text[max(said.before, said.start - 50) : said.start],
    )
    values = [(each.start("value"), each) for each in found]
    direct = _INVALID.search(text, max(said.before, said.start - 50), said.start) and _IS_VALUE.match(text, said.end)
    if direct:
        values.append((direct.start("value"), direct))
    if head is not None:
        values.append((max(said.before, said.start - 50) + head.start("value"), head))
    stated = [(at, number(span.sentence.term(at))) for at, _ in values if _is_stated(text, said, at)]
    one = about(reading, span, said.names[-1])
    if one is None:
        return
    if not stated:
        yield from _impossible(reading, said)
        return
    if any(value is not None and is_unknown(one.field, float(value)) for _, value in stated):
        return
    around = (number(term) for _, term in span.sentence.within(said.end, said.until, "NS"))
    if any(
        value is not None and abs(float(value)) > _COMMON and is_unknown(one.field, float(value)) for value in around
    ):
        return
    for offset, value in stated[:1]:
        if value is None:
            continue
        wrong = claimed(reading, said, offset, partial(is_unknown, value=float(value)))
        known = unknown_values(wrong.field) if wrong is not None else None
        if wrong is not None and known is not None:
            written = span.sentence.term(offset).written
            words = f"{wrong.name} is unknown when it is {known[1]}, not {written}"
            yield reading.found(
                as_sure(SENTINEL, is_sure=wrong.is_sure), span.place(offset), f"{wrong.name} {written}", words
            )


def _impossible(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """``UINT32_MAX`` beside a field that cannot carry it, without a word about it."""
    span = said.span
    if span.is_code:
        return
    lead = _VALUE_FOR.search(span.text, max(said.before, said.start - 24), said.start)
    found = lead or _BESIDE.match(span.text, said.end, said.until)
    if found is None or (lead is None and _FOR_NEXT.match(span.text, found.end())):
        return
    offset = lead.start() if lead is not None else found.end() - 1
    term = span.sentence.term(offset)
    value = number(term)
    if value is None or not term.written.isupper():
        return
    wrong = claimed(reading, said, offset, lambda field: _carries(field, float(value)))
    if wrong is not None:
        known, field = unknown_values(wrong.field), wrong.field
        told = f"is {field.type.name} and carries {field.type.minimum} to {field.type.maximum}"
        words = f"{wrong.name} {f'is unknown when it is {known[1]}' if known else told}, not {term.written}"
        yield reading.found(
            as_sure(SENTINEL, is_sure=wrong.is_sure), span.place(offset), f"{wrong.name} {term.written}", words
        )


_VALUE_FOR = pattern(r"S (?:for|in|with|at) (?:the |both |all )?(?:fields? )?$")
_FOR_NEXT = pattern(r" (?:for|in|with|at) (?:F|P|the |both |all )")
"""Behind a value that belongs to what follows it: "`a`, UINT8_MAX for `b`"."""
_BESIDE = pattern(r"(?:[\s:=(\u2013-]|\bis\b|\bT\b|,){0,6}S")


def _carries(field: WireField, value: float) -> bool:
    return not field.type.is_integer or math.isnan(value) or field.type.minimum <= value <= field.type.maximum


_COUNTS = pattern(
    r" ?(?:[/*+]|\.\.|to N|bytes|times|%|(?:elements|cells|motors|sensors|channels|servos|entries|slots|sectors"
    r"|cores)\b)"
)
"""Behind a number that is no value."""


def _is_stated(text: str, said: Said, offset: int) -> bool:
    low = max(offset - 40, min(said.end, offset))
    before = text[low:offset]
    return (
        not _NOT.search(before + text[offset])
        and not pattern(r"[NSUQ] ?$|\d$|[<>]=? ?$|\b(?:until|than|above|below|bit|version) $").search(before)
        and not _COUNTS.match(text, offset + 1)
    )
