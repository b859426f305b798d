"""Limits that a document gives a field: "the 32767 mAh limit", "to allow more than 65 V"."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.literals import LIMITS
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.units.unit import Unit, decimal, ratio
from codegen.pattern import pattern

RULE = Rule(
    "claim-limit",
    "A document gives a field the limit of another integer type than it has, or calls a value impossible that the "
    "elements of an array carry together, as its description says. Correct it: decisions have been made for less. "
    "It is likely, not certain: the sentence may be about another limit than that of the type.",
    Severity.WARNING,
    remedy="write the limit of the field's type, or waive it if another limit is meant",
)

_AMOUNT = r"(?P<number>\d{1,12}(?:\.\d{1,6})?)[ \u00a0]?(?P<unit>[A-Za-z%][A-Za-z/]{0,5})\b"
_MORE = r"(?:more than|over|above|beyond|greater than|higher than|>)\s?"
_LIMITED = pattern(
    rf"{_AMOUNT}\s(?:limit|maximum|ceiling)\b"
    rf"|\b(?:limit(?:s|ed)?|max(?:imum)?(?:\s(?:size|value))?)\s(?:(?:it|them|this|of|to|is|was|at|previously)\s){{0,3}}"
    rf"{_AMOUNT.replace('number', 'number2').replace('unit>', 'unit2>')}",
    re.IGNORECASE,
    needs="ceiling|limit|max",
)
_IMPOSSIBLE = pattern(
    rf"\b(?:allow|support|permit|enable|handle|cannot|can't|could not|impossible)\w*\s[^.;|]{{0,50}}?{_MORE}{_AMOUNT}"
    rf"|{_MORE}{_AMOUNT.replace('number', 'number2').replace('unit>', 'unit2>')}"
    r"[^.;|]{0,20}?\b(?:impossible|not possible|could not|cannot)",
    re.IGNORECASE,
)
_FIELD = pattern(r"(?<![\w.])[a-z][a-z0-9]*(?:_[a-z0-9]+)*(?![\w(])")
_ADDS_UP = pattern(r"\bremain(?:ing|der)\b|\bspill", re.IGNORECASE)
_MAXIMA = sorted({value for name, value in LIMITS.items() if name.endswith("_MAX")})


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every amount that is called a limit, and every amount that is called impossible to exceed."""
    if not reading.sightings:
        return
    for passage in reading.prose.passages:
        for found in _LIMITED.finditer(passage.text):
            yield from _limited(reading, passage, found)
        for found in _IMPOSSIBLE.finditer(passage.text):
            yield from _impossible(reading, passage, found)


def _amount(found: "re.Match[str]") -> tuple[str, Unit, int] | None:
    """The number as written, its unit, and where it begins; None where the unit is not known."""
    suffix = "" if found["number"] else "2"
    unit = Unit.parse(found[f"unit{suffix}"])
    return None if unit is None else (found[f"number{suffix}"], unit, found.start(f"number{suffix}"))


def _limited(reading: Reading, passage: Passage, found: "re.Match[str]") -> Iterator[Diagnostic]:
    amount = _amount(found)
    if amount is None:
        return
    written, unit, start = amount
    words = set(_FIELD.findall(passage.text, max(found.start() - 400, 0), found.end() + 200))
    line = passage.place_at(start).line
    candidates = [
        (message, field)
        for message in reading.named_near(line)
        for field in message.fields
        if field.name in words and field.type.is_integer and _in_own_unit(field, unit) is not None
    ]
    if not candidates:
        return
    message, field = candidates[0]
    if any(_is_limit(one.type.maximum, written, _in_own_unit(one, unit)) for _, one in candidates):
        return
    factor = _in_own_unit(field, unit)
    if factor is not None and any(_is_limit(maximum, written, factor) for maximum in _MAXIMA):
        most = f"{decimal(Fraction(field.type.maximum) / factor)} {unit.name}"
        text = f"{message.name}.{field.name} is {field.type.name}: its limit is {most}, not {written}"
        claim = f"{message.name}.{field.name} {written} {unit.name}"
        yield reading.found(RULE, passage.place_at(start), claim, text)


def _impossible(reading: Reading, passage: Passage, found: "re.Match[str]") -> Iterator[Diagnostic]:
    """An amount that one element carries, of an array that spreads more over the next ones."""
    amount = _amount(found)
    if amount is None:
        return
    written, unit, start = amount
    for message in reading.named_near(passage.place_at(start).line):
        limited = [
            (field, factor)
            for field in message.fields
            if field.type.is_integer
            and (factor := _in_own_unit(field, unit)) is not None
            and _is_limit(field.type.maximum, written, factor)
        ]
        if limited:
            break
    else:
        return
    # Of several arrays the one that adds up is enough; without one the nearest message is limited indeed.
    adding = [(field, factor) for field, factor in limited if _adds_up(field)]
    if not adding:
        return
    field, factor = adding[0]
    each = field.type.maximum - _sentinel_at_end(field)
    most = f"{decimal(Fraction(each * field.count) / factor)} {unit.name}"
    text = (
        f"{message.name}.{field.name} carries more than {written} {unit.name}: what is above {each} "
        f"{field.definition.units} goes into the next of its {field.count} elements, {most} in all"
    )
    claim = f"{message.name}.{field.name} more than {written} {unit.name}"
    yield reading.found(RULE, passage.place_at(start), claim, text)


def _in_own_unit(field: WireField, unit: Unit) -> Fraction | None:
    """Return how many of the field's own units one ``unit`` is; None where the dimensions differ."""
    own = wire_unit(field) if field.definition.units else None
    return None if own is None else ratio(unit, own)


def _is_limit(maximum: int, written: str, factor: Fraction | None) -> bool:
    """Return whether a number is the maximum of a type to its own decimals: 65 V is 65535 mV, 327.67 A 32767 cA."""
    if factor is None:
        return False
    precision = Fraction(1, 10 ** len(written.partition(".")[2]))
    return 0 <= Fraction(maximum) / factor - Fraction(written) < precision


def _adds_up(field: WireField) -> bool:
    return field.count > 1 and _ADDS_UP.search(field.definition.description) is not None


def _sentinel_at_end(field: WireField) -> int:
    """1 where the largest value of an element means unknown."""
    return int(field.sentinel is not None and field.type.maximum in field.sentinel.values)
