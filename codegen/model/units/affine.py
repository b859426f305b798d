"""Exact maps between units: a rational factor, a power of pi, an offset; rounded as if pi were a fraction."""

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import TypeVar

from codegen.frozen import dataclass

_Result = TypeVar("_Result")


@dataclass(frozen=True, slots=True)
class AffineMap:
    """``y = x * factor * pi ** pi + offset``, exactly; where ``pi`` is not 0, ``offset`` is."""

    factor: Fraction
    pi: int = 0
    offset: Fraction = Fraction(0)

    @property
    def ratio(self) -> Fraction | None:
        """The factor, where it is all that there is; None where pi or an offset take part."""
        return None if self.pi or self.offset else self.factor

    def exact(self, value: Fraction) -> Fraction | None:
        """Return what ``value`` becomes; None where that is irrational."""
        if self.pi and value:
            return None
        return value * self.factor + self.offset

    def between(self, value: Fraction, bits: int) -> tuple[Fraction, Fraction]:
        """Bounds of what ``value`` becomes, relatively some 2 ** -bits apart; equal where that is rational."""
        exact = self.exact(value)
        if exact is not None:
            return exact, exact
        low, high = pi_between(bits)
        powers = (low**self.pi, high**self.pi)
        ends = [value * self.factor * power for power in powers]
        return min(ends), max(ends)

    def settled(self, value: Fraction, to: Callable[[Fraction], _Result]) -> _Result:
        """``to`` of what ``value`` becomes, for a ``to`` that rounds: to the nearest float, to a whole number.

        No multiple of pi is a fraction, so it lies off every limit between two results of rounding, and enough
        digits of pi tell on which side.
        """
        bits = 96
        while True:
            low, high = (to(end) for end in self.between(value, bits))
            if low == high:
                return low
            bits *= 2


@cache
def pi_between(bits: int) -> tuple[Fraction, Fraction]:
    """Two fractions around pi, at most 2 ** -bits apart, by Machin's formula: pi = 16 atan(1/5) - 4 atan(1/239)."""
    one = 1 << (bits + 32)  # each of the terms is cut by less than 1, and there are fewer than 2 ** 24 of them
    middle = 16 * _arctangent_of_inverse(5, one) - 4 * _arctangent_of_inverse(239, one)
    return Fraction(middle - (1 << 30), one), Fraction(middle + (1 << 30), one)


def _arctangent_of_inverse(number: int, one: int) -> int:
    """``one`` times the arctangent of ``1 / number``."""
    total, power, divisor = 0, one // number, 1
    while power:
        total += power // divisor if divisor % 4 == 1 else -(power // divisor)
        power //= number * number
        divisor += 2
    return total
