"""Values of elements, channels or axes that nothing fills: "slots 8 to 10 are 0, being absent", "an unused axis is 0".

They are said of an array that is named in the sentence or before it, or else of all fields of a message whose
descriptions have the noun.
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

_NOUN = (
    r"(?:slots?|cells?|elements?|entry|entries|places?|positions?|sectors?|bins?|cores?|channels?|axis|axes|motors?)"
)
_STEMS = ("slot", "cell", "element", "entr", "place", "position", "sector", "bin", "core", "channel", "ax", "motor")
_MENTIONED = re.compile(rf"\b(?P<noun>{_NOUN})\b")
_UNFILLED = re.compile(
    r"\b(?:un(?:used|served|populated|connected|fitted)|absent|missing|invalid|empty|not (?:used|fitted|present"
    r"|connected|served|measured|there|available|populated|wired|known|filled|in use|installed)"
    r"|without (?:an? |any |its )?(?:[a-z]+ )?(?:sensor|measurement|reading|data|value|stick|core|cell|motor|input"
    r"|source|head)s?"
    r"|(?:we|one|you|nobody|the [a-z]+) (?:do(?:es)? not|don't|doesn't) (?:want|have|use|need|drive|control|see|report)"
    r"|(?:do(?:es)? not|don't|doesn't) exist|nothing (?:fills|is behind)|nobody (?:fills|uses|wants)"
    r"|(?:above|beyond|over) (?:the|your|our|its) (?:[a-z]+ )?(?:count|number|last)|behind the last)\b"
)
_TOLD = re.compile(
    r"\b(?:is|are|has|have|holds?|carry|carries|gets?|stays?(?: at)?|set to|fill(?:ed)? (?:it |them )?with"
    r"|marked (?:with|by|as)|put|sends?|sent as|written as|contains?|be|with)"
    r"(?: an?| the value| value| all| always| then| plain| just)* (?P<value>[NS])\b"
)
_NAMED_FIRST = re.compile(
    r"(?P<value>[NS])(?: ?[=:]| (?:means|marks|is for|stands for|in|is|for))(?: (?:an?|the|all|F|of|M|marks|means|in))*"
    rf" (?:[a-z]+ ){{0,2}}{_NOUN}\b"
)
_CONTRAST = re.compile(r"\b(?:while|whereas|but|otherwise)\b|;")
_NO_VALUE = re.compile(r" ?(?:[-+*/%]|U\b|Q|N|to N|\.\.|bytes?\b|volts|times|of [a-z]|cells|slots|elements|channels)")
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
    here = [offset for offset, _ in span.sentence.within(low, len(span.text) if span.is_code else high, "FP")]
    before = [offset for offset, _ in span.sentence.within(max(low - _FAR, 0), low, "FP")]
    named = [one for offset in here or before if (one := about(reading, span, offset)) is not None]
    arrays = [one for one in named if one.field.is_array]
    if len({one.field.name for one in arrays}) == 1:
        one, wrong = arrays[0], arrays[0].is_wrong(fits)
    elif arrays or here:
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


def _kin(reading: Reading, span: Span, at: int, noun: str, value: str) -> Sequence[About]:
    """The base fields of the message of a sentence whose descriptions have a noun, and a value for unknown.

    One in whose description ``value`` means something else is none of them.
    """
    messages, is_sure = subjects(reading, span, at)
    stem = {"axes": "axis"}.get(noun, noun.removesuffix("s") if noun != "axis" else noun)
    word = re.compile(rf"\b{stem}(?:e?s)?\b", re.IGNORECASE)
    if not is_sure:
        return ()
    found = [
        About(messages[0], field, (), is_sure=False)
        for field in messages[0].fields
        if not field.is_array
        and not field.definition.is_extension
        and word.search(field.definition.description)
        and unknown_values(field) is not None
        and not re.search(rf"\b{value} means\b", field.definition.description)
    ]
    return found if len(found) >= _FEWEST else ()
