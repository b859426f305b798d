"""A few messages in which everything occurs once that makes a difference to how a field is populated."""

import math
from collections.abc import Hashable, Iterator, Mapping

from population.fields import Field, Message


def chosen(messages: Mapping[str, Message]) -> list[Message]:
    """Messages in which every trait of all of them occurs, found greedily: few, and small ones."""
    left = {trait for message in messages.values() for trait in traits(message)}
    found = []
    while left:
        best = max(messages.values(), key=lambda each: (len(left & set(traits(each))) / (8 + each.elements), each.name))
        left -= set(traits(best))
        found.append(best)
    return found


def traits(message: Message) -> Iterator[Hashable]:
    """Type, array, sentinel and extension together; unit, multiplier, limits and enum by themselves."""
    for field in message.fields:
        sentinel = _sentinel(field)
        yield "type", field.type, bool(field.count), sentinel, field.is_extension
        yield "unit", field.unit, field.is_float
        yield "multiplier", field.multiplier
        yield "limits", field.low, field.high
        yield "enum", field.enum is not None and (field.enum.is_bitmask, sentinel)


def _sentinel(field: Field) -> str:
    """Return where the sentinel of the first element lies among its numbers."""
    unknown = field.unknown[0]
    if unknown is None:
        return "none"
    if math.isnan(unknown):
        return "NaN"
    ends = {(1 << field.bits) - 1, (1 << field.bits - 1) - 1, -(1 << field.bits - 1)}
    return "zero" if unknown == 0 else "end" if not field.is_float and unknown in ends else "inside"
