"""Units as documents write them in words: "feet", "metres per second squared", "tenths of a degree"."""

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache

from codegen.model.units.nearest_unit import worded_unit as unit_of_word
from codegen.model.units.unit import Unit


@lru_cache(maxsize=4096)
def worded_unit(written: str) -> Unit | None:
    """Return the unit of a word or a symbol, of those that no dialect uses, too: "feet"."""
    return unit_of_word(written) or _OTHER_UNITS.get(written.lower())


_FOOT = Unit("ft", (("m", 1),), Fraction(3048, 10000))
_INCH = Unit("in", (("m", 1),), Fraction(254, 10000))
_OTHER_UNITS: Mapping[str, Unit] = {
    **dict.fromkeys(("feet", "foot", "ft"), _FOOT),
    **dict.fromkeys(("inches", "inch"), _INCH),
    **dict.fromkeys(("revolutions per minute",), Unit("rpm", (("deg", 1), ("s", -1)), Fraction(6))),
    **dict.fromkeys(("per mille", "permille"), Unit("d%", (("%", 1),), Fraction(1, 10))),
    **dict.fromkeys(("milli-g", "milli g"), Unit("mG", (("m", 1), ("s", -2)), Fraction(196133, 20000000))),
}


def unit_of_words(written: str) -> Unit | None:
    """Return the unit of words: "centi degrees", "metres per second squared", "deg C"."""
    if (other := _OTHER_UNITS.get(written.lower())) is not None:
        return other
    text = " ".join(written.replace("-", " ").split())
    text = re.sub(r"\b(nano|micro|milli|centi|deci|hecto|kilo|mega) ", r"\1", text)
    text = re.sub(r"/(?:sec|second)\b", " per second", text)
    squared = re.sub(r" (?:a|per) second (?:squared|per second)$", "", text)
    if squared != text:
        inner = worded_unit(squared)
        return Unit.parse(f"{inner.name}/s/s") if inner is not None else None
    return worded_unit(text) or worded_unit(text.replace(" a ", " per ")) or worded_unit(text.lower())


def finer(unit: Unit, parts: int | Fraction) -> Unit:
    """Return the unit of which ``parts`` are one of another."""
    return Unit(f"{unit.name}/{parts}", unit.dimension, unit.scale / Fraction(parts), unit.pi, unit.zero)
