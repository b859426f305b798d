"""Compares units and ranges of numbers."""

import re
from collections.abc import Sequence
from fractions import Fraction

from codegen.diff.judging.judging import HARMLESS, Judgement
from codegen.diff.judging.mentions import numbers
from codegen.model.dialect.literals import exact_number
from codegen.model.units.unit import Unit, conversion, decimal, map_words, ratio
from codegen.pattern import pattern

SAME_NUMBER = "the same value is the same number as before"

_RAW = pattern(r"\braw\b", re.IGNORECASE)
_USUAL = frozenset({"%", "ms", "us", "min", "h", "deg", "deg/s", "rad", "rpm", "d", "dB", "dBm", "degC", "mAh", "km"})
"""Parts and multiples of units in which commands do count."""
_HUNDRED = 100
_TEN = 10


def other_unit(old: str, new: str) -> Judgement:
    """Return what comes of another unit; both are written."""
    before, after = (Unit.parse("".join(text.split())) for text in (old, new))
    if before is None or after is None:
        return Judgement(breaks=True, effect="the number is read in another unit")
    factor = ratio(before, after)
    if factor == 1:
        return Judgement(effect=SAME_NUMBER)
    if factor is not None:
        word = f"{decimal(factor)} times as large" if factor > 1 else f"{decimal(1 / factor)} times as small"
        return Judgement(breaks=True, effect=f"the same value is a number {word}")
    if _is_rate_of(before, after) or _is_rate_of(after, before):
        effect = f"the number is read in another unit, {old} or {new}"
        return Judgement(doubt="whether the old unit was a mistake and the numbers are as before", effect=effect)
    way = conversion(before, after)
    said = f": {old} {map_words(way)} = {new}" if way else ""
    return Judgement(breaks=True, effect=f"the number is read in another unit{said}")


def _is_rate_of(one: Unit, other: Unit) -> bool:
    """Return whether the units differ by a division by seconds, such as mm and mm/s
    of a speed: what is then corrected.
    """
    powers = dict(one.dimension)
    powers["s"] = powers.get("s", 0) - 1
    is_rate = tuple(sorted((base, power) for base, power in powers.items() if power)) == other.dimension
    return is_rate and one.scale == other.scale and one.pi == other.pi


Range = tuple[str | None, str | None]
"""The smallest and the largest value, as written."""


def other_range(old: Range, new: Range, *, is_scaled: bool = True) -> Judgement:
    """Return what comes of other limits: more is accepted, less is, or all is on another scale.

    ``is_scaled`` is whether nothing else, such as a unit or a step, says how much one is.
    """
    before, after = _limits(old), _limits(new)
    scale = _scale(before, after) if is_scaled else None
    if scale is not None:
        return Judgement(breaks=True, effect=f"the range is {decimal(max(scale, 1 / scale))} times as {_size(scale)}")
    names = ("smallest", "largest")
    for index, sign in ((0, 1), (1, -1)):
        was, now = before[index], after[index]
        if was is not None and now is not None and sign * now > sign * was:
            doubt = f"whether values beyond the {names[index]}, now {decimal(now)} and not {decimal(was)}, were sent"
            return Judgement(doubt=doubt)
    return HARMLESS


def first_minimum(old: Range, new: Range, text: str) -> Judgement:
    """Return what comes of a smallest value above 0 that is stated for the first time, of which ``text`` did not tell.

    What counts from 1 has such a one, and was never sent as 0.
    """
    smallest = _limits(new)[0]
    if old[0] is not None or smallest is None or smallest <= 1 or decimal(smallest) in numbers(text):
        return HARMLESS
    return Judgement(doubt=f"whether values below the smallest, now {decimal(smallest)}, were sent")


def first_unit(unit: str, is_attribute: bool, text: str) -> Judgement:
    """Return what comes of a unit that is stated for the first time, where ``text`` told of the number before.

    What is called raw is no amount of anything, and parameters of commands, which are floats, rarely have a part of a
    unit: whether it is written down or changed is not to be seen.
    """
    if _RAW.search(text):
        return Judgement(doubt=f"whether what was called raw is a number of {unit}")
    known = Unit.parse(unit)
    is_part = known is not None and known.scale != 1 and known.name not in _USUAL and known.pi == 0
    if is_attribute and is_part:
        return Judgement(doubt=f"whether it was sent in {unit} before it was written down")
    return HARMLESS


def share_for_unit(old: Range, new: Range, unit: str, step: str | None) -> Judgement:
    """Return what comes of a unit that is stated for a number that had a range of
    its own, such as 0 to 1 of full speed.
    """
    smallest, largest = _limits(old)
    known = Unit.parse(unit)
    if largest is None or old == new or step is not None or (known is not None and known.name == "%"):
        return HARMLESS
    if abs(largest) == 1 and smallest in (None, 0, -1):
        return Judgement(breaks=True, effect=f"it was a share of 1 and is a number of {unit}")
    if largest == _HUNDRED and smallest in (None, 0, -_HUNDRED):
        return Judgement(doubt=f"whether what was up to 100 was a share of it or a number of {unit}")
    return HARMLESS


def _limits(written: Range) -> list[Fraction | None]:
    return [None if text is None else exact_number(text) for text in written]


def _scale(before: Sequence[Fraction | None], after: Sequence[Fraction | None]) -> Fraction | None:
    """The power of ten by which both limits grew or shrank; None where they did not."""
    if not before[1] or not after[1]:
        return None
    found = after[1] / before[1]
    whole = max(found, 1 / found)
    while whole >= _TEN:
        whole /= _TEN
    smallest = before[0] or Fraction(0), after[0] or Fraction(0)
    return found if whole == 1 and found != 1 and smallest[0] * found == smallest[1] else None


def _size(scale: Fraction) -> str:
    return "large" if scale > 1 else "small"
