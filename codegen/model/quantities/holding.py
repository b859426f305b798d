"""The values at which conditions of a failsafe hold, within the reach of their quantity: none, some, or all."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.failsafe import Condition, Sense
from codegen.model.quantities.reach import Reach
from codegen.model.vehicle import Quantity
from codegen.source import Place

Held = tuple[int, Condition]
"""A condition, with the threshold up to which, or from which on, it holds."""


@dataclass(frozen=True, slots=True)
class Bounds:
    """The conditions on a quantity that decide: what is below one of them or above the other is bad.

    ``is_doubted`` where not all of its values are believed, which the ``ends`` leave out.
    """

    ends: Reach
    is_doubted: bool
    below: Held | None
    above: Held | None

    @property
    def everywhere(self) -> tuple[Held, ...]:
        """The conditions that hold everywhere: one that does so alone, or both, or none."""
        (low, high), below, above = self.ends, self.below, self.above
        if low > high:
            return ()  # nothing is believed: another rule says so
        if below and below[0] > high:
            return (below,)
        if above and above[0] < low:
            return (above,)
        return (below, above) if below and above and below[0] > above[0] else ()


def is_reached(threshold: int, ends: Reach, *, is_below: bool) -> bool:
    """Return whether some value within the ends is below a threshold, or above it."""
    low, high = ends
    return low < threshold if is_below else high > threshold


def easiest(condition: Condition) -> int | None:
    """Return the threshold at which it holds at the most values; None for one that compares nothing."""
    return _threshold(condition, is_high=condition.sense is Sense.BELOW)


def mildest(condition: Condition) -> int | None:
    """Return the threshold at which it holds at the fewest values; None for one that compares nothing."""
    return _threshold(condition, is_high=condition.sense is not Sense.BELOW)


def by_default(condition: Condition) -> int | None:
    """Return the threshold with the default of its parameter; None where that switches it off."""
    return condition.limit.by_default if condition.limit else None


def _threshold(condition: Condition, *, is_high: bool) -> int | None:
    return None if condition.limit is None else condition.limit.ends[is_high]


def in_units(steps: int | Fraction, quantity: Quantity) -> str:
    """Return a number of stored steps in the unit of a quantity, for people."""
    return f"{float(steps / quantity.steps):.7g}"


def place_of(condition: Condition) -> Place:
    """Return where a condition states its limit."""
    return condition.spec.at(condition.sense.value)
