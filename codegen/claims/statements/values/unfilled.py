"""Values of elements, channels or axes that nothing fills: "slots 8 to 10 are 0, being absent", "an unused axis is 0".

They are said of an array that is named in the sentence or before it, or else of all arrays of a message, or of all its
fields whose descriptions have the noun.
"""

import re
from collections.abc import Iterator, Sequence
from functools import partial

from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import MISTAKEN, PAST, PROPOSED, words
from codegen.claims.rules import SENTINEL, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.subjects import About, about, subjects
from codegen.claims.statements.unknown import is_unknown
from codegen.claims.unknown_value import unknown_values
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_NOUN = (
    r"(?:slots?|cells?|elements?|entry|entries|places?|positions?|sectors?|bins?|cores?|channels?|axis|axes|motors?)"
)
_STEMS = ("slot", "cell", "element", "entr", "place", "position", "sector", "bin", "core", "channel", "ax", "motor")
_MENTIONED = pattern(rf"\b(?P<noun>{_NOUN})\b")
_UNFILLED = pattern(
    r"\b(?:un(?:used|served|populated|connected|fitted)|absent|missing|invalid|empty|not (?:used|fitted|present"
    r"|connected|served|measured|covered|there|available|populated|wired|known|filled|in use|installed)"
    r"|without (?:an? |any |its )?(?:[a-z]+ )?(?:sensor|measurement|reading|data|value|stick|core|cell|motor|input"
    r"|source|head)s?"
    r"|(?:we|one|you|nobody|the [a-z]+) (?:do(?:es)? not|don't|doesn't) (?:want|have|use|need|drive|control|see|report)"
    r"|(?:do(?:es)? not|don't|doesn't) exist|nothing (?:fills|is behind)|nobody (?:fills|uses|wants|measures|serves)"
    r"|(?:above|beyond|over|behind|after|past) (?:the|your|our|its) (?:[a-z]+ )?(?:count|number|last|end))\b"
)
_TOLD = pattern(
    r"\b(?:is|are|has|have|holds?|carry|carries|gets?|(?:stays?|kept)(?: at)?|set to|fill(?:ed)? (?:it |them )?with"
    r"|marked (?:with|by|as)|put|sends?|sent as|written as|contains?|be|with)"
    r"(?: an?| the value| value| all| always| then| plain| just)* (?P<value>[NS])\b"
)
_NAMED_FIRST = pattern(
    r"(?P<value>[NS])(?: ?[=:]| (?:means|marks|is for|stands for|in|is|for))(?: (?:an?|the|all|F|of|M|marks|means|in))*"
    rf" (?:[a-z]+ ){{0,2}}{_NOUN}\b"
)
_CONTRAST = pattern(r"\b(?:while|whereas|but|otherwise)\b|;")
_NO_VALUE = pattern(r" ?(?:[-+*/%]|U\b|Q|N|to N|\.\.|bytes?\b|volts|times|of [a-z]|cells|slots|elements|channels)")
_RULED_OUT = words(
    PAST, MISTAKEN, PROPOSED, r"\b(?:do not|don't|must not|never|not to) (?:send|use|set|fill|write|put)", r"\?",
    r"\bnot (?:N|S)\b", r"\bparam", r"\brather than\b", r"\binstead of\b",
)  # fmt: skip
_FAR = 300
"""The greatest distance back to the name of the array, in characters."""
_FEWEST = 3
"""Fields of a message that a noun names together."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every value of unfilled elements or fields of a part."""
    if (
        not any(stem in span.text for stem in _STEMS)
        or not _MENTIONED.search(span.text)
        or not _UNFILLED.search(span.text)
        or is_data(span)
    ):
        return
    if span.kind is PassageKind.ROW:
        return
    for low, high in _sentences(span):
        noun, unfilled = _MENTIONED.search(span.text, low, high), _UNFILLED.search(span.text, low, high)
        if noun is None or unfilled is None or _RULED_OUT.search(span.text, low, high):
            continue
        told = [found for form in (_NAMED_FIRST, _TOLD) for found in form.finditer(span.text, low, high)]
        values = {at for found in told if _is_value(span, at := found.start("value"))}
        at = next(iter(values), 0)
        ends = sorted((at, unfilled.start()))
        if len(values) == 1 and not _CONTRAST.search(span.text, *ends):
            yield from _compared(reading, span, at, noun["noun"], low)


