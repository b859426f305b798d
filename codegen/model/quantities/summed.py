"""Sums of readings over time, the rest of a full store that they leave, and how long that rest lasts."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.vehicle import Parameter

RADIX = 1000
"""A product of two readings and a time is divided in three steps, of which the first two are these."""


@dataclass(frozen=True, slots=True)
class Sum:
    """The sum over time of the readings of ``of``, or of their products with ``times``.

    So many ``parts``, each a step of these for one millisecond, make one step of the sum.
    """

    of: str
    times: str | None
    parts: int


@dataclass(frozen=True, slots=True)
class Rest:
    """The rest of ``full`` after the sum ``after``; one step of the parameter ``full`` is ``steps`` steps of the sum.

    ``share``: the steps that are all of it, for what is told as a part of it; None: in steps of the sum.
    """

    full: Parameter
    after: str
    steps: int
    share: int | None


@dataclass(frozen=True, slots=True)
class Lasting:
    """The time that ``left`` lasts at the mean of ``at`` over so many ``readings``: ``left * factor / at``."""

    left: str
    at: str
    readings: int
    factor: int

    def factors(self, left: Rest | None) -> tuple[int, int]:
        """The factor as a product whose first part makes no more than a small integer of what can be left at most."""
        most = left.full.maximum * left.steps if left else 0
        parts = (second for second in range(1, self.factor + 1) if self.factor % second == 0)
        fitting = (second for second in parts if most * (self.factor // second) <= SMALL_INT_MAX)
        second = next(fitting, 1)
        return self.factor // second, second

    @property
    def smooth_steps(self) -> int:
        """Return the parts of a step in which the mean, times ``readings``, is kept: so it comes to what stays."""
        return max(1, 128 // (self.readings + 1))


def whole(value: Fraction | None) -> int | None:
    """A whole number above 0; None for anything else."""
    return int(value) if value is not None and value.denominator == 1 and value > 0 else None
