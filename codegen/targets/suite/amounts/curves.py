"""Cases of estimates: what a curve of the tables gives at its points, between them and beyond its ends."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from codegen.model.system import System
from codegen.model.vehicle import Component, Quantity
from codegen.targets.suite.amounts.case import CURVE, AmountCase, criterion_of, name_of, nearest, owner_of
from codegen.targets.suite.amounts.read import count_for, input_of, is_gone, reading_of, value_at

Points = tuple[tuple[int, int], ...]

_PARTS = 3
"""Of each stretch between two points."""


def curve_cases(system: System) -> Iterator[AmountCase]:
    """A case for each instance of an estimate: counts of the ADC, and what is known then."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            for instance, points in enumerate(quantity.derivation.curves_by_instance):
                found = tuple(_readings(quantity, component, instance, points, system))
                reading = reading_of(quantity.derivation.sources[0], component)
                if found and reading is not None:
                    facts = {
                        **owner_of(quantity, instance),
                        **input_of(reading, instance, system),
                        "of": reading.quantity.attribute,
                        "readings": found,
                    }
                    name = f"{name_of(quantity, component, instance)}-follows_its_curve"
                    yield AmountCase(name, criterion_of(quantity, component), CURVE, facts)


def _readings(
    quantity: Quantity, component: Component, instance: int, points: Points, system: System
) -> Iterator[tuple[int, int, int]]:
    """Counts, each with the steps that are measured then and those of the estimate."""
    reading = reading_of(quantity.derivation.sources[0], component)
    assert reading is not None
    seen = set()
    for target in _targets(points):
        count = count_for(reading, instance, target, system)
        value = value_at(reading, instance, count, system)
        if count not in seen and not (quantity.spec.restarts_with and is_gone(reading, instance, value)):
            seen.add(count)
            yield count, value, _on_curve(points, value)


def _targets(points: Points) -> Iterator[int]:
    """The points themselves, steps between them, and beyond both ends."""
    (first, _), (last, _) = points[0], points[-1]
    yield first - max(1, (last - first) // 8)
    for (low, _), (high, _) in pairwise(points):
        yield from (low + (high - low) * part // _PARTS for part in range(_PARTS))
    yield last
    yield last + max(1, (last - first) // 8)


def _on_curve(points: Points, value: int) -> int:
    """The value of a curve, straight between its points, and at its ends as it is there; to the nearest."""
    if value <= points[0][0]:
        return points[0][1]
    for (low, one), (high, other) in pairwise(points):
        if value <= high:
            return nearest(one + Fraction(value - low, high - low) * (other - one))
    return points[-1][1]
