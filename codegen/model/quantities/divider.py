"""Two resistors that bring what is measured into the range of the converter."""

from bisect import bisect_left
from fractions import Fraction

from codegen.frozen import dataclass

E24 = (10, 11, 12, 13, 15, 16, 18, 20, 22, 24, 27, 30, 33, 36, 39, 43, 47, 51, 56, 62, 68, 75, 82, 91)
"""The values of a decade that resistors of 5 % are sold in (IEC 60063), in tenths."""
_LOWER = [value * 100 for value in E24 if value >= 51] + [value * 1000 for value in E24 if value <= 16]
"""From 5.1 kOhm to 16 kOhm to ground: what the converter sees then stays below 16 kOhm, and little current is lost."""
_UPPER = [value * 10**power for power in range(1, 6) for value in E24]
"""From 100 Ohm to 9.1 MOhm."""
_NEAR = Fraction(1, 50)
"""Farther off than this no pair is told."""


@dataclass(frozen=True, slots=True)
class Divider:
    """Resistors in ohms: ``upper`` from what is measured to the input, ``lower`` from the input to ground."""

    upper: int
    lower: int

    @property
    def ratio(self) -> Fraction:
        """Return what is measured, by what is left of it at the input."""
        return Fraction(self.upper + self.lower, self.lower)


def divider(ratio: Fraction) -> Divider | None:
    """The pair of the series E24 whose ratio is nearest, of equal ones that with less resistance.

    None where nothing is to be divided (``ratio`` up to 1), and where no pair comes near.
    """
    if ratio <= 1:
        return None
    pairs = [Divider(upper, lower) for lower in _LOWER for upper in _around((ratio - 1) * lower)]
    found = min(pairs, key=lambda pair: (abs(pair.ratio - ratio), pair.upper + pair.lower))
    return found if abs(found.ratio - ratio) <= ratio * _NEAR else None


def _around(wanted: Fraction) -> list[int]:
    """The values of the series on both sides of one."""
    at = bisect_left(_UPPER, wanted)
    return _UPPER[max(at - 1, 0) : at + 1]


def ohms(value: int) -> str:
    """``47 kΩ``, as people write it."""
    for scale, prefix in ((1_000_000, "M"), (1000, "k")):
        if value >= scale:
            return f"{value / scale:g} {prefix}Ω"
    return f"{value} Ω"
