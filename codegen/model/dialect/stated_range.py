"""The range that the words of a field state for its values: ``Yaw angle (-pi..+pi)``, ``0.0..359.99 degrees``."""

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.dialect.phrase import phrase
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.units.unit import conversion, unit_named


class StatedRange(NamedTuple):
    """The smallest and the largest number on the wire that the words allow, and these; with pi it is the nearest."""

    low: Fraction
    high: Fraction
    words: str


_NUMBER = r"[-+]?(?:\d{1,7}(?:\.\d{1,4})?|pi)"
_LOW, _HIGH = rf"(?P<low>{_NUMBER})", rf"(?P<high>{_NUMBER})(?![\w*/]|\.\d|,\d)"
_UNIT = r"(?: ?(?P<unit>centi-degrees|degrees|deg|radians|rad|percent|%)(?![\w/]))?"
_RANGES = (
    rf"(?<![\w.]){_LOW} ?\.\. ?{_HIGH}{_UNIT}",
    rf"\[{_LOW} ?(?:,|-|to) ?{_HIGH}\](?! to a)",
    rf"[(,] ?{_LOW} ?(?:-|to) ?{_HIGH}{_UNIT} ?(?=[,)])",
    rf"\b(?:[Rr]ange is|[Ff]rom) {_LOW} ?(?:-|to) ?{_HIGH}{_UNIT}",
    rf"(?:^|: ?){_LOW} ?(?:-|to) ?{_HIGH} (?P<unit>centi-degrees|degrees|percent)\b",
    rf"^{_LOW} to {_HIGH}(?= //)",
)
_UNITS = {"centi-degrees": "cdeg", "degrees": "deg", "deg": "deg", "radians": "rad", "rad": "rad", "percent": "%"}


def stated_range(field: WireField) -> StatedRange | None:
    """Return the range that all words about one allow together; None where there are none.

    Where the dialect has the ends as attributes, minValue and maxValue, these say it, and are kept anyway.
    """
    definition = field.definition
    if field.type.kind is Kind.CHAR or definition.enum is not None:
        return None
    if definition.minimum is not None or definition.maximum is not None:
        return None
    found = list(_ranges(field, definition.description))
    if not found:
        return None
    low, high = min(each.low for each in found), max(each.high for each in found)
    return StatedRange(low, high, " and ".join(dict.fromkeys(each.words for each in found)))


def _ranges(field: WireField, text: str) -> Iterator[StatedRange]:
    """Yield each range, in numbers on the wire."""
    for expression in _RANGES:
        for match in phrase(expression).finditer(text):
            unit = match.groupdict().get("unit")
            has_pi = "pi" in match["low"] + match["high"]
            factor = _on_wire(field, "rad" if has_pi and unit is None else unit)
            if factor is not None:
                low, high = (_number(match[end]) * factor for end in ("low", "high"))
                if low < high:
                    yield StatedRange(low, high, match[0].strip(" ,:([])"))


def _number(text: str) -> Fraction:
    sign = -1 if text.startswith("-") else 1
    digits = text.lstrip("+-")
    return sign * (Fraction(math.pi) if digits == "pi" else Fraction(digits))


def _on_wire(field: WireField, name: str | None) -> Fraction | None:
    """Return what 1 of a unit in words is on the wire, 1 where they name none; None for another dimension."""
    if name is None:
        return Fraction(1)
    unit = wire_unit(field)
    way = None if unit is None else conversion(unit_named(_UNITS.get(name, name)), unit)
    if way is None or way.offset:
        return None
    return way.factor * Fraction(math.pi) ** way.pi
