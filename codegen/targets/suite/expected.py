"""The expected fields of a message for a given state, by exact arithmetic on the resolved system.

The generated tests and the tests of the generator take their expected values from here; nothing of the firmware is
involved.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

from codegen.model.answers.known import Known, Stored, Value, single
from codegen.model.code.letters import NUL, cut
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.quantities.conversion import Conversion
from codegen.model.system import Policy, PopulatedMessage, Representation
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Quantity, QuantityKind

Wire = int | float | str | list[int | float]
"""A field as pymavlink takes it: a number, a text, or a list for an array."""


def converted(
    quantity: Quantity, conversion: Conversion, count: int, multiplier_steps: int, offset_steps: int = 0
) -> int:
    """The stored integer for an ADC count: the formula of the requirement, rounded to nearest at its end."""
    channel, multiplier, offset = conversion.channel, conversion.multiplier, conversion.offset
    volts = Fraction(count, channel.full_scale) * channel.reference
    if offset is not None:
        volts -= offset_steps * offset.step * offset.unit.scale / unit_named("V").scale
    value = volts * unit_named("V").scale * multiplier_steps * multiplier.step * multiplier.unit.scale
    stored = value / quantity.stored.scale
    nearest = math.floor(stored + Fraction(1, 2))
    nearest = nearest if conversion.low is None else max(nearest, conversion.low)
    return nearest if conversion.high is None else min(nearest, conversion.high)


def is_withheld(message: PopulatedMessage, known: Known) -> bool:
    """Return whether nothing is sent while the state is ``known``."""
    return any(answer.is_withheld(known) for answer in message.answers)


def expected_fields(message: PopulatedMessage, known: Known, instance: int = 0, page: int = 0) -> dict[str, Wire]:
    """Every field of ``message`` by name, as pymavlink takes them, while the state is ``known``; empty if withheld.

    ``known`` is about the instance that the message is for, or about the one that it represents.
    """
    if is_withheld(message, known):
        return {}
    elements: dict[str, dict[int, Value]] = {}
    for answer in message.answers:
        covers = answer.covers
        for index, value in enumerate(answer.values(known, instance, page)):
            elements.setdefault(covers.field.name, {})[covers.first + index] = value
    fields: dict[str, Wire] = {}
    for field in message.wire.fields:
        values = elements[field.name]
        if isinstance(values[0], str):
            fields[field.name] = _characters(values[0], field)
        elif field.is_array:
            fields[field.name] = [_number(values[index]) for index in range(field.count)]
        else:
            fields[field.name] = values[0]
    return fields


def _characters(text: str, field: WireField) -> Wire:
    """A text as a field has it: a number for each byte where that is no char; a single char is never nothing."""
    if field.type.kind is not Kind.CHAR:
        return list(text.encode().ljust(field.count, b"\0"))
    return text if field.is_array else text or NUL


def _number(value: Value) -> int | float:
    assert not isinstance(value, str)
    return value


def chosen_instance(choice: Representation, instances: Sequence[Known]) -> int:
    """Return which instance is represented; ``instances`` has what is known of each of them, and of the parameter."""
    component = choice.component
    enabled = component.enabled
    on = [number for number, known in enumerate(instances) if enabled is None or known[enabled.path]]
    if choice.policy is Policy.FIRST:
        return 0
    if choice.parameter is not None:
        number = instances[0].get(choice.parameter.name, choice.parameter.default)
        assert isinstance(number, int)
        if number - 1 in on:
            return number - 1
    if choice.quantity is not None:
        values = [
            (value, number) for number in on if (value := single(instances[number], choice.quantity.path)) is not None
        ]
        if values:
            return min(values)[1]
    return on[0] if on else 0


def nominal_values(quantity: Quantity, instance: int) -> Stored:
    """A plain value, or a different one for each element of the instance; of a text some characters."""
    if quantity.kind is QuantityKind.TEXT:
        return cut(NOMINAL_TEXT[min(instance, 5) :], quantity.length)
    plain = nominal(quantity)
    if quantity.elements is None:
        return plain
    count = quantity.elements[instance]
    low, high = quantity.minimum, quantity.maximum
    if quantity.storage.is_float:
        is_limited = quantity.spec.min is not None and quantity.spec.max is not None
        apart = Fraction(high - low) / 64 if is_limited else Fraction(7, 8)
        values = (quantity.storage.nearest(Fraction(plain) + apart * index) for index in range(count))
        return tuple(max(low, min(high, value)) for value in values)
    return tuple(max(int(low), min(int(high), int(plain) + 7 * index)) for index in range(count))


NOMINAL_TEXT = "Plain words"
"""The text of quantities in tests; a different end of it for each instance."""


def nominal(quantity: Quantity) -> int | Fraction:
    """A plain value of a quantity: in the middle of its limits, or a small odd number without limits.

    Of one that takes more than a word it is a large one, so that every half of it counts.
    """
    if quantity.kind is not QuantityKind.NUMBER:
        assert not isinstance(quantity.initial, str)
        return quantity.initial or 0
    if quantity.storage.is_float:
        middle = Fraction(1237, 64) if quantity.spec.max is None else (quantity.minimum + 2 * quantity.maximum) / 3
        return quantity.storage.nearest(Fraction(middle))
    low, high = int(quantity.minimum), int(quantity.maximum)
    if quantity.storage is not Storage.SMALL:
        return low + (high - low) * 5 // 7
    return min(1237, high * 2 // 3) if abs(low) == abs(high) else (low + high) // 2
