"""A unit that a text writes behind a number, beside the one in which the number is shown."""

from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import ratio
from codegen.model.vehicle import Quantity
from codegen.pattern import pattern

_WORD = pattern(r" ?([^\s,;:!?()\[\]{}]+)")
_FOREIGN = frozenset({"ft", "feet", "inch", "inches", "mph", "psi", "F", "degF", "\u00b0F", "lb", "lbs"})
"""Units of none of the dialects, which no quantity can have."""


def other_unit(quantity: Quantity, behind: str) -> str | None:
    """Return the unit with which a text goes on behind the quantity, where it is another one than the quantity's.

    A unit of something else may be a word of the text, and what has no unit can be a share or a count of anything.
    """
    found = _WORD.match(behind)
    if found is None or not quantity.unit.name:
        return None
    written = found[1].rstrip(".")
    if written in _FOREIGN:
        return written
    unit = worded_unit(written)
    if unit is None or unit.dimension != quantity.unit.dimension:
        return None
    return None if ratio(unit, quantity.unit) == 1 else written
