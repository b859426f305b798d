"""Effects of values of numbered fields: "0 releases channels 1 to 8", "to give back channel 12 send 0".

The descriptions of such fields say so: "A value of 0 means to release this channel". A document tells the same of
several fields at once, by their numbers.
"""

import re
from collections.abc import Iterator, Mapping

from codegen.claims.parts.sentence import NamedField
from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import DENIED, MISTAKEN, PAST, REPLACED, SUPPOSED, words
from codegen.claims.rules import SENTINEL, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.subjects import subjects
from codegen.claims.unknown_value import number_of
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern

_DESCRIBED = pattern(
    r"\bvalues? of (?P<values>[A-Z0-9_-]+(?:(?: or|,) [A-Z0-9_-]+)*) means? to (?P<verb>[a-z]+)", re.IGNORECASE
)
_LESS_ONE = pattern(r"(?P<name>U?INT\d+_MAX)-1")
_BACK = r"(?:[a-zNF]+ ){0,3}back"
_VERBS: Mapping[str, str] = {
    "release": rf"releas(?:es?|ing)\b|(?:give|gives|giving|hand|hands|take|takes) {_BACK}\b",
    "ignore": r"ignor(?:es?|ing|ed)\b|keeps?\b"
    r"|(?:leaves?|leaving) (?:[a-zNF]+ ){1,3}?(?:alone|untouched|unchanged|as (?:it|they))\b"
    r"|(?:not|n't|dont|doesnt) (?:touch|change)\w*\b|no change\b",
}
"""Words for what descriptions call so."""
_STEMS = ("releas", "back", "ignor", "alone", "untouched", "leave", "keep", "chang", "touch")
_ANY = "|".join(f"(?P<{verb}>{form})" for verb, form in _VERBS.items())
_VALUE_FIRST = pattern(
    r"(?<![a-zN]-)(?P<values>[NS](?:(?:,| and| or) [NS])*),? ?"
    r"(?:(?:both|each|is the one that|is what|are|also|means?|=|:|to|tells to|all|i|we|do|does|did|please) ?|[a-z]+, )*"
    rf"(?:{_ANY})"
)
_VERB_FIRST = pattern(
    rf"\b(?:{_ANY})[^.;NS]{{0,60}}?(?:channels? N(?: ?(?:to|-|\u2013) ?N)?[^.;NS]{{0,24}}?)?"
    r"\b(?:write|send|put|use|set|with|by|is)(?: it| them)?(?: to)? (?P<values>[NS])\b"
)
_RANGE = pattern(
    r"\b[a-z]+ (?P<low>N) ?(?:to|-|\u2013|\u2026|through|\.\.\.?) ?(?P<high>N)\b"
    r"|\b(?:first|lower) (?P<many>N) [a-z]+s\b"
    r"|\bfrom [a-z]+ (?P<from>N) (?:on|up)|\b[a-z]+ (?P<up>N) and (?:up|above|higher)|\bchannel (?P<one>N)\b"
)
_RULED_OUT = words(DENIED[:2], PAST, MISTAKEN, REPLACED, SUPPOSED, r"\bour\b", r"\?", r"\bsaid\b", r"\bnot\b")
_MOST = 999


@dataclass(frozen=True, slots=True)
class _Effects:
    """A numbered field with the values for each verb of its description."""

    number: int
    name: str
    values: Mapping[str, frozenset[int]]


@once
def _effects(message: WireMessage) -> tuple[_Effects, ...]:
    """The fields of a message whose descriptions say what values do."""
    found = []
    for field in message.fields:
        digits = pattern(r"\d+").search(field.name)
        told: dict[str, frozenset[int]] = {}
        for each in _DESCRIBED.finditer(field.definition.description) if digits is not None else ():
            told[each["verb"].lower()] = frozenset(map(_value, pattern(r" or |, ").split(each["values"])))
        if digits is not None and told:
            found.append(_Effects(int(digits[0]), field.name, told))
    return tuple(found)


