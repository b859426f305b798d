"""Finds units of smaller steps to which a factor leads, for hints: what to write as ``stored``."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.model.units.unit import Unit, ratio, symbols
from codegen.model.units.unit_table import PREFIXES, SYMBOLS

_HEAD = re.compile(r"([A-Za-z%]+)(.*)")
_DIGITS_OF_A_FLOAT = 2**24
_USUAL = Fraction(1, 1000)


def finer_unit(unit: Unit, most: Fraction | None = None) -> Unit | None:
    """Return the finest unit with a prefix in which ``most`` of ``unit`` has no more steps than a float of 32 bits has.

    Without ``most``: thousandths, or what comes nearest to them. None where no prefix makes steps of less than one.
    """
    finer = list(finer_units(unit))
    if most is None:
        return max(finer, key=lambda each: _nearness(each, unit), default=None)
    within = [each for each in finer if (steps := ratio(unit, each)) and most * steps <= _DIGITS_OF_A_FLOAT]
    return min(within, key=lambda each: each.scale, default=None)


def as_fine_as(unit: Unit, step: Unit) -> Unit:
    """Return the coarsest unit with a prefix, to which a factor leads from ``unit``, of steps no larger than ``step``.

    ``unit`` itself where none is: then it is as fine as ``step``, or nothing is.
    """
    size = _size(step)
    if _size(unit) <= size:
        return unit
    fine = [each for each in finer_units(unit) if _size(each) <= size]
    return max(fine, key=lambda each: each.scale, default=unit)


def finer_units(unit: Unit) -> Iterator[Unit]:
    """The same unit with the prefixes of its first symbol that make it smaller: mm/s and cm/s of m/s."""
    match = _HEAD.fullmatch(unit.name)
    if match is None or match[1] not in symbols():
        return
    prefix, symbol = symbols()[match[1]]
    for other in SYMBOLS[symbol][2].split():
        if Fraction(PREFIXES[other]) < Fraction(PREFIXES[prefix]):
            found = Unit.parse(f"{other}{symbol}{match[2]}")
            if found is not None and ratio(unit, found) is not None:
                yield found


def _size(unit: Unit) -> float:
    """The size of a step in base units, near enough to compare."""
    return float(unit.scale) * 3.141592653589793**unit.pi


def _nearness(unit: Unit, whole: Unit) -> tuple[bool, Fraction]:
    """The coarsest of those of a thousandth or less come first, else the finest."""
    share = unit.scale / whole.scale
    return (share <= _USUAL, share if share <= _USUAL else -share)
