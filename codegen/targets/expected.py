"""What a message must carry for a given state, by exact arithmetic on the resolved system.

The generated tests and the tests of the generator take their expected values from here; nothing of the firmware is
involved.
"""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

from codegen.model.population_spec import Rounding
from codegen.model.system import (
    Binding,
    EachBinding,
    FixedBinding,
    FlagsBinding,
    InstanceBinding,
    LiveBinding,
    PageBinding,
    PartBinding,
    Policy,
    PopulatedMessage,
    Representation,
    SplitBinding,
    TextBinding,
)
from codegen.model.unit import UNITS, Measure
from codegen.model.vehicle import Parameter, Quantity, QuantityKind

Stored = int | tuple[int | None, ...] | None
"""A stored integer, or one for each element; None is unknown, a boolean is 0 or 1."""

Known = Mapping[str, Stored]
"""What is stored by ``component.quantity`` or name of a parameter."""

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


MOCK_CHIP = bytes.fromhex("e6613852831b2c21")
"""What the mocked board says when it is asked for the number of its chip."""


def expected_fields(message: PopulatedMessage, known: Known, instance: int = 0, page: int = 0) -> dict[str, Wire]:
    """Every field of ``message`` by name, as pymavlink takes them, while the state is ``known``.

    ``known`` is about the instance that the message is for, or about the one that it represents.
    """
    elements: dict[str, dict[int, int | float | str]] = {}
    for binding in message.bindings:
        covers = binding.covers
        for index, value in enumerate(_values(binding, known, instance, page)):
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


def chosen_instance(choice: Representation, instances: Sequence[Known]) -> int:
    """Which instance is represented; ``instances`` has what is known of each of them, and of the parameter."""
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
            (value, number) for number in on if (value := _single(instances[number], choice.quantity.path)) is not None
        ]
        if values:
            return min(values)[1]
    return on[0] if on else 0


def _values(binding: Binding, known: Known, instance: int, page: int) -> tuple[int | float | str, ...]:
    match binding:
        case FixedBinding():
            return binding.values
        case PartBinding():
            return binding.values[instance].values
        case TextBinding():
            return (MOCK_CHIP.hex()[: binding.covers.field.count],)
        case InstanceBinding():
            return ((_stored(binding.first, known) or 0) + instance if binding.first else instance,)
        case PageBinding():
            return (page * binding.size,)
        case FlagsBinding():
            return (_flags(binding, known, instance),) * binding.covers.count
        case SplitBinding():
            return _cells(binding, known)
        case EachBinding():
            return _each(binding, known, page)
        case LiveBinding():
            return (_wire_value(binding, known),)


def _each(binding: EachBinding, known: Known, page: int) -> tuple[int | float, ...]:
    stored = known[binding.source.path]
    values = stored if isinstance(stored, tuple) else ()
    count = binding.covers.count
    if binding.room is not None and (None in values or not 0 < len(values) <= binding.room):
        return (binding.unknown,) * count if binding.fallback is None else _cells(binding.fallback, known)
    first = page * count if binding.is_paged else binding.first
    row = values[first : first + count]
    sent = [binding.unknown if value is None else _carried(binding, value) for value in row]
    return (*sent, *[binding.unknown] * (count - len(sent)))


def _flags(binding: FlagsBinding, known: Known, instance: int) -> int:
    mask = binding.mask
    for _, value, quantity in binding.conditional:
        if quantity.follows is not None:
            number = instance if instance < len(quantity.follows.limits) else 0
            is_set = quantity.follows.holds(_single(known, f"{quantity.component}.{quantity.followed}"), number)
        elif quantity.while_known is not None:
            is_set = known[f"{quantity.component}.{quantity.while_known}"] is not None
        else:
            is_set = bool(known[quantity.path])
        mask |= value if is_set else 0
    return mask


def _single(known: Known, name: str) -> int | None:
    value = known[name]
    assert not isinstance(value, tuple)
    return value


def _stored(source: Quantity | Parameter, known: Known) -> int | None:
    if isinstance(source, Parameter):
        return _single(known, source.name) if source.name in known else source.default
    value = _single(known, source.path)
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
    return _carried(binding, stored)


def _carried(binding: LiveBinding | EachBinding, stored: int) -> int | float:
    value = max(binding.low, min(binding.high, stored * binding.factor))
    is_integer = binding.covers.field.type.is_integer
    if is_integer:
        value = Fraction(rounded(value, binding.rounding))
    if value == binding.hole:
        assert binding.beside is not None
        value = binding.beside
    return int(value) if is_integer else float(value)


def limits_in_steps(binding: LiveBinding | SplitBinding | EachBinding) -> tuple[int, int]:
    """The smallest and the largest stored value that the field carries unlimited."""
    return math.ceil(binding.low / binding.factor), math.floor(binding.high / binding.factor)


def is_settable(quantity: Quantity) -> bool:
    """Whether tests can set the quantity: not one that follows another."""
    return quantity.followed is None


def nominal_values(quantity: Quantity, instance: int) -> Stored:
    """A plain value, or a different one for each element of the instance."""
    plain = nominal(quantity)
    if quantity.elements is None:
        return plain
    count = quantity.elements[instance]
    return tuple(max(quantity.minimum, min(quantity.maximum, plain + 7 * index)) for index in range(count))


def nominal(quantity: Quantity) -> int:
    """A plain value of a quantity: in the middle of its limits, or a small odd number without limits."""
    if quantity.kind is not QuantityKind.NUMBER:
        return quantity.initial or 0
    if abs(quantity.minimum) == abs(quantity.maximum):
        return 1237
    return (quantity.minimum + quantity.maximum) // 2
