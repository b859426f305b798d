"""The way of a value from its sensor, or its row of a table, to the bytes of the payload, step by step."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from codegen.model.system import (
    Binding,
    EachBinding,
    FixedBinding,
    FlagsBinding,
    InstanceBinding,
    LiveBinding,
    PageBinding,
    PartBinding,
    PopulatedMessage,
    SplitBinding,
    System,
    TextBinding,
)
from codegen.model.unit import decimal
from codegen.model.vehicle import Parameter, Quantity
from codegen.targets.quantity_words import becomes_unknown, quantity_source
from codegen.targets.table import FieldRow


@dataclass(frozen=True, slots=True)
class Step:
    """One step: a word for its kind, what happens, more about it, and the criteria that ask for it."""

    kind: str
    text: str
    details: tuple[str, ...]
    criteria: tuple[str, ...]


def way_of(binding: Binding, row: FieldRow, message: PopulatedMessage, system: System) -> tuple[Step, ...]:
    """The steps of a binding of ``message``, the bytes last; ``row`` is what the table says about it."""
    return (*_source(binding, row, message, system), *_fitting(binding, row), _bytes(binding, row))


def _source(binding: Binding, row: FieldRow, message: PopulatedMessage, system: System) -> Iterator[Step]:
    own = (str(binding.covers.citation),)
    match binding:
        case FixedBinding():
            kind = "unknown" if binding.is_unknown else "table"
            text = f"the dialect's {row.sentinel}" if binding.is_unknown and row.sentinel else row.source
            details = ("nothing gives this field a value",) if binding.is_unknown else ()
            yield Step(kind, text, (*details, row.conversion), own)
        case PartBinding():
            component = message.component.name if message.component else "instance"
            parts = (
                f"{component} {number}: {part.meaning} = {part.values[0]!r}"
                for number, part in enumerate(binding.values, 1)
            )
            yield Step("board", f"a fact of each {component}", tuple(parts), own)
        case FlagsBinding():
            yield from _flags(binding, own)
        case EachBinding():
            yield from _each(binding, row, system)
        case SplitBinding() | LiveBinding():
            if isinstance(binding.source, Parameter):
                yield _parameter(binding.source)
            else:
                yield from _quantity(binding.source, system)
        case InstanceBinding() | PageBinding() | TextBinding():
            yield Step("program", row.source, (row.conversion,) if row.conversion else (), own)


def _flags(binding: FlagsBinding, own: tuple[str, ...]) -> Iterator[Step]:
    if binding.names or not binding.conditional:
        yield Step("table", f"always {' + '.join(binding.names) or 'no flag'}", (f"= {binding.mask:#x}",), own)
    for name, value, quantity in binding.conditional:
        details = (f"{value:#x} while {quantity.path} is true", quantity_source(quantity))
        yield Step("condition", f"{name} if {quantity.path}", details, _cited(quantity))


def _quantity(quantity: Quantity, system: System) -> Iterator[Step]:
    conversion = quantity.conversion
    if conversion is not None:
        channel, multiplier = conversion.channel, conversion.multiplier
        component = system.components[quantity.component]
        pins = dict.fromkeys(map(str, system.gpios(component, channel)))
        chosen = f", chosen by {channel.pin.name}" if channel.pin else ""
        yield Step(
            "sensor",
            f"ADC, GPIO {' and '.join(pins)}{chosen}",
            (
                f"mean of {channel.samples} samples of {channel.bits} bits, 0..{channel.full_scale}",
                f"every {component.period_ms or 100} ms",
            ),
            _distinct(channel.cited("samples"), str(channel.citation or "")),
        )
        low, default, high = (
            decimal(steps * multiplier.step) for steps in (multiplier.minimum, multiplier.default, multiplier.maximum)
        )
        yield Step(
            "conversion",
            f"count / {channel.full_scale} * {decimal(channel.reference)} V * {multiplier.name}",
            (f"{multiplier.name} {default} by default, {low}..{high}", f"to the nearest {quantity.stored.name}"),
            _distinct(quantity.cited("multiplier"), quantity.cited("rounding")),
        )
    elif quantity_source(quantity) != "set by the vehicle" or quantity.kind.value != "number":
        yield Step("source", quantity_source(quantity), (), _cited(quantity))
    else:
        yield Step("source", "set by the vehicle", ("no ADC channel measures it",), _cited(quantity))
    kept = f"kept as {quantity.attribute}{f', in {quantity.stored.name}' if quantity.stored.name else ''}"
    start = "unknown" if quantity.initial is None else str(quantity.initial)
    lost = becomes_unknown(quantity)
    details = (kept, f"{start} at the start", *((f"unknown {lost}",) if lost else ()))
    criteria = _distinct(str(quantity.citation or ""), *((quantity.cited("invalid_after"),) if lost else ()))
    yield Step("state", quantity.path, details, criteria)


def _parameter(parameter: Parameter) -> Step:
    low, default, high = (
        decimal(steps * parameter.step) for steps in (parameter.minimum, parameter.default, parameter.maximum)
    )
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    text = " and ".join(parameter.siblings) or parameter.name
    return Step("parameter", text, (f"{default}{unit} by default, {low}..{high}{unit}",), _cited(parameter))


def _each(binding: EachBinding, row: FieldRow, system: System) -> Iterator[Step]:
    """The values one by one; where they stand in for a quantity that is spread over the elements, that one first."""
    own = (str(binding.covers.citation),)
    all_known = (f"while all are known and no more than {binding.room}",) if binding.room is not None else ()
    if binding.fallback is None:
        yield from _quantity(binding.source, system)
        yield Step("elements", row.source, all_known, own)
        return
    yield from _quantity(binding.fallback.source, system)
    *source, state = _quantity(binding.source, system)
    origin = tuple(step.text for step in source)
    yield Step(
        "instead",
        f"each of {binding.source.path}, if there are such",
        (*all_known, *origin, *state.details),
        _distinct(*own, *state.criteria),
    )


def _fitting(binding: Binding, row: FieldRow) -> Iterator[Step]:
    """Unit, limits and what stands for unknown, of what is read when the message is built."""
    if not isinstance(binding, LiveBinding | SplitBinding | EachBinding):
        return
    unit = binding.covers.field.definition.units or ""
    if binding.factor != 1:
        yield Step("unit", row.conversion, (), ())
    details = []
    if not isinstance(binding, SplitBinding) and binding.hole is not None and binding.beside is not None:
        hole, beside = decimal(Fraction(binding.hole)), decimal(Fraction(binding.beside))
        details.append(f"{hole} would read as unknown and becomes {beside}")
    spill = binding if isinstance(binding, SplitBinding) else getattr(binding, "fallback", None)
    if spill is not None:
        details.append(f"what is above {spill.cell_high} spills into the next element")
    limits = f"{decimal(Fraction(binding.low))}..{decimal(Fraction(binding.high))}"
    yield Step("limits", f"{limits} {unit}".strip(), tuple(details), (str(binding.covers.citation),))
    unknown = binding.unused if isinstance(binding, SplitBinding) else binding.unknown
    if unknown is not None:
        shown = "NaN" if math.isnan(unknown) else f"{unknown}"
        written = f", the dialect's {row.sentinel}" if row.sentinel and row.sentinel != shown else ""
        yield Step("unknown", f"{shown}{written}", ("goes out while the value is not known",), ())


def _bytes(binding: Binding, row: FieldRow) -> Step:
    last = row.offset + row.size - 1
    where = f"byte {row.offset}" if row.size == 1 else f"bytes {row.offset} to {last}"
    size = binding.covers.field.type.size
    order = ("least significant byte first",) if size > 1 else ()
    return Step("wire", f"{row.type.removesuffix(' ext')}, {where}", order, ())


def _cited(thing: Quantity | Parameter) -> tuple[str, ...]:
    return _distinct(str(thing.citation or ""))


def _distinct(*names: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for name in names if name))
