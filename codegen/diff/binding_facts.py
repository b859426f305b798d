"""What there is to say about where the elements of a field take their values from."""

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import NamedTuple

from codegen.diff import behaviour_rules as rules
from codegen.diff.change import ChangeRule
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
    SplitBinding,
    TextBinding,
)
from codegen.model.unit import decimal
from codegen.model.vehicle import Quantity


class BindingFact(NamedTuple):
    """One attribute of a binding, as text."""

    attribute: str
    text: str
    rule: ChangeRule


def binding_facts(binding: Binding, index: int) -> Iterator[BindingFact]:
    """The facts about the element ``index`` of the field, from 0."""
    yield from _READERS[type(binding)](binding, index - binding.covers.first)


def _fixed(binding: FixedBinding, position: int) -> Iterator[BindingFact]:
    value = binding.values[position] if position < len(binding.values) else binding.values[-1]
    shown = _number(value)
    if binding.is_unknown:
        yield BindingFact("source", "unknown", rules.SOURCE)
        yield BindingFact("unknown", shown, rules.UNKNOWN)
        return
    yield BindingFact("source", "constant", rules.SOURCE)
    text = shown if binding.meaning in ("", shown) else f"{shown} ({binding.meaning})"
    yield BindingFact("value", text, rules.CONSTANT)


def _part(binding: PartBinding, position: int) -> Iterator[BindingFact]:
    yield BindingFact("source", "a fact of each instance", rules.SOURCE)
    for number, value in enumerate(binding.values, 1):
        for fact in _fixed(value, position):
            if fact.attribute == "value":
                yield BindingFact(f"value of instance {number}", fact.text, rules.CONSTANT)


def _text(binding: TextBinding, _position: int) -> Iterator[BindingFact]:
    yield BindingFact("source", f"text {binding.source}", rules.SOURCE)


def _instance(binding: InstanceBinding, _position: int) -> Iterator[BindingFact]:
    first = f", counted from {binding.first.name}" if binding.first else ""
    yield BindingFact("source", f"number of the {binding.component}{first}", rules.SOURCE)


def _page(binding: PageBinding, _position: int) -> Iterator[BindingFact]:
    yield BindingFact("source", f"number of the first value of a page of {binding.size}", rules.SOURCE)


def _flags(binding: FlagsBinding, _position: int) -> Iterator[BindingFact]:
    yield BindingFact("source", "flags", rules.SOURCE)
    for name in binding.names:
        yield BindingFact(name, "always", rules.FLAGS)
    for name, value, quantity in binding.conditional:
        yield BindingFact(name, f"({value:#x}) if {quantity.path}", rules.FLAGS)
    yield BindingFact("bits always set", f"{binding.mask:#x}", rules.FLAGS)


def _live(binding: LiveBinding, _position: int) -> Iterator[BindingFact]:
    yield BindingFact("source", binding.source.path, rules.SOURCE)
    yield from _converted(binding)
    yield BindingFact("limits", _limits(binding), rules.LIMITS)
    yield BindingFact("unknown", "" if binding.unknown is None else _number(binding.unknown), rules.UNKNOWN)


def _split(binding: SplitBinding, _position: int) -> Iterator[BindingFact]:
    yield BindingFact("source", f"{binding.source.path}, spilling over", rules.SOURCE)
    yield from _converted(binding)
    limits = f"{binding.low}..{binding.high}, {binding.cell_high} an element"
    yield BindingFact("limits", limits, rules.LIMITS)
    yield BindingFact("unknown", str(binding.unused), rules.UNKNOWN)


def _each(binding: EachBinding, position: int) -> Iterator[BindingFact]:
    shift = binding.first - binding.covers.first  # so that the elements of a field say the same
    number = "i" if not shift else f"i {'+' if shift > 0 else '-'} {abs(shift)}"
    paged = " of the page" if binding.is_paged else ""
    room = "" if binding.room is None else f", while all of at most {binding.room} are known"
    yield BindingFact("source", f"value {number}{paged} of {binding.source.path} in element i{room}", rules.SOURCE)
    yield from _converted(binding)
    yield BindingFact("limits", _limits(binding), rules.LIMITS)
    yield BindingFact("unknown", str(binding.unknown), rules.UNKNOWN)
    if binding.fallback is not None:
        for fact in _split(binding.fallback, position):
            yield BindingFact(f"otherwise {fact.attribute}", fact.text, fact.rule)


def _converted(binding: LiveBinding | SplitBinding | EachBinding) -> Iterator[BindingFact]:
    source = binding.source
    kept = (source.stored.name if isinstance(source, Quantity) else source.unit.name) or "value"
    unit = binding.covers.field.definition.units or ""
    factor = "" if binding.factor == 1 else f" * {decimal(binding.factor)}"
    rounding = "" if binding.rounding is Rounding.NEAREST else f", rounded {binding.rounding.value.replace('_', ' ')}"
    text = f"{kept}{factor}{f' = {unit}' if unit else ''}{rounding}"
    yield BindingFact("conversion", text, rules.CONVERSION)


def _limits(binding: LiveBinding | EachBinding) -> str:
    text = f"{decimal(Fraction(binding.low))}..{decimal(Fraction(binding.high))}"
    if binding.hole is not None and binding.beside is not None:
        text += f", {decimal(binding.hole)} as {decimal(binding.beside)}"
    return text


def _number(value: int | float | str) -> str:
    if isinstance(value, float):
        return "NaN" if math.isnan(value) else repr(value)
    return str(value) if isinstance(value, int) else f'"{value}"'


_READERS: dict[type, Callable[..., Iterator[BindingFact]]] = {
    FixedBinding: _fixed,
    PartBinding: _part,
    TextBinding: _text,
    InstanceBinding: _instance,
    PageBinding: _page,
    FlagsBinding: _flags,
    LiveBinding: _live,
    SplitBinding: _split,
    EachBinding: _each,
}
