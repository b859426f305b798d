"""Limits of a table that reach beyond what the field can carry."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import LiveBinding, Parameter, QuantityKind, System
from codegen.model.unit import UNITS, read_measure

RULE = Rule(
    "limit-beyond-field",
    "A limit of a table lies beyond what the field, the dialect or the quantity allows, or is the sentinel: it would "
    "have no effect. Correct it or leave it out.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """min and max of every live field."""
    for message in system.messages:
        for binding in message.bindings:
            if isinstance(binding, LiveBinding):
                yield from _limits(binding)


def _limits(binding: LiveBinding) -> Iterator[Diagnostic]:
    answer = binding.covers.answer
    for key, written, reached in (("min", answer.min, binding.low), ("max", answer.max, binding.high)):
        value = _in_wire_units(binding, written)
        if value is None:
            continue
        if (key == "min" and reached > value + 1) or (key == "max" and reached < value - 1) or value == binding.unknown:
            limits = f"{binding.low} to {binding.high}"
            yield Diagnostic(
                answer.at(key), RULE, f"{key} of {binding.covers.label} is {value}, but it carries {limits} only"
            )


def _in_wire_units(binding: LiveBinding, written: str | Fraction | None) -> Fraction | None:
    source, units = binding.source, binding.covers.field.definition.units
    if written is None:
        return None
    if isinstance(written, str):
        measure = read_measure(written)
        return measure.in_unit(UNITS[units]) if measure and units else None
    if not isinstance(source, Parameter) and source.kind is not QuantityKind.NUMBER:
        return written
    factor = source.unit.to(UNITS[units]) if units else Fraction(1)
    return None if factor is None else written * factor