def _value(written: str) -> int:
    less = _LESS_ONE.fullmatch(written)
    value = number_of(less["name"] if less is not None else written)
    return -1 if value is None else int(value) - (less is not None)


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every value of which a part says what it does."""
    if span.kind is PassageKind.ROW or not any(stem in span.text for stem in _STEMS):
        return
    if not any(_effects(message) for message in span.topic.document):
        return
    for form in (_VALUE_FIRST, _VERB_FIRST):
        for found in form.finditer(span.text):
            low, high = span.bounds(found.start("values"))
            if not _RULED_OUT.search(span.text, low, high):
                yield from _compared(reading, span, found)


def _compared(reading: Reading, span: Span, found: "re.Match[str]") -> Iterator[Diagnostic]:
    messages, _ = subjects(reading, span, found.start())
    message = next((each for each in (*messages, *span.topic.around) if _effects(each)), None)
    verb = next(verb for verb in _VERBS if found[verb])
    (first, last), told_at = _numbers(reading, span, found.end())
    told = [each for each in _effects(message) if first <= each.number <= last] if message is not None else []
    own = [each for each in told if verb in each.values]
    if message is None or not own or len(own) < len(told):
        return
    for at, term in span.sentence.within(*found.span("values"), "NS"):
        value = number(term)
        if value is None or at in told_at or any(value in each.values[verb] for each in own):
            continue
        meant = " or ".join(str(each) for each in sorted(own[0].values[verb]))
        text = f"{message.name}.{own[0].name}: to {verb} it is {meant}, not {term.written}"
        claim = f"{message.name}.{own[0].name} {verb} {term.written}"
        yield reading.found(as_sure(SENTINEL, is_sure=False), span.place(at), claim, text)


def _numbers(reading: Reading, span: Span, end: int) -> tuple[tuple[int, int], range]:
    """The numbers of the fields that a statement is about, and where they stand.

    They are those told last before its end, or behind it in its sentence, or else in the line that leads to its list.
    """
    found = _told_before(span, end)
    if found is not None:
        return found
    behind = _RANGE.search(span.text, end, span.bounds(end)[1])
    if behind is not None:
        return _of_range(span, behind), range(*behind.span())
    lead = _leads(reading).get(id(span))
    found = _told_before(lead, len(lead.text)) if lead is not None else None
    return (found[0], range(0)) if found is not None else ((0, _MOST), range(0))


def _told_before(span: Span, end: int) -> tuple[tuple[int, int], range] | None:
    ranges = list(_RANGE.finditer(span.text, 0, end))
    names = [
        (at, int(digits[0]))
        for at, term in span.sentence.within(0, end, "F")
        if isinstance(term.value, NamedField) and (digits := pattern(r"\d+").search(term.value.name)) is not None
    ]
    if names and (not ranges or names[-1][0] > ranges[-1].start()):
        return (names[max(len(names) - 2, 0)][1], names[-1][1]), range(0)
    return (_of_range(span, ranges[-1]), range(*ranges[-1].span())) if ranges else None


def _of_range(span: Span, found: "re.Match[str]") -> tuple[int, int]:
    told = {name: int(number(span.sentence.term(found.start(name))) or 0) for name in _GROUPS if found[name]}
    if "low" in told:
        return told["low"], told["high"]
    if "many" in told:
        return 1, told["many"]
    start = next(iter(told.values()))
    return start, start if "one" in told else _MOST


@once
def _leads(reading: Reading) -> dict[int, Span]:
    """By the identity of each item of a list the part that leads to the list."""
    found, lead = dict[int, Span](), None
    for span in spans(reading):
        if span.kind is PassageKind.ITEM and lead is not None:
            found[id(span)] = lead
        elif span.kind is not PassageKind.ITEM:
            lead = span if span.kind is PassageKind.TEXT and span.text.rstrip().endswith(":") else None
    return found


_GROUPS = ("low", "high", "many", "from", "up", "one")
