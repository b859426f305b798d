"""Readings at an edge: where rounding turns, and at the limit that is warned about. Counts drawn by lot miss them."""

from collections.abc import Iterator
from itertools import islice
from math import gcd

from codegen.frozen import dataclass
from codegen.model.quantities.conversion import Conversion
from codegen.model.vehicle import Parameter, Quantity


@dataclass(frozen=True, slots=True)
class Edge:
    """A count, the multiplier for it in steps, what is kept of both, and whether that is warned about."""

    count: int
    steps: int
    value: int
    is_warned: bool


def edges(quantity: Quantity) -> tuple[Edge, ...]:
    """Return the readings of the first instance just below a half and at one, at its limit and a step above that.

    What no count and multiplier come to is left out, and all where the multiplier has no free choice or the conversion
    an offset.
    """
    conversion, threshold = quantity.derivation.conversion, quantity.derivation.threshold
    if conversion is None or conversion.offset is not None or not isinstance(conversion.multiplier, Parameter):
        return ()
    multiplier = conversion.multiplier
    if multiplier.choices:
        return ()
    half = -(-conversion.denominator // 2)  # the smallest remainder that is rounded up
    found = [*islice(_with_remainder(half - 1, conversion, multiplier), 1)]
    found += islice(_with_remainder(half, conversion, multiplier), 1)
    limit = threshold.above[0] if threshold else None
    for value in () if limit is None else (limit, limit + 1):
        found += islice(_with_value(value, conversion, multiplier), 1)
    return tuple(
        Edge(count, steps, value, limit is not None and value > limit)
        for count, steps in found
        for value in [conversion.stored(count, steps)]
    )


def _with_remainder(remainder: int, conversion: Conversion, multiplier: Parameter) -> Iterator[tuple[int, int]]:
    """Yield counts and steps whose product leaves a remainder when it is divided."""
    for count in range(conversion.channel.full_scale, 0, -1):
        product = count * conversion.numerator
        common = gcd(product, conversion.denominator)
        if remainder % common == 0:
            modulus = conversion.denominator // common
            steps = remainder // common * pow(product // common, -1, modulus) % modulus
            least = max(multiplier.minimum, 1)
            steps += -(-(least - steps) // modulus) * modulus  # the first that is no less
            if steps <= multiplier.maximum:
                yield count, steps


def _with_value(value: int, conversion: Conversion, multiplier: Parameter) -> Iterator[tuple[int, int]]:
    """Yield counts and steps that come to a value."""
    for count in range(conversion.channel.full_scale, 0, -1):
        steps = -(-(2 * value - 1) * conversion.denominator // (2 * count * conversion.numerator))
        if multiplier.minimum <= steps <= multiplier.maximum and conversion.stored(count, steps) == value:
            yield count, steps
