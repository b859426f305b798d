"""Quantities that code sets together, and that readings forget together once code has set none of them for a while."""

import math

from codegen.frozen import dataclass
from codegen.model.vehicle import Component, Quantity, Reading


@dataclass(frozen=True, slots=True)
class SetTogether:
    """Quantities that code sets, for it is one device that knows them: they are unknown ``stale_ms`` after the last.

    ``alone`` are those that nothing else gives, ``counted`` those that a reading gives where it is taken: there they
    are not forgotten.
    """

    stale_ms: int
    readings: int
    alone: tuple[Quantity, ...]
    counted: tuple[tuple[Reading, tuple[Quantity, ...]], ...]

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """All of them."""
        return (*self.alone, *(quantity for _, given in self.counted for quantity in given))


def set_together(component: Component) -> SetTogether | None:
    """Return what code sets of a component and is forgotten together, as its count of returns says; None where nothing
    is.

    It is what begins anew with that count, but for lists, which are forgotten by themselves, and for what has an
    initial value.
    """
    returns = component.returns
    stale_ms = returns.count.derivation.set_stale_ms if returns else None
    if returns is None or stale_ms is None:
        return None
    begun = [each for each in returns.restarting if each.initial is None and each.elements is None and not each.ages]
    given = {reading.name: (*reading.sums, *reading.given) for reading in component.readings}
    counted = [
        (reading, tuple(each for each in begun if each in given[reading.name]))
        for reading in component.readings
        if reading.is_optional
    ]
    return SetTogether(
        stale_ms,
        math.ceil(stale_ms / component.read_every_ms),
        tuple(each for each in begun if not any(each in of_reading for of_reading in given.values())),
        tuple((reading, quantities) for reading, quantities in counted if quantities),
    )
