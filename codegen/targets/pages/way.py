"""The way of a value from its sensor, or its row of a table, to the bytes of the payload, step by step."""

from collections.abc import Iterator
from dataclasses import dataclass

from codegen.model.account import Origins, Step
from codegen.model.answer import Answer
from codegen.model.system import System
from codegen.model.unit import decimal
from codegen.model.vehicle import Parameter, Quantity
from codegen.targets.quantity_words import becomes_unknown, quantity_source
from codegen.targets.table import FieldRow


def way_of(answer: Answer, row: FieldRow, system: System) -> tuple[Step, ...]:
    """The steps of an answer, the bytes last; ``row`` is what the table says about it."""
    return (*answer.way(_Origins(system)), _bytes(answer, row))


@dataclass(frozen=True, slots=True)
class _Origins(Origins):
    """The steps up to what the state or the parameters of a system keep."""

    system: System

    def steps(self, source: Quantity | Parameter) -> tuple[Step, ...]:
        """From the sensor, or whatever gives the value, to where it is kept."""
        return (_parameter(source),) if isinstance(source, Parameter) else tuple(_quantity(source, self.system))

    def words(self, quantity: Quantity) -> str:
        """What gives a quantity its value."""
        return quantity_source(quantity)


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


def _bytes(answer: Answer, row: FieldRow) -> Step:
    last = row.offset + row.size - 1
    where = f"byte {row.offset}" if row.size == 1 else f"bytes {row.offset} to {last}"
    size = answer.covers.field.type.size
    order = ("least significant byte first",) if size > 1 else ()
    return Step("wire", f"{row.type.removesuffix(' ext')}, {where}", order, ())


def _cited(thing: Quantity | Parameter) -> tuple[str, ...]:
    return _distinct(str(thing.citation or ""))


def _distinct(*names: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for name in names if name))
