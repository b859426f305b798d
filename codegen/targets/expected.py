"""What a message must carry for a given state, by exact arithmetic on the resolved system.

The generated tests and the tests of the generator take their expected values from here; nothing of the firmware is
involved.
"""

import math
from collections.abc import Mapping
from fractions import Fraction

from codegen.model.spec import Rounding
from codegen.model.system import (
    Binding,
    FixedBinding,
    FlagsBinding,
    InstanceBinding,
    LiveBinding,
    PartBinding,
    PopulatedMessage,
    SplitBinding,
)
from codegen.model.unit import UNITS, Measure
from codegen.model.vehicle import Parameter, Quantity, QuantityKind

Known = Mapping[str, int | None]
"""Stored integers by ``component.quantity`` or name of a parameter; None is unknown, a boolean is 0 or 1."""

Wire = int | float | str | list[int | float]
"""A field as pymavlink takes it: a number, a text, or a list for an array."""


def rounded(value: Fraction, rounding: Rounding) -> int:
    """``value`` as a whole number; with ``NEAREST`` a half goes away from zero."""
    if rounding is Rounding.DOWN:
        return math.floor(value)
    if rounding is Rounding.UP:
        return math.ceil(value)
    if rounding is Rounding.TOWARD_ZERO:
        return math.trunc(value)
    return math.floor(value + Fraction(1, 2)) if value >= 0 else math.ceil(value - Fraction(1, 2))


def converted(quantity: Quantity, count: int, multiplier_steps: int) -> int:
    """The stored integer for an ADC count: the formula of the requirement, rounded to nearest at its end."""
    conversion = quantity.conversion
    assert conversion is not None
    channel = conversion.channel
    volts = Fraction(count, channel.full_scale) * channel.reference * multiplier_steps * conversion.multiplier.step
    stored = Measure(volts, UNITS["V"]).in_unit(quantity.stored)
    assert stored is not None
    return rounded(stored, Rounding.NEAREST)


def expected_fields(message: PopulatedMessage, known: Known, instance: int = 0) -> dict[str, Wire]:
    """Every field of ``message`` by name, as pymavlink takes them, while the state is ``known``."""
    elements: dict[str, dict[int, int | float | str]] = {}
    for binding in message.bindings:
        covers = binding.covers
        for index, value in enumerate(_values(binding, known, instance)):
            elements.setdefault(covers.field.name, {})[covers.first + index] = value
    fields: dict[str, Wire] = {}
    for field in message.wire.fields:
        values = elements[field.name]
        if field.is_array and not isinstance(values[0], str):
            fields[field.name] = [_number(values[index]) for index in range(field.count)]
        else:
            fields[field.name] = values[0]
    return fields


def _number(value: int | float | str) -> int | float:
    assert not isinstance(value, str)
    return value


def _values(binding: Binding, known: Known, instance: int) -> tuple[int | float | str, ...]:
    if isinstance(binding, FixedBinding):
        return binding.values
    if isinstance(binding, PartBinding):
        return binding.values[instance].values
    if isinstance(binding, InstanceBinding):
        return (instance,)
    if isinstance(binding, FlagsBinding):
        return (_flags(binding, known),) * binding.covers.count
    if isinstance(binding, SplitBinding):
        return _cells(binding, known)
    return (_wire_value(binding, known),)


def _flags(binding: FlagsBinding, known: Known) -> int:
    mask = binding.mask
    for _, value, quantity in binding.conditional:
        if quantity.while_known is not None:
            is_set = known[f"{quantity.component}.{quantity.while_known}"] is not None
        else:
            is_set = bool(known[quantity.path])
        mask |= value if is_set else 0
    return mask


def _stored(source: Quantity | Parameter, known: Known) -> int | None:
    if isinstance(source, Parameter):
        return known.get(source.name, source.default)
    value = known[source.path]
    return source.initial if value is None else value


def _cells(binding: SplitBinding, known: Known) -> tuple[int, ...]:
    stored = _stored(binding.source, known)
    count = binding.covers.count
    if stored is None:
        return (binding.unused,) * count
    rest = max(binding.low, min(binding.high, rounded(stored * binding.factor, binding.rounding)))
    full, last = divmod(rest, binding.cell_high)
    cells = [binding.cell_high] * full
    if last or not cells:
        cells.append(last)
    return tuple(cells + [binding.unused] * (count - len(cells)))


def _wire_value(binding: LiveBinding, known: Known) -> int | float:
    stored = _stored(binding.source, known)
    if stored is None:
        assert binding.unknown is not None
        return binding.unknown
    value = max(binding.low, min(binding.high, stored * binding.factor))
    is_integer = binding.covers.field.type.is_integer
    if is_integer:
        value = Fraction(rounded(value, binding.rounding))
    if value == binding.hole:
        assert binding.beside is not None
        value = binding.beside
    return int(value) if is_integer else float(value)


def limits_in_steps(binding: LiveBinding | SplitBinding) -> tuple[int, int]:
    """The smallest and the largest stored value that the field carries unlimited."""
    return math.ceil(binding.low / binding.factor), math.floor(binding.high / binding.factor)


def is_settable(quantity: Quantity) -> bool:
    """Whether tests can set the quantity: not one that follows another."""
    return quantity.while_known is None


def nominal(quantity: Quantity) -> int:
    """A plain value of a quantity: in the middle of its limits, or a small odd number without limits."""
    if quantity.kind is not QuantityKind.NUMBER:
        return quantity.initial or 0
    if abs(quantity.minimum) == abs(quantity.maximum):
        return 1237
    return (quantity.minimum + quantity.maximum) // 2
