"""Units as they are meant of a field: whether a stated one is that of the dialect."""

import re
from fractions import Fraction
from functools import cache

from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit, conversion, unit_named
from codegen.pattern import pattern


def of_field(unit: Unit, field: WireField) -> Unit:
    """The unit as the words for it are meant of a field: degrees of a temperature are degrees Celsius."""
    own = Unit.parse(field.definition.units)
    is_degrees = unit.name == "C" or unit.dimension == unit_named("deg").dimension
    if own is not None and own.dimension == unit_named("degC").dimension and is_degrees:
        return Unit(
            unit.name,
            own.dimension,
            unit.scale / (unit_named("C").scale if unit.name == "C" else 1),
            0,
            unit_named("degC").zero,
        )
    if own is not None and own.dimension == unit_named("gauss").dimension and unit.name in ("G", "mG"):
        return unit_named("gauss" if unit.name == "G" else "mgauss")
    return unit


def on_the_wire(field: WireField, amount: Fraction, unit: Unit, own: Unit) -> Fraction | None:
    """Return the number that a field in the unit ``own`` carries for an amount; None across dimensions, or by pi."""
    turned = conversion(of_field(unit, field), own)
    return None if turned is None or turned.pi else (turned.factor * amount + turned.offset) / field.multiplier


def is_same_unit(one: Unit, other: Unit) -> bool:
    """Return whether a number means the same in both units."""
    return (one.dimension, one.scale, one.pi, one.zero) == (other.dimension, other.scale, other.pi, other.zero)


_SCALED = pattern(r"\b(?P<unit>degrees|meters) ?\* ?(?:10\^|1e)(?P<tens>\d)\b")


@cache
def described_units(field: WireField) -> tuple[Unit, ...]:
    """The units that the description of a field without one gives its numbers: "local: meters * 1e4, ..."."""
    found = []
    for each in _SCALED.finditer(field.definition.description) if not field.definition.units else ():
        whole = unit_named("deg" if each["unit"] == "degrees" else "m")
        found.append(
            Unit(f"{whole.name}*1e{each['tens']}", whole.dimension, whole.scale / 10 ** int(each["tens"]), whole.pi)
        )
    return tuple(found)


def shown_units(field: WireField) -> str | None:
    """The unit of a field, or those of its description."""
    return field.definition.units or " or ".join(unit.name for unit in described_units(field)) or None


_UNITLESS = pattern(r"\bunitless\b|\bdimensionless\b", re.IGNORECASE)


def has_unit(field: WireField, unit: Unit) -> bool:
    """Return whether a unit is that of a field, or one of both has nothing to compare."""
    own = Unit.parse(field.definition.units)
    stated = of_field(unit, field)
    told = described_units(field) if own is None else ()
    if any(each.dimension == stated.dimension for each in told):
        return any(is_same_unit(each, stated) for each in told)
    if own is None and stated.dimension and _UNITLESS.search(field.definition.description):
        return False
    if own is None or not stated.dimension:
        return True
    if field.multiplier != 1:
        finer = Unit(own.name, own.dimension, own.scale * field.multiplier, own.pi, own.zero)
        if is_same_unit(stated, finer):
            return True
    return is_same_unit(stated, own)
