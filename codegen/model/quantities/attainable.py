"""The smallest and the largest value that a quantity can have, whatever is measured, received or set."""

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from codegen.model.answers.scaling import rounded
from codegen.model.quantities.conversion import Conversion, Factor, factors_by_instance
from codegen.model.quantities.reach import Reach
from codegen.model.spec.population import Rounding
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Quantity


def attainable(system: System) -> Mapping[str, Reach]:
    """Return these values of each number by path, in stored units.

    They are within the limits of the quantity, and of what a sensor gives within what is plausible there, of what an
    ADC measures within its full scale, and of what is received within what the table takes.
    """
    given = unrounded(system)
    quantities = (quantity for component in system.components.values() for quantity in component.quantities.values())
    return {quantity.path: _within(quantity, given.get(quantity.path)) for quantity in quantities}


def attainable_by_default(system: System) -> Mapping[str, Reach]:
    """Return the same of what an ADC measures with a parameter, as it is while that has its default.

    Of several instances it is what any of them has.
    """
    found: dict[str, Reach] = {}
    for reading in system.readings():
        conversion, quantity = reading.conversion, reading.quantity
        if quantity.derivation.represented is not None or quantity.derivation.prefers is not None:
            continue  # what code sets may lie beyond
        if any(isinstance(factor, Parameter) for factor in (conversion.multiplier, conversion.offset)):
            ends = measured_ends(reading.component, conversion, system, by_default=True)
            found[quantity.path] = _within(quantity, ends)
    return found


def unrounded(system: System) -> dict[str, Reach]:
    """Return the ends of what is measured and received, by path, before it is rounded and limited by its quantity."""
    found: dict[str, Reach] = {}
    for reading in system.readings():
        quantity = reading.quantity
        if quantity.derivation.represented is None and quantity.derivation.prefers is None:
            found[quantity.path] = measured_ends(reading.component, reading.conversion, system)
    for table in system.receptions:
        for taken in table.fields:
            if not taken.is_text:
                ends = (taken.low * taken.factor, taken.high * taken.factor)
                found[taken.quantity.path] = min(ends), max(ends)
    for component in system.components.values():
        for quantity in component.quantities.values():
            given = [(output.low * factor, output.high * factor) for _, output, factor in quantity.derivation.gives]
            if given:
                found[quantity.path] = min(low for low, _ in given), max(high for _, high in given)
    return found


def measured_ends(component: Component, conversion: Conversion, system: System, *, by_default: bool = False) -> Reach:
    """Return the ends in stored units, over all counts and instances, and all values, or the defaults, of factors."""
    multipliers = factors_by_instance(conversion.multiplier, system.parameters, component.instances)
    offset = conversion.offset
    offsets = factors_by_instance(offset, system.parameters, component.instances) if offset else (None,)
    pairs = [(multiplier, away) for multiplier in multipliers for away in offsets]
    if by_default:
        pairs = [(_at_default(multiplier), away and _at_default(away)) for multiplier, away in pairs]
    found = [conversion.ends(multiplier, away) for multiplier, away in pairs]
    return min(low for low, _ in found), max(high for _, high in found)


def _at_default(factor: Factor) -> Factor:
    return replace(factor, minimum=factor.default, maximum=factor.default) if isinstance(factor, Parameter) else factor


def _within(quantity: Quantity, ends: Reach | None) -> Reach:
    """Return the ends within the limits of the quantity, as they are kept."""
    low, high = ends or (quantity.minimum, quantity.maximum)
    if not quantity.storage.is_float:
        low, high = (rounded(Fraction(end), Rounding.NEAREST) for end in (low, high))
    return max(low, quantity.minimum), min(high, quantity.maximum)
