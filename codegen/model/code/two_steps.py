"""Products of more than 30 bits in two steps: a number is multiplied in its high and its low bits apart."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.code.payload_code import indented
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.spec.population import Rounding


@dataclass(frozen=True, slots=True)
class TwoSteps:
    """``value * factor`` by a number times ``whole``, and by parts of it above and below ``bits`` times ``rest``.

    With value = above * 2 ** bits + below, ``above * rest`` is divided first, and what remains of it with the bits
    below. Divisions go down, so that this is exact for numbers of either sign.
    """

    whole: int
    rest: int
    divisor: int
    bits: int

    def lines(self, rounding: Rounding, *, has_negative: bool) -> list[str]:
        """Return the statements that put the rounded product in the place of ``value``."""
        base, mask = 1 << self.bits, (1 << self.bits) - 1
        positive, negative = _added(rounding, self.divisor)
        added = f" + {positive}" if positive else ""
        whole = f"value * {self.whole}" if self.whole > 1 else "value" if self.whole else ""
        low = f"high % {self.divisor} * {base} + (value & {mask}) * {self.rest}{added}"
        return [
            f"high = (value >> {self.bits}) * {self.rest}  # in two steps: the product has more than 30 bits",
            f"low = {low}",
            *_if_negative(negative - positive if has_negative else 0),
            f"value = {f'{whole} + ' if whole else ''}high // {self.divisor} * {base} + low // {self.divisor}",
        ]


def in_one_step(factor: Fraction, most: Fraction) -> bool:
    """Return whether no number of more than 30 bits comes up when one up to ``most`` is multiplied and rounded."""
    return most * factor.numerator + factor.denominator <= SMALL_INT_MAX


def in_two_steps(factor: Fraction, most: Fraction) -> TwoSteps | None:
    """Return the steps in which each number up to ``most`` of either sign is multiplied; None where it needs more."""
    whole, rest = divmod(factor.numerator, factor.denominator)
    if most * max(factor, Fraction(1)) + 1 > SMALL_INT_MAX:
        return None
    for bits in range(8, 24):
        high = ((int(most) >> bits) + 1) * rest
        low = (factor.denominator << bits) + (rest << bits) + factor.denominator
        if max(high, low) <= SMALL_INT_MAX:
            return TwoSteps(whole, rest, factor.denominator, bits)
    return None


def most_in_steps(factor: Fraction, within: Fraction) -> int:
    """Return the largest number up to ``within`` that is multiplied in one step or in two."""
    low, high = 0, int(within)
    while low < high:
        middle = (low + high + 1) // 2
        number = Fraction(middle)
        if in_one_step(factor, number) or in_two_steps(factor, number):
            low = middle
        else:
            high = middle - 1
    return low


def _if_negative(more: int) -> list[str]:
    """Return what is added before the division of a negative number: halves, and what is cut, go towards others."""
    if not more:
        return []
    return ["if value < 0:", *indented([f"low = low {'-' if more < 0 else '+'} {abs(more)}"])]


def _added(rounding: Rounding, divisor: int) -> tuple[int, int]:
    """Return what is added to a positive and to a negative dividend, so that a division that goes down rounds it."""
    half = divisor // 2
    return {
        Rounding.NEAREST: (half, divisor - 1 - half),
        Rounding.DOWN: (0, 0),
        Rounding.UP: (divisor - 1, divisor - 1),
        Rounding.TOWARD_ZERO: (0, divisor - 1),
    }[rounding]
