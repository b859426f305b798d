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

    def factor_for(self, largest: int) -> Fraction:
        """A rational factor that rounds as the exact one does, for every whole number up to ``largest`` either way.

        That holds for rounding to the nearest, down, up and toward zero: between ``x`` times this factor and ``x``
        times the exact one lies no multiple of a half. How near a multiple of a half can be, the last convergent of
        twice the factor tells whose denominator is at most ``largest`` (the best approximations of the second kind).
        """
        if not self.pi:
            return self.factor
        bits = 8 * largest.bit_length() + 64
        low, high = self.between(Fraction(1), bits)
        apart = high - low
        nearest = min(
            abs(2 * low * found.denominator - found.numerator)
            for found in convergents(2 * low)
            if found.denominator <= largest
        )
        margin = (nearest - 2 * largest * apart) / (2 * largest)
        return next(found for found in convergents(low) if abs(found - low) + apart < margin)


def convergents(value: Fraction) -> "list[Fraction]":
    """The convergents of the continued fraction of ``value``, the coarsest first, ``value`` itself last."""
    found, rest = [], value
    before, last = (0, 1), (1, 0)
    while True:
        whole = rest.numerator // rest.denominator
        before, last = last, (whole * last[0] + before[0], whole * last[1] + before[1])
        found.append(Fraction(*last))
        if rest == whole:
            return found
        rest = 1 / (rest - whole)


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
