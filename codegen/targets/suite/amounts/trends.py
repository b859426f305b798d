"""Cases of trends: the change per second of a value that rises, stays, and falls."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.model.quantities.device import Exact
from codegen.model.system import System
from codegen.model.units.unit import Unit
from codegen.model.vehicle import Component, Quantity, Reading
from codegen.targets.suite.amounts.case import TREND, AmountCase, criterion_of, name_of, owner_of, stored_of
from codegen.targets.suite.amounts.read import input_of, is_gone, reading_of, value_at


def trend_cases(system: System) -> Iterator[AmountCase]:
    """A case for each instance of a trend: counts one after the other, and the trend that is known after some."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            if not quantity.derivation.kept_readings:
                continue
            reading = reading_of(quantity.derivation.sources[0], component)
            assert reading is not None
            for instance in range(component.instances):
                told = _told(quantity, reading, instance, system)
                facts = {**owner_of(quantity, instance), **input_of(reading, instance, system), "told": told}
                name = f"{name_of(quantity, component, instance)}-is_the_change_per_second"
                yield AmountCase(name, criterion_of(quantity, component), TREND, facts)


def _told(quantity: Quantity, reading: Reading, instance: int, system: System) -> list[list[object]]:
    """Counts in groups, with the trend after each group: None until its window is full."""
    window, component = quantity.derivation.kept_readings, reading.component
    full = reading.conversion.channel.full_scale
    span = min(full // 3, 8 * window)
    low = _lowest(reading, instance, full - span, system)
    rising = [low + span * at // (window - 1) for at in range(window)]
    groups = [rising[:-1], rising[-1:], rising[::-1], [low] * (window // 2)]
    counts: list[int] = []
    told: list[list[object]] = []
    for group in groups:
        counts += group
        values = [value_at(reading, instance, count, system) for count in counts[-window:]]
        told.append([group, _trend(values, component, quantity) if len(counts) >= window else None])
    return told


def _lowest(reading: Reading, instance: int, most: int, system: System) -> int:
    """A count of a third of the whole, or more, with which the component is there."""
    full = reading.conversion.channel.full_scale
    counts = range(min(full // 3, most), most + 1)
    return next(
        (count for count in counts if not is_gone(reading, instance, value_at(reading, instance, count, system))), most
    )


def _trend(values: list[int], component: Component, quantity: Quantity) -> int:
    """The mean of the newer half of the values against that of the older one, by the time between both."""
    half = len(values) // 2
    seconds = Fraction(half * (component.period_ms or 0), 1000)
    change = Fraction(sum(values[half:]) - sum(values[:half]), half)
    measured = component.quantities[quantity.derivation.sources[0]].stored
    per_second = Unit(measured.name, quantity.stored.dimension, measured.scale)
    return stored_of(Exact(change / seconds, per_second), quantity)
