"""Steps of a field's numbers, as they are told: "one count is 0.01 degC", "in units of 0.1 A", "2 deg per bit"."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import DENIED, MISTAKEN, OWN, PAST, REPLACED, words
from codegen.claims.rules import UNIT, as_sure
from codegen.claims.statements.fields import Said, claimed, number, said_of_fields
from codegen.claims.statements.scaling.field_units import has_unit, of_field, shown_units
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_COUNT = r"(?:counts?|digits?|lsb|bits?|steps?|ticks?|increments?|units?|raw units?)"
_AMOUNT = r"(?P<amount>Q|N U)"
_BEHIND = (
    pattern(
        rf"\b(?:one|an?|each|every|the|N) {_COUNT} ?(?:is|are|=|means|stands for|equals|of|represents|:)+ ?{_AMOUNT}"
    ),
    pattern(rf"\b(?:units|steps|increments|multiples|counts|ticks|resolution|lsb) of {_AMOUNT}"),
    pattern(rf"{_AMOUNT} ?(?:per|/|a|for each|each) {_COUNT}\b"),
    pattern(rf"\b(?:in|has|with|of) {_AMOUNT}[ -](?:steps|increments|counts)\b"),
    pattern(rf"\blsb:? ?(?:is|of|=)? ?{_AMOUNT}"),
    pattern(
        r"(?P<counts>N) (?:counts|steps|units|ticks)"
        r"(?: (?:for|per|to|in|make|make up|are))+ (?:each |one |an? |every )?(?P<unit>U)"
    ),
)
_STEP_OF = pattern(rf"\b(?:each|every|one|an?|the) {_COUNT} (?:of|in) (?:the )?$")
_IS = pattern(rf"(?: (?:of|in) M)? ?(?:is|=|means|stands for|equals|represents) ?{_AMOUNT}")
_ALONE = pattern(rf": {_AMOUNT}(?=\s*(?:[,;]|\.(?:\s|$)|$|\*/|each\b))")
_WORD = pattern(r"\b(?:count|digit|lsb|bit|step|tick|increment|unit|multiple|resolution|each)")
_RULED_OUT = words(
    DENIED, REPLACED, PAST, MISTAKEN, OWN, r"\bshow", r"\bresolution of the\b", r"\bsensor", r"\bround", r"\blimit",
    r"\bchange", r"\bseconds? or\b",
)  # fmt: skip
_MOVED = pattern(r"\b(?:(?:moves?|jumps?|rises?|changes?|falls?|goes)\b|display|screen|knob|slider)")
"""Before steps in which something changes, or is shown, and not what one is."""
_OTHER = pattern(r"[MEVC|]|\.\s(?!\s?(?:it|its|they|one|each|every|a) )")
"""Between a field and a step that is of another thing."""
_IN_MESSAGE = pattern(r" (?:of|in|from) M\b")
_BEHIND_STEP = 12
_FAR = 120


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every step of a part."""
    is_noted = span.is_comment
    if not is_noted and _WORD.search(span.text) is None:
        return
    for said in said_of_fields(span):
        yield from _said(reading, said)


def _said(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    span, text = said.span, said.span.text
    until = min(said.until, said.end + _FAR)
    found = None
    if _STEP_OF.search(text, max(said.before, said.start - 24), said.start):
        found = _IS.match(text, said.end, until)
    for form in _BEHIND if found is None else ():
        found = found or form.search(text, said.end, until)
    if found is None and span.is_comment:
        found = _ALONE.match(text, said.end, until)
        found = found if found is not None and _is_small(span, found) else None
    if found is None or _RULED_OUT.search(text, said.end, found.end() + _BEHIND_STEP):
        return
    if _OTHER.search(_IN_MESSAGE.sub("", text[said.end : found.start()])):
        return
    low, _ = span.bounds(said.start)
    step = _step(span, found) if not _MOVED.search(text, low, found.start()) else None
    if step is None:
        return
    one = claimed(reading, said, found.start(), partial(_is_step, step=step))
    if one is not None:
        shown = span.source_text(found.start(), found.end())
        text = f"{one.name} is in {shown_units(one.field)}, not steps of {step.name}"
        place = span.place(found.start("amount" if "amount" in found.re.groupindex else "counts"))
        yield reading.found(as_sure(UNIT, is_sure=False), place, f"{one.name} {shown}", text)


def _is_small(span: Span, found: "re.Match[str]") -> bool:
    """Return whether an amount alone is a step, 0.01, and no example."""
    value = span.sentence.term(found.start("amount")).value
    amount = value[0] if isinstance(value, tuple) else value
    return isinstance(amount, Fraction) and 0 < amount < 1 and amount.numerator == 1


def _step(span: Span, found: "re.Match[str]") -> Unit | None:
    """The amount that one step is, as a unit."""
    if "counts" in found.re.groupindex:
        count, unit = number(span.sentence.term(found.start("counts"))), span.sentence.term(found.start("unit")).value
        if not count or isinstance(count, float) or not isinstance(unit, Unit):
            return None
        amount = 1 / Fraction(count)
    else:
        value = span.sentence.term(found.start("amount")).value
        if isinstance(value, tuple):
            amount, unit = value
        elif not isinstance(value, Fraction):
            return None
        else:
            amount, unit = value, span.sentence.term(found.end("amount") - 1).value
    if not isinstance(amount, int | Fraction) or not amount or not isinstance(unit, Unit) or not unit.dimension:
        return None
    scaled = float(amount)
    return Unit(f"{scaled:g} {unit.name}", unit.dimension, unit.scale * Fraction(amount), unit.pi, unit.zero)


def _is_step(field: WireField, step: Unit) -> bool:
    """Return whether a step is that of a field's unit, or cannot be compared with it."""
    own = Unit.parse(field.definition.units)
    if own is None or own.dimension != of_field(step, field).dimension:
        return True
    return has_unit(field, step)
