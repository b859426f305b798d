"""Amounts beside a number with their digits that is ten, a hundred, a thousand times what the field carries, or a part.

"3.4 A | SYS_STATUS.current_battery | 3400" needs no verb: digits that agree are no accident, and the place of the point
is what people get wrong.
"""

from collections.abc import Collection, Iterator
from fractions import Fraction

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, DENIED, MISTAKEN, OWN, PAST, PROPOSED, REPLACED, SHOWN, words
from codegen.claims.rules import SCALING, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.quantities import measuring
from codegen.claims.statements.scaling.field_units import described_units, on_the_wire
from codegen.claims.statements.subjects import about, subjects
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.units.unit import Unit
from codegen.pattern import pattern
from codegen.source import Place

_RULED_OUT = words(
    DENIED, REPLACED[:1], PAST, OWN[:3], MISTAKEN, PROPOSED, ASKED, SHOWN,
    r"\bdivid", r"\bmultipl", r"\blimit", r"\bthreshold", r"\bresolution\b", r"\bsteps?\b", r"\baccura", r"\btoleran",
    r"\bfactor\b", r"\bwarn", r"\balarm", r"\bmeans? Q\b", r"\brate\b", r"\bmax", r"\bmin",
)  # fmt: skip
_NUMBERED = pattern(
    r"(?:\b(?:param\w*|ids?|messages?|msg|command|section|version|channel|index|no|item|row|bit|byte|offset|than|above"
    r"|below|over|under|least|most|within|until|about|roughly|to|by|every|per) ?|[<>~#+*/x\u00d7\[-] ?)$"
)
_COUNTED = pattern(r" ?(?:[*/\u00d7\]]|bits?\b|bytes?\b|times\b|hz\b|%|to N|[a-z]+s\b(?<!as)(?<!is)|U\b)")
_OF_PRECISION = pattern(r"\b(?:[hv]?dop|dilution)\b[^N|]{0,12}(?P<value>N)")
_HUNDREDTHS = pattern(r"\* ?100\b")
_FEWEST, _LONG = 2, 5
_FAR = 120
"""Characters behind a sentence in which the name of a field says that it was about something else."""


def check(reading: Reading, span: Span, known: Collection[Place]) -> Iterator[Diagnostic]:
    """Every amount of a row, a line or a sentence beside such a number, where none is ``known`` to be wrong."""
    if "N" not in span.text or (span.is_code and not span.is_comment and "=" not in span.text):
        return
    done = -1
    for at, amount, unit in _amounts(span):
        low, high = (0, len(span.text)) if span.kind is PassageKind.ROW or span.is_code else span.bounds(at)
        if at <= done or _RULED_OUT.search(span.text, low, high):
            continue
        numbers = [(offset, value) for offset, value in _numbers(span, low, high) if offset != at]
        fields = _fields(reading, span, low, high, unit)
        owns = [(message, field, own) for message, field in fields if (own := _own(field, amount, unit))]
        if not owns or any(_agrees(value, own) for _, value in numbers for *_, own in owns):
            continue
        if any(span.place(offset) in known for offset, _ in numbers):
            continue
        for offset, value in numbers:
            if all(_is_tenfold(value, own) for *_, own in owns):
                message, field, own = owns[0]
                name, written = f"{message.name}.{field.name}", span.sentence.term(offset).written
                unit_text = f" ({field.unit_text})" if field.unit_text else ""
                text = f"{span.sentence.term(at).written} is {float(own):.10g} in {name}{unit_text}, not {written}"
                yield reading.found(
                    as_sure(SCALING, is_sure=False), span.place(offset), f"{name} {written} tenfold", text
                )
                done = high
                break


def _amounts(span: Span) -> Iterator[tuple[int, Fraction, Unit | None]]:
    """The amounts of a part with their units; none of one that has no digits to know it by."""
    for at, term in span.sentence.within(0, len(span.text), "Q"):
        value = term.value
        if isinstance(value, tuple) and isinstance(value[1], Unit) and value[0] and value[1].dimension:
            yield at, Fraction(value[0]), value[1]
    for found in _OF_PRECISION.finditer(span.text):
        value = number(span.sentence.term(found.start("value")))
        if value and value < 100:  # a dilution as it is, no number on the wire
            yield found.start("value"), Fraction(str(value)) if isinstance(value, float) else Fraction(value), None


def _numbers(span: Span, low: int, high: int) -> Iterator[tuple[int, Fraction]]:
    for offset, term in span.sentence.within(low, high, "N"):
        value = number(term)
        if value is None or isinstance(value, float) or value == 0 or Fraction(value).denominator != 1:
            continue
        before = span.text[max(offset - 12, low) : offset]
        if not _NUMBERED.search(before) and not _COUNTED.match(span.text, offset + 1):
            yield offset, Fraction(value)


def _fields(
    reading: Reading, span: Span, low: int, high: int, unit: Unit | None
) -> list[tuple[WireMessage, WireField]]:
    """The fields that an amount may be of: the named ones, or those of the message at hand that measure the same."""
    named = [one for at, _ in span.sentence.within(low, high, "FP") if (one := about(reading, span, at)) is not None]
    if any(span.sentence.within(low, high, "F")) or (named and unit is None):
        found = [(one.message, field) for one in named for field in (one.field, *one.others)]
        return [(message, field) for message, field in found if _measures(field, unit)]
    messages, is_sure = subjects(reading, span, low)
    if unit is None or not is_sure or any(span.sentence.within(low, high + _FAR, "FC")) or span.is_code:
        return []
    fields = {field.name: field for field in measuring(messages[:1], unit)}
    told = {each.name: each for message in messages[:1] for each in message.fields if _measures(each, unit)}
    return [(messages[0], field) for field in {**fields, **told}.values() if field.type.is_integer]


def _measures(field: WireField, unit: Unit | None) -> bool:
    return field.type.is_integer and _own(field, Fraction(1), unit) is not None


def _own(field: WireField, amount: Fraction, unit: Unit | None) -> Fraction | None:
    """The number on the wire of an amount; None where the unit is not one of the field's."""
    if unit is None:
        return amount * 100 if _HUNDREDTHS.search(field.definition.description) else None
    owns = [own for own in (Unit.parse(field.definition.units), *described_units(field)) if own is not None]
    return on_the_wire(field, amount, unit, owns[-1]) if owns else None


def _agrees(value: Fraction, own: Fraction) -> bool:
    return abs(abs(value) - abs(own)) <= max(abs(own) / 200, Fraction(1, 2))


def _is_tenfold(value: Fraction, own: Fraction) -> bool:
    """Return whether two numbers have the same digits, or the first of many, and not the same size."""
    if not own or value < 0 < own:
        return False
    digits, others = _digits(value), _digits(own)
    shorter, longer = sorted((digits, others), key=len)
    if len(longer) < _FEWEST:
        return False
    is_same = shorter == longer or (len(shorter) >= _LONG and longer.startswith(shorter[:-1]))
    return is_same and not Fraction(1, 2) < abs(value / own) < 2


def _digits(value: Fraction) -> str:
    """The digits of a number without the zeros around them."""
    return pattern(r"[-.]").sub("", f"{float(abs(value)):.10f}").strip("0")
