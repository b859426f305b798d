"""Cases of booleans that follow a number, and of numbers in the unit of people: by the tables, in exact arithmetic."""

import math
from collections.abc import Iterator
from fractions import Fraction

from codegen.model.spec.derivation import FollowsSpec
from codegen.model.system import System
from codegen.model.units.unit import conversion, read_measure
from codegen.model.vehicle import Component, Quantity, QuantityKind
from codegen.targets.suite.amounts.case import SHOWN, SIDE, AmountCase, criterion_of, name_of, owner_of

_SHOWN_STEPS = (1, -1, 7, -100, 12345)


def limit_cases(system: System) -> Iterator[AmountCase]:
    """A case for each instance of such a boolean: steps of the number on both sides of each limit, and what is true."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            written = quantity.spec.written(FollowsSpec)
            if written is None or written.follows is None:
                continue
            followed = component.quantities[written.follows]
            for instance in range(component.instances):
                ends = [
                    _limit(each, quantity, followed, instance, component) for each in (written.at_least, written.below)
                ]
                sides = [[steps, _is_within(steps, *ends)] for steps in _around(ends)] + [[None, False]]
                facts = {**owner_of(quantity, instance), "of": followed.attribute, "sides": sides}
                name = f"{name_of(quantity, component, instance)}-has_its_limit"
                yield AmountCase(name, criterion_of(quantity, component), SIDE, facts)


def shown_cases(system: System) -> Iterator[AmountCase]:
    """A case for each number that a sensor gives and that is kept in another unit than people see."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            if quantity.kind is not QuantityKind.NUMBER or not quantity.derivation.gives or quantity.steps == 1:
                continue
            into = conversion(quantity.stored, quantity.unit)
            assert into is not None
            shown = [[steps, *(steps * into.factor).as_integer_ratio()] for steps in _SHOWN_STEPS]
            facts = {**owner_of(quantity, 0), "view": quantity.name, "shown": shown}
            yield AmountCase(f"{quantity.path}-is_shown", criterion_of(quantity, component), SHOWN, facts)


def _limit(
    written: Fraction | str | None, quantity: Quantity, followed: Quantity, instance: int, component: Component
) -> Fraction | None:
    """A limit as written, a number or a fact, in the steps that the number is kept in."""
    if written is None:
        return None
    part, value = component.parts[instance], written
    if isinstance(value, str):
        measure = read_measure(str(part.facts[value]))
        amount = None if measure is None else measure.in_unit(followed.unit)
        assert amount is not None
        value = amount
    count = part.count(quantity.spec.per) if quantity.spec.per else 1
    into = conversion(followed.unit, followed.stored)
    assert into is not None
    return value * (count or 1) * into.factor


def _around(ends: list[Fraction | None]) -> list[int]:
    """Steps at each limit, one below it, and far away on either side."""
    exact = [end for end in ends if end is not None]
    near = {math.ceil(end) + off for end in exact for off in (-1, 0)}
    return sorted(near | {math.floor(min(exact)) - 1000, math.ceil(max(exact)) + 1000})


def _is_within(steps: int, least: Fraction | None, below: Fraction | None) -> bool:
    return (least is None or steps >= least) and (below is None or steps < below)
