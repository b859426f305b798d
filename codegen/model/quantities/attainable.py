"""The smallest and the largest value that a quantity can have, whatever is measured, received or set."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.model.answers.scaling import rounded
from codegen.model.quantities.conversion import Conversion, factors_by_instance
from codegen.model.quantities.reach import Reach
from codegen.model.spec.population import Rounding
from codegen.model.system import System
from codegen.model.vehicle import Component, Quantity


def attainable(system: System) -> Mapping[str, Reach]:
    """Return these values of each number by path, in stored units.

    They are within the limits of the quantity, and of what a sensor gives within what is plausible there, of what an
    ADC measures within its full scale, and of what is received within what the table takes.
    """
    given = unrounded(system)
    quantities = (quantity for component in system.components.values() for quantity in component.quantities.values())
    return {quantity.path: _within(quantity, given.get(quantity.path)) for quantity in quantities}


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


def measured_ends(component: Component, conversion: Conversion, system: System) -> Reach:
    """Return the ends in stored units, over all counts and all values of the factors of all instances."""
    multipliers = factors_by_instance(conversion.multiplier, system.parameters, component.instances)
    offset = conversion.offset
    offsets = factors_by_instance(offset, system.parameters, component.instances) if offset else (None,)
    found = [conversion.ends(multiplier, away) for multiplier in multipliers for away in offsets]
    return min(low for low, _ in found), max(high for _, high in found)


def _within(quantity: Quantity, ends: Reach | None) -> Reach:
    """Return the ends within the limits of the quantity, as they are kept."""
    low, high = ends or (quantity.minimum, quantity.maximum)
    if not quantity.storage.is_float:
        low, high = (rounded(Fraction(end), Rounding.NEAREST) for end in (low, high))
    return max(low, quantity.minimum), min(high, quantity.maximum)
