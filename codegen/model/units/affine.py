"""Exact maps between units: a rational factor, a power of pi, an offset; rounded as if pi were a fraction."""

from collections.abc import Callable, Iterator
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

    def whole_factor(self, largest: int) -> Fraction:
        """Return a fraction in place of a factor with pi that rounds each whole number up to ``largest`` alike.

        Whatever the rounding, every one of either sign becomes the same whole number with it. Without pi that is the
        factor. It is the first of the best approximations by which no product is moved over a multiple of a half:
        among the products with 1 to ``2 * largest``, none is nearer to a whole number than the one with a denominator
        of these approximations.
        """
        most, nearest = max(2 * largest, 1), Fraction(1)
        for value, error in self._approximations():
            if value.denominator <= most and error:
                nearest = min(nearest, value.denominator * error)
            if most * error < nearest:
                return value
        raise AssertionError("there is always a better one")

    def close_factor(self, largest: int, *, times_twos: bool = False) -> Fraction | None:
        """Return the fraction nearest to a factor with pi of whole numbers up to ``largest``, maybe times a power of 2.

        None where it is relatively more than 2 ** -40 away. Without pi it is the factor.
        """
        if not self.pi:
            return self.factor
        value = sum(self.between(Fraction(1), 256), Fraction(0)) / 2
        digits = value.denominator.bit_length() - value.numerator.bit_length() if times_twos else 0
        shifted = value * Fraction(2) ** digits
        found = shifted.limit_denominator(max(1, min(largest, int(largest / shifted))))
        return found / Fraction(2) ** digits if abs(found / shifted - 1) < Fraction(1, 1 << 40) else None

    def _approximations(self) -> Iterator[tuple[Fraction, Fraction]]:
        """Yield the best approximations of the factor, each with how far off it is at most: its continued fraction."""
        if not self.pi:
            yield self.factor, Fraction(0)
            return
        bits = 512
        low, high = self.between(Fraction(1), bits)
        exact, rest = (low + high) / 2, (low + high) / 2
        numerators, denominators = [0, 1], [1, 0]
        while denominators[-1] < 1 << bits // 4:
            whole = rest.numerator // rest.denominator
            numerators.append(whole * numerators[-1] + numerators[-2])
            denominators.append(whole * denominators[-1] + denominators[-2])
            found = Fraction(numerators[-1], denominators[-1])
            yield found, abs(found - exact) + (high - low)
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
