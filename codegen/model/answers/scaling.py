"""The scaling of stored steps to the number on the wire: exact factor, rounding, limits, sentinel out of reach."""

import math
from fractions import Fraction
from typing import NamedTuple

from codegen.frozen import dataclass
from codegen.model.spec.population import Rounding

FLOAT_DIVISOR_MAX = 2**25
"""Largest divisor of a value that goes out as a float by integer arithmetic: the firmware's ``put_float``."""


NUMERATOR_MAX, DIVISOR_MAX = 2**30 - 1, 2**29 - 1
"""Largest odd parts of a factor with which integer arithmetic makes a float of any whole number: ``put_real``."""


class FloatParts(NamedTuple):
    """A factor as ``numerator / divisor * 2 ** power``, both odd."""

    numerator: int
    divisor: int
    power: int


def float_parts(factor: Fraction) -> FloatParts:
    """The parts of a factor above 0."""
    twos = [(number & -number).bit_length() - 1 for number in (factor.numerator, factor.denominator)]
    return FloatParts(factor.numerator >> twos[0], factor.denominator >> twos[1], twos[0] - twos[1])


def rounded(value: Fraction, rounding: Rounding) -> int:
    """``value`` as a whole number; with ``NEAREST`` a half goes away from zero."""
    return _quotient(value.numerator, value.denominator, rounding)


def _quotient(numerator: int, denominator: int, rounding: Rounding) -> int:
    """The same for a quotient: tests ask for thousands, and fractions on the way would take most of the time."""
    if rounding is Rounding.DOWN:
        return numerator // denominator
    if rounding is Rounding.UP:
        return -(-numerator // denominator)
    size = abs(numerator)
    size = size // denominator if rounding is Rounding.TOWARD_ZERO else (2 * size + denominator) // (2 * denominator)
    return size if numerator >= 0 else -size


def _last(high: Fraction, factor: Fraction, rounding: Rounding) -> int:
    """Return the largest whole number that, times ``factor``, is rounded to ``high`` or less."""
    above = {Rounding.NEAREST: Fraction(1, 2), Rounding.UP: Fraction(0)}.get(rounding, Fraction(1))
    if rounding is Rounding.TOWARD_ZERO and high < 0:
        above = Fraction(0)
    is_within = not above or (rounding is Rounding.NEAREST and high < 0)  # whether the end itself is rounded to high
    end = (high + above) / factor
    return math.floor(end) if is_within else math.ceil(end) - 1


@dataclass(frozen=True, slots=True)
class Scaling:
    """wire = ``stored * factor``, rounded, and limited to ``low``..``high`` (wire units, sentinel excluded).

    Where it still equals ``hole``, the sentinel within these limits, it is moved to ``beside``. For integer fields
    ``low`` and ``high`` are whole numbers.
    """

    factor: Fraction
    rounding: Rounding
    low: Fraction
    high: Fraction
    hole: Fraction | None = None
    beside: Fraction | None = None

    @property
    def steps(self) -> tuple[int, int]:
        """The smallest and the largest stored value that goes out as it is, without the rounding of a field."""
        return math.ceil(self.low / self.factor), math.floor(self.high / self.factor)

    @property
    def carried(self) -> tuple[int, int]:
        """The smallest and the largest stored value that an integer field carries: once rounded it is in the limits."""
        turned = {Rounding.DOWN: Rounding.UP, Rounding.UP: Rounding.DOWN}.get(self.rounding, self.rounding)
        return -_last(-self.low, self.factor, turned), _last(self.high, self.factor, self.rounding)

    @property
    def worst(self) -> int:
        """The largest number that comes up when a stored value is scaled by whole numbers; 0 where nothing is."""
        if self.factor == 1:
            return 0
        reach = max(abs(self.low), abs(self.high)) / self.factor + 2
        return int(reach * self.factor.numerator) + self.factor.denominator

    def whole(self, stored: int) -> int:
        """The number that an integer field carries for a stored value."""
        value = _quotient(stored * self.factor.numerator, self.factor.denominator, self.rounding)
        value = max(self.low.numerator, min(self.high.numerator, value))  # whole: it can be limited once it is rounded
        return value if self.beside is None or value != self.hole else int(self.beside)

    def real(self, stored: int) -> float:
        """The number that a float field carries for a stored value, before the wire's precision cuts it."""
        return float(self._beside(self._limited(stored)))

    def to_stored(self, wire: int | Fraction) -> int:
        """The stored value that comes nearest to a number on the wire, in the direction of the rounding."""
        return rounded(wire * (1 / self.factor), self.rounding)

    def _limited(self, stored: int) -> Fraction:
        return max(self.low, min(self.high, stored * self.factor))

    def _beside(self, value: Fraction) -> Fraction:
        return self.beside if self.beside is not None and value == self.hole else value
