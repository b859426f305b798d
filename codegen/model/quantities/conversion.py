"""The conversion of ADC counts to a quantity: by a multiplier and an offset, which are parameters or constants."""

import math
from collections.abc import Mapping
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.units.unit import Unit, decimal
from codegen.model.vehicle import AdcChannel, Parameter, by_instance


@dataclass(frozen=True, slots=True)
class Constant:
    """A number with its unit that the specification states where a parameter could stand: whole steps of its own."""

    value: Fraction
    unit: Unit
    siblings: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """Return how documents write it: ``17 A/V``."""
        return f"{decimal(self.value)} {self.unit.name}".rstrip()

    @property
    def step(self) -> Fraction:
        """The value of one step in ``unit``."""
        return Fraction(1, self.value.denominator)

    @property
    def default(self) -> int:
        """The value, in steps."""
        return self.value.numerator

    minimum = default
    maximum = default


Factor = Parameter | Constant
"""A factor in the conversion of a reading: a parameter that an operator sets, or a constant."""


def factors_by_instance(factor: Factor, parameters: Mapping[str, Parameter], instances: int) -> tuple[Factor, ...]:
    """The factor of each instance."""
    return by_instance(factor, parameters, instances) if isinstance(factor, Parameter) else (factor,) * instances


@dataclass(frozen=True, slots=True)
class Conversion:
    """A conversion of ADC counts to stored steps: (volts at the pin - ``offset``) * ``multiplier``, to the nearest.

    With an offset it is limited to ``low`` and ``high``, where it can pass them: a level below empty is empty.
    In whole steps of these two it is ``(count * numerator - offset * offset_numerator) * multiplier / denominator``; a
    half goes up. The three numbers have no common factor. Source: the formula of FR-00069, and that of FR-00077.
    """

    channel: AdcChannel
    multiplier: Factor
    numerator: int
    denominator: int
    offset: Factor | None = None
    offset_numerator: int = 0
    low: int | None = None
    high: int | None = None

    @property
    def formula(self) -> str:
        """The same for people: ``count / 4095 * 3.3 V * BATT_VOLT_MULT``."""
        volts = f"count / {self.channel.full_scale} * {decimal(self.channel.reference)} V"
        if self.offset is not None:
            volts = f"({volts} - {self.offset.name}{' V' if isinstance(self.offset, Parameter) else ''})"
        return f"{volts} * {self.multiplier.name}"

    @property
    def factors(self) -> tuple[Factor, ...]:
        """The multiplier, and the offset where there is one."""
        return (self.multiplier,) if self.offset is None else (self.multiplier, self.offset)

    @property
    def is_plain(self) -> bool:
        """Return whether it is a product with a parameter, which can be calibrated against a meter."""
        return isinstance(self.multiplier, Parameter) and self.offset is None

    def exact(self, count: int, multiplier: int, offset: int = 0) -> Fraction:
        """Return what a count stands for with so many steps of the factors, in stored steps."""
        return Fraction((count * self.numerator - offset * self.offset_numerator) * multiplier, self.denominator)

    def stored(self, count: int, multiplier: int, offset: int = 0) -> int:
        """The same as it is kept, a whole number."""
        value = math.floor(self.exact(count, multiplier, offset) + Fraction(1, 2))
        value = value if self.low is None else max(value, self.low)
        return value if self.high is None else min(value, self.high)

    def ends(self, multiplier: Factor, offset: Factor | None) -> tuple[int, int]:
        """The smallest and the largest that is kept, over all counts and all that the factors of an instance can be."""
        offsets = (0,) if offset is None else (offset.minimum, offset.maximum)
        found = [
            self.stored(count, steps, away)
            for count in (0, self.channel.full_scale)
            for steps in (multiplier.minimum, multiplier.maximum)
            for away in offsets
        ]
        return min(found), max(found)
