"""The limits within which every message carries a quantity as it is: values set beyond them are counted and told."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.model.answers.answer import Answer
from codegen.model.answers.scaling import Scaling
from codegen.model.system import System
from codegen.model.vehicle import Quantity, QuantityKind

Reach = tuple[int | Fraction, int | Fraction]


def reaches(system: System) -> Mapping[str, Reach]:
    """The smallest and the largest number of each quantity by path, in stored units: its own limits and the fields'.

    Where a table has a ``min`` or a ``max`` of its own, its field is limited on purpose, and counts no further.
    """
    found = {quantity.path: (quantity.minimum, quantity.maximum) for quantity in _quantities(system)}
    for quantity, field in field_reaches(system):
        low, high = found[quantity.path]
        found[quantity.path] = (
            low if field.low is None else max(low, field.low),
            high if field.high is None else min(high, field.high),
        )
    return found


class FieldReach(NamedTuple):
    """The smallest and the largest number that a field of a message carries; None where its table limits it."""

    name: str
    answer: Answer
    low: int | Fraction | None
    high: int | Fraction | None


def field_reaches(system: System) -> Iterator[tuple[Quantity, FieldReach]]:
    """Each quantity with each field that carries it, in stored units."""
    for message in system.messages:
        for answer in message.answers:
            covers = answer.covers
            for quantity, scaling in zip(answer.carried, answer.scalings, strict=False):
                smallest, largest = _carried(answer, quantity, scaling)
                low = smallest if covers.written.min is None else None
                high = largest if covers.written.max is None else None
                yield quantity, FieldReach(f"{message.name}.{covers.label}", answer, low, high)


def reach_words(quantity: Quantity, reach: Reach) -> str:
    """``0..65534 mV`` for people; nothing for a boolean, and where no number suits all messages."""
    low, high = reach
    if quantity.kind is QuantityKind.BOOLEAN:
        return ""
    if low > high:
        return "none that all messages carry"
    ends = [f"{float(end):.7g}" if quantity.storage.is_float else str(int(end)) for end in reach]
    return f"{'..'.join(ends)} {quantity.stored.name}".rstrip()


def _quantities(system: System) -> Iterator[Quantity]:
    for component in system.components.values():
        yield from component.quantities.values()


def _carried(answer: Answer, quantity: Quantity, scaling: Scaling) -> Reach:
    """Return the smallest and the largest stored value that a field carries without changing it."""
    return (scaling.low, scaling.high) if quantity.storage.is_float else _whole(answer, quantity, scaling)


def _whole(answer: Answer, quantity: Quantity, scaling: Scaling) -> tuple[int, int]:
    """The stored steps that go out as they are, but for the rounding of an integer field in coarser steps.

    Where the table of the quantity, or its sensor, says where it ends, that is its limit, also between two steps of
    the field: what is rounded to the last one is not beyond. Where only the field ends, it does so at its last step. A
    field that says unknown by 0 carries a real 0 as 1, which is the dialect's way to tell it.
    """
    is_integer = answer.covers.field.type.is_integer
    low, high = scaling.steps
    smallest, largest = scaling.carried if is_integer else (low, high)
    is_given = bool(quantity.derivation.gives)
    ends = (quantity.spec.min is not None, quantity.spec.max is not None)
    low = smallest if ends[0] or (is_given and smallest <= quantity.minimum) else low
    high = largest if ends[1] or (is_given and largest >= quantity.maximum) else high
    sentinel = answer.covers.field.sentinel
    is_next_to_zero = scaling.low > 0 and scaling.low == (1 if is_integer else scaling.factor)
    return (0 if is_next_to_zero and sentinel and 0 in sentinel.values else low), high