def _is_value(span: Span, at: int) -> bool:
    """Return whether a number is a value, and no amount or count: "has three" counts, "has zero" may be either."""
    written = span.sentence.term(at).written
    return not _NO_VALUE.match(span.text, at + 1) and (not written.isalpha() or written.lower() in ("zero", "nan"))


def _sentences(span: Span) -> Iterator[tuple[int, int]]:
    """The sentences of a part; a line of code is one."""
    low = 0
    while low < len(span.text):
        _, high = (0, len(span.text)) if span.is_code else span.bounds(low)
        yield low, high
        low = max(high + 1, low + 1)


def _compared(reading: Reading, span: Span, at: int, noun: str, low: int) -> Iterator[Diagnostic]:
    value = number(span.sentence.term(at))
    if value is None:
        return
    _, high = span.bounds(at)
    fits = partial(is_unknown, value=float(value))
    here = _named(reading, span, low, len(span.text) if span.is_code else high)
    is_of_field = any(span.sentence.within(low, at, "FP"))
    arrays = [one for one in here if one.field.is_array]
    if not arrays and not is_of_field:  # fields behind the value are those of the next clause
        arrays = [one for one in _named(reading, span, max(low - _FAR, 0), low) if one.field.is_array]
    if len({one.field.name for one in arrays}) == 1:
        one, wrong = arrays[0], arrays[0].is_wrong(fits)
    elif arrays or is_of_field:
        return
    else:
        kin = _kin(reading, span, at, noun, span.sentence.term(at).written)
        if not kin or any(not one.is_wrong(fits) for one in kin):
            return
        one, wrong = kin[0], True
    known = unknown_values(one.field)
    if wrong and known is not None:
        written = span.sentence.term(at).written
        text = f"{one.name} is unknown when it is {known[1]}, not {written}"
        yield reading.found(as_sure(SENTINEL, is_sure=False), span.place(at), f"{one.name} {written}", text)


def _named(reading: Reading, span: Span, low: int, high: int) -> list[About]:
    """Return the fields that are named between two characters."""
    offsets = (offset for offset, _ in span.sentence.within(low, high, "FP"))
    return [one for offset in offsets if (one := about(reading, span, offset)) is not None]


def _kin(reading: Reading, span: Span, at: int, noun: str, value: str) -> Sequence[About]:
    """Return the fields of the message of a sentence that a noun may mean, and that have a value for unknown.

    They are its arrays of numbers; for an axis, a channel or a motor, or where it has none, the base fields in whose
    descriptions the noun is. One in whose description ``value`` means something else is none of them.
    """
    messages, is_sure = subjects(reading, span, at)
    if not is_sure:
        return ()
    stem = {"axes": "axis"}.get(noun, noun.removesuffix("s") if noun != "axis" else noun)
    word = re.compile(rf"\b{stem}(?:e?s)?\b", re.IGNORECASE)
    known = [
        About(messages[0], field, (), is_sure=False)
        for field in messages[0].fields
        if unknown_values(field) is not None and not re.search(rf"\b{value} means\b", field.definition.description)
    ]
    arrays = [each for each in known if each.field.is_array and each.field.type.name != "char"]
    if arrays and not _OF_FIELDS.match(noun):
        return arrays
    found = [
        each
        for each in known
        if not each.field.is_array
        and not each.field.definition.is_extension
        and word.search(each.field.definition.description)
    ]
    return found if len(found) >= _FEWEST else ()


_OF_FIELDS = pattern(r"channel|ax|motor")
"""Nouns for things that have a field each."""
