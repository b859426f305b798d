"""One row per binding, as documents and ``explain`` print it."""

import math
from dataclasses import dataclass
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
    PopulatedMessage,
    SplitBinding,
    TextBinding,
)
from codegen.model.unit import decimal
from codegen.model.vehicle import Quantity
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class FieldRow:
    """What there is to say about the covered elements of one answer, as text; ``place`` is the answer's."""

    offset: int
    size: int
    field: str
    type: str
    unit: str
    source: str
    conversion: str
    limits: str
    sentinel: str
    criterion: str
    place: Place


def field_rows(message: PopulatedMessage) -> tuple[FieldRow, ...]:
    """The rows of a message, in wire order."""
    return tuple(_row(binding) for binding in message.bindings)


def _row(binding: Binding) -> FieldRow:
    covers = binding.covers
    field = covers.field
    length = f"[{field.count}]" if field.is_array else ""
    extension = " ext" if field.definition.is_extension else ""
    source, conversion, limits = _story(binding)
    return FieldRow(
        offset=covers.offset,
        size=covers.count * field.type.size,
        field=covers.label,
        type=f"{field.type.name}{length}{extension}",
        unit=field.definition.units or "",
        source=source,
        conversion=conversion,
        limits=limits,
        sentinel=_sentinel(binding),
        criterion=str(covers.citation),
        place=covers.answer.place,
    )


def _story(binding: Binding) -> tuple[str, str, str]:
    """Source, conversion and limits in words."""
    if isinstance(binding, FixedBinding):
        values = {_shown(value) for value in binding.values}
        shown = values.pop() if len(values) == 1 else ", ".join(_shown(value) for value in binding.values)
        text = "unknown" if binding.is_unknown else binding.meaning
        return text, f"= {shown}", ""
    if isinstance(binding, PartBinding):
        by_instance = (f"{part.meaning} = {_shown(part.values[0])}" for part in binding.values)
        return "fact of each", ", ".join(by_instance), ""
    if isinstance(binding, InstanceBinding):
        counted = f", from {binding.first.name} on" if binding.first else ""
        return f"number of the {binding.component}{counted}", "", ""
    if isinstance(binding, TextBinding):
        return "number of the chip", "in hex", ""
    if isinstance(binding, PageBinding):
        return "number of the first value", f"{binding.size} on a page", ""
    if isinstance(binding, FlagsBinding):
        words = [*binding.names, *(f"{name} if {quantity.path}" for name, _, quantity in binding.conditional)]
        always = f"= {binding.mask:#x}" if binding.mask or not binding.conditional else ""
        return " + ".join(words) or "no flag", always, ""
    if isinstance(binding, EachBinding):
        return _elements(binding)
    kept = binding.source.stored.name if isinstance(binding.source, Quantity) else binding.source.unit.name
    return binding.source.path, _conversion(binding, kept), _limits(binding)


def _elements(binding: EachBinding) -> tuple[str, str, str]:
    start = f"from {binding.first}" if binding.first else ""
    source = ", ".join(word for word in (f"each of {binding.source.path}", start) if word)
    if binding.is_paged:
        source += ", by pages"
    if binding.fallback is not None:
        source += f", else {binding.fallback.source.path}"
    elif binding.room is not None:
        source += ", while all are known"
    conversion = _conversion(binding, binding.source.stored.name)
    if binding.fallback is not None:
        conversion += f"; else spills above {binding.fallback.cell_high}"
    return source, conversion, _limits(binding)


def _conversion(binding: LiveBinding | SplitBinding | EachBinding, kept: str) -> str:
    unit = binding.covers.field.definition.units or ""
    if binding.factor == 1:
        text = f"kept in {kept}" if kept else ""
    else:
        text = f"{kept} * {decimal(binding.factor)} = {unit}, {_ROUNDING[binding.rounding]}"
    if isinstance(binding, SplitBinding):
        spread = f"spills above {binding.cell_high}"
        text = f"{text}, {spread}" if text else spread
    return text


_ROUNDING = {
    Rounding.NEAREST: "to nearest",
    Rounding.DOWN: "down",
    Rounding.UP: "up",
    Rounding.TOWARD_ZERO: "toward zero",
}


def _limits(binding: LiveBinding | SplitBinding | EachBinding) -> str:
    text = f"{_number(binding.low)}..{_number(binding.high)}"
    if not isinstance(binding, SplitBinding) and binding.hole is not None and binding.beside is not None:
        text += f", {_number(binding.hole)} -> {_number(binding.beside)}"
    return text


def _sentinel(binding: Binding) -> str:
    sentinel = binding.covers.field.sentinel
    return "" if sentinel is None else sentinel.written


def limit_text(quantity: Quantity) -> str:
    """When a boolean that follows a limit is true: ``at least 4.25 V per cell``."""
    spec = quantity.spec
    limit = spec.at_least if spec.below is None else spec.below
    assert quantity.follows is not None
    assert limit is not None
    word = "below" if quantity.follows.is_below else "at least"
    return f"{word} {decimal(limit)}{' per cell' if spec.per_cell else ''}"


def _number(value: int | Fraction) -> str:
    return decimal(Fraction(value))


def _shown(value: int | float | str) -> str:
    if isinstance(value, float) and math.isnan(value):
        return "NaN"
    return repr(value)


def in_table(text: str) -> str:
    """Text for a cell of a Markdown table: in one line, its bars marked as text."""
    return " ".join(text.split()).replace("|", "\\|")
