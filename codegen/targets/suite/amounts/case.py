"""A case about amounts, and the exact arithmetic that its numbers come of: units and what the tables say."""

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.model.answers.scaling import rounded
from codegen.model.quantities.device import Exact
from codegen.model.spec.population import Rounding
from codegen.model.units.unit import conversion
from codegen.model.vehicle import Component, Quantity

ARRIVES, CURVE, SHOWN, SIDE, SUM, TREND = "arrives", "curve", "shown", "side", "sum", "trend"
"""The kinds of cases, by the functions that run them."""


class AmountCase(NamedTuple):
    """A case: its name in the suite, the criterion that it shows or nothing, its kind, and what that has to know."""

    name: str
    criterion: str
    kind: str
    facts: Mapping[str, object]


def name_of(quantity: Quantity, component: Component, instance: int) -> str:
    """Return what the suite calls one instance of a quantity: ``cell.used``, of several ``cell.used-2``."""
    return quantity.path if component.instances == 1 else f"{quantity.path}-{instance + 1}"


def criterion_of(quantity: Quantity, component: Component) -> str:
    """The criterion that asks for a quantity, or for its component, or nothing."""
    return str(quantity.citation or component.citation or "")


def owner_of(quantity: Quantity, instance: int) -> dict[str, object]:
    """Return where the state has it."""
    return {"component": quantity.component, "instance": instance, "attribute": quantity.attribute}


def stored_of(amount: Exact, quantity: Quantity) -> int:
    """An amount in the steps of a quantity, to the nearest; a half goes away from zero."""
    into = conversion(amount.unit, quantity.stored)
    assert into is not None
    assert not into.pi
    exact = amount.value * into.factor + into.offset
    return rounded(exact, Rounding.NEAREST)


def nearest(exact: Fraction) -> int:
    """The nearest whole number; a half goes up."""
    return math.floor(exact + Fraction(1, 2))
