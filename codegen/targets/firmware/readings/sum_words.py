"""The words that sums over time take beside the quantities that they give."""

from collections.abc import Iterator

from codegen.model.quantities.basis import Basis
from codegen.model.quantities.summed import RADIX, Rest
from codegen.model.vehicle import Parameter, Quantity
from codegen.targets.naming import parameter_attribute

DIGITS = ("low", "middle", "high")
"""The words with what a sum of products has beyond its last whole step."""


def counted(reading: Basis) -> bool:
    """Return whether something is counted on with each reading."""
    return bool(reading.sums) or any(each.derivation.lasts or each.derivation.remains for each in reading.given)


def sum_words(reading: Basis) -> Iterator[str]:
    """The words that this takes beside the quantities, of one number each."""
    if reading.sums:
        yield reading.word("since_ms")
    for quantity in reading.sums:
        yield from rest_words(quantity)
    yield from fulls(reading)
    yield from (f"{each.name}_mean" for each in reading.given if each.derivation.lasts)


def fulls(reading: Basis) -> dict[str, Parameter]:
    """The words with the sizes of what is full, each with its parameter."""
    rests = [each.derivation.remains for each in reading.given]
    return {full_word(rest): rest.full for rest in rests if rest}


def full_word(rest: Rest) -> str:
    """The word with the size of what is full."""
    return parameter_attribute(rest.full.siblings[0] if rest.full.siblings else rest.full.name)


def rest_words(quantity: Quantity) -> dict[str, int]:
    """The words of what a sum has beyond its last whole step, with what they begin with.

    That is half a step in advance, so that whole steps are the nearest ones.
    """
    found = quantity.derivation.sums
    if found is None:
        return {}
    half = found.parts // 2
    if found.times is None:
        return {f"{quantity.name}_rest": half}
    digits = (half % RADIX, half // RADIX % RADIX, half // RADIX // RADIX)
    return {f"{quantity.name}_{word}": digit for word, digit in zip(DIGITS, digits, strict=True)}
