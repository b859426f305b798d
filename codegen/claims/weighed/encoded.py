"""Numbers that stand for an amount beside them, with the same digits, but other zeros than the unit of a field asks."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.rules import SCALING
from codegen.claims.statements.scaling.field_units import on_the_wire
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.pairs import Pair, whole_number
from codegen.model.units.unit import Unit, unit_named
from codegen.pattern import pattern

_LINK = pattern(
    r"\b(?:goes?|sent|send|is|reads?|becomes?|as|i\.e|means?|for|gives?|=|->|encoded|written|put)\b|[=:\u2192(|]"
)
_BASES = ("deg", "degC", "m", "m/s", "V", "A", "rad", "s", "%", "gauss", "Pa", "hPa", "rad/s", "deg/s")
_COUNTED = pattern(r"\b(?:number|no\.?|nr\.?) $")
"""Before a number that is not that of a field, but of an alarm, a step or a part."""
_ROUGHLY = 50
"""The share of a number by which it may differ, being rounded."""
_LEAST = 2
"""Digits that two numbers have to have in common."""


def of_encoded(pair: Pair) -> Iterator[Comparison]:
    """Yield what a whole number in the reach of a field says of an amount in the same sentence."""
    value, field = whole_number(pair.term), pair.one.field
    if not value or not field.type.is_integer or _COUNTED.search(pair.before(10)):
        return
    own = Unit.parse(field.definition.units)
    digits = _digits(value)
    for at, term in pair.span.sentence.within(pair.low, pair.high, "QN"):
        amount, unit = _amount(term.value)
        if at == pair.at or not amount or abs(amount) >= abs(value) or (unit is None and amount == int(amount)):
            continue
        other = _digits(amount)
        common = min(len(digits), len(other))
        if common < min(_LEAST, len(other)) or digits[:common] != other[:common] or len(other) < len(digits) - 2:
            continue
        if unit is None and own is None:
            true = [Fraction(field.multiplier) ** -1 * amount] if field.multiplier != 1 else _described(pair, amount)
        elif own is None:
            continue
        else:
            units = (
                [unit] if unit is not None else [u for n in _BASES if (u := unit_named(n)).dimension == own.dimension]
            )
            true = [wire for each in units if (wire := on_the_wire(field, amount, each, own)) is not None]
        if not true:
            continue
        is_right = any(abs(each - value) <= max(Fraction(1), abs(each) / _ROUGHLY) for each in true)
        shown = (
            f"{term.written} is {float(true[0]):.10g} in {pair.one.name} ({field.unit_text}), not {pair.term.written}"
        )
        low, high = sorted((at, pair.at))
        found = traits(
            with_a_unit=unit is not None,
            amount_before=at < pair.at,
            several_digits=common > 2,
            link=_LINK.search(pair.span.text, low + 1, high),
            close=high - low < 25,
        )
        yield Comparison("encoded", SCALING, is_right, shown, found)
        return


def _described(pair: Pair, amount: Fraction) -> list[Fraction]:
    """The number of an amount by the factor in a description: "(unitless * 100)"."""
    found = pattern(r"\* ?(?P<by>10+)\b|\*1E(?P<tens>\d)").search(pair.one.field.definition.description)
    if found is None:
        return []
    return [amount * (int(found["by"]) if found["by"] else 10 ** int(found["tens"]))]


def _amount(value: object) -> tuple[Fraction | None, Unit | None]:
    if isinstance(value, tuple) and isinstance(value[0], Fraction | int) and isinstance(value[1], Unit):
        return Fraction(value[0]), value[1]
    return (Fraction(value), None) if isinstance(value, Fraction) else (None, None)


def _digits(value: int | Fraction) -> str:
    """The digits of a number without zeros at either end."""
    return f"{abs(float(value)):.10f}".replace(".", "").strip("0")
