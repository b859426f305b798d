"""View of telemetry.py: one builder per populated message, ready to print."""

import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from codegen.model.dialect import Kind, WireField
from codegen.model.spec import Rounding
from codegen.model.system import (
    Binding,
    Elements,
    FixedBinding,
    FlagsBinding,
    InstanceBinding,
    LiveBinding,
    Parameter,
    PopulatedMessage,
    Quantity,
    SplitBinding,
    System,
)
from codegen.targets.naming import builder_name, class_name, instance_expression, parameter_attribute, quoted


@dataclass(frozen=True, slots=True)
class FixedView:
    """A line of the prefilled payload: a statement with its comment, or only a comment where the bytes stay zero."""

    statement: str
    comment: str


@dataclass(frozen=True, slots=True)
class LiveView:
    """A field that is written on every build."""

    comment: str
    source: str
    code: str
    offset: int
    unknown: str | None
    unknown_comment: str
    before: tuple[str, str] | None
    scale: tuple[str, int, int] | None
    low: str
    high: str
    hole: str | None
    beside: str
    divisor: str | None


@dataclass(frozen=True, slots=True)
class SpillView:
    """An array field over which one value is spread on every build."""

    comment: str
    source: str
    code: str
    offset: int
    size: int
    cells: int
    low: int
    high: int
    before: tuple[str, str] | None
    scale: tuple[str, int, int] | None
    cell_high: int
    unused: int


@dataclass(frozen=True, slots=True)
class FlagByteView:
    """A byte of a bitmask some bits of which depend on the state."""

    comment: tuple[str, ...]
    offset: int
    expression: str


@dataclass(frozen=True, slots=True)
class BuilderView:
    """One message: its class, its prefilled payload and the statements of its builder."""

    name: str
    id: int
    class_name: str
    function: str
    prefill: str
    store: str
    citation: str
    instances: int
    is_for_each: bool
    components: tuple[tuple[str, str, bool], ...]
    fixed: tuple[FixedView, ...]
    live: tuple[LiveView | SpillView | FlagByteView, ...]


@dataclass(frozen=True, slots=True)
class TelemetryView:
    """The module: the builders in order of message id, and the names that it imports from conversion."""

    builders: tuple[BuilderView, ...]
    conversions: tuple[str, ...]
    uses_nan: bool
    uses_clock: bool


def telemetry_view(system: System) -> TelemetryView:
    """The view of the whole module."""
    builders = tuple(_builder(message, system) for message in system.messages)
    used: set[str] = set()
    for builder in builders:
        for view in builder.live:
            if isinstance(view, LiveView | SpillView):
                used.add("limited")
                used.update([view.scale[0]] if view.scale else [])
            used.update(["spill"] if isinstance(view, SpillView) else [])
    unknowns = [view.unknown for builder in builders for view in builder.live if isinstance(view, LiveView)]
    prefilled = [fixed.statement for builder in builders for fixed in builder.fixed]
    return TelemetryView(
        builders=builders,
        conversions=tuple(sorted(used)),
        uses_nan="NAN" in unknowns or any("NAN" in statement for statement in prefilled),
        uses_clock=any(expires for builder in builders for _, _, expires in builder.components),
    )


def _builder(message: PopulatedMessage, system: System) -> BuilderView:
    components = {}
    for binding in message.bindings:
        for quantity in _quantities(binding):
            component = system.components[quantity.component]
            expires = any(known.stale_after_ms is not None for known in component.quantities.values())
            is_each = message.component is not None and message.component.name == component.name
            components[component.name] = (component.name, instance_expression(component, is_each), expires)
    lowered = message.name.lower()
    return BuilderView(
        name=message.name,
        id=message.wire.id,
        class_name=class_name(message.name),
        function=builder_name(message),
        prefill=f"_new_{lowered}",
        store=f"_{lowered}",
        citation=str(message.citation),
        instances=message.instances,
        is_for_each=message.component is not None,
        components=tuple(components[name] for name in sorted(components)),
        fixed=tuple(
            _fixed(binding) for binding in message.bindings if not isinstance(binding, LiveBinding | SplitBinding)
        ),
        live=tuple(view for binding in message.bindings for view in _live(binding)),
    )


def _quantities(binding: Binding) -> tuple[Quantity, ...]:
    if isinstance(binding, FlagsBinding):
        return tuple(quantity for _, _, quantity in binding.conditional)
    if isinstance(binding, LiveBinding | SplitBinding) and isinstance(binding.source, Quantity):
        return (binding.source,)
    return ()


def _fixed(binding: FixedBinding | FlagsBinding | InstanceBinding) -> FixedView:
    covers = binding.covers
    field = covers.field
    if isinstance(binding, InstanceBinding):
        return FixedView(_packed(field, covers.offset, "instance"), f"{covers.label}: the {binding.component}'s number")
    if isinstance(binding, FlagsBinding):
        words = " | ".join(binding.names) or "no flag"
        return _prefilled(covers, (binding.mask,) * covers.count, words)
    return _prefilled(covers, binding.values, binding.meaning)


def _prefilled(covers: Elements, values: tuple[int | float | str, ...], meaning: str) -> FixedView:
    comment = f"{covers.label}: {meaning}"
    field = covers.field
    if field.type.kind is Kind.CHAR:
        text = str(values[0])
        return FixedView(f'message.set("{field.name}", {quoted(text)})' if text else "", comment)
    if all(value == 0 for value in values):
        return FixedView("", f"{comment}, 0" if str(meaning) != "0" else comment)
    shown = [_number(value) for value in values]
    if len(values) == 1:
        return FixedView(_packed(field, covers.offset, shown[0]), comment)
    code = f'"<{len(values)}{field.type.code}"'
    listed = f"*[{shown[0]}] * {len(shown)}" if len(set(shown)) == 1 else ", ".join(shown)
    return FixedView(f"pack_into({code}, payload, {covers.offset}, {listed})", comment)


def _packed(field: WireField, offset: int, value: str) -> str:
    if field.type.code == "B":
        return f"payload[{offset}] = {value}"
    return f'pack_into("<{field.type.code}", payload, {offset}, {value})'


def _number(value: int | float | str) -> str:
    if isinstance(value, float) and math.isnan(value):
        return "NAN"
    return str(value)


def _live(binding: Binding) -> Iterator[LiveView | SpillView | FlagByteView]:
    if isinstance(binding, LiveBinding):
        yield _float_view(binding) if binding.covers.field.type.kind is Kind.FLOAT else _integer_view(binding)
    elif isinstance(binding, SplitBinding):
        yield _spill_view(binding)
    elif isinstance(binding, FlagsBinding):
        yield from _flag_bytes(binding)


def _comment(binding: LiveBinding | SplitBinding) -> str:
    covers, source = binding.covers, binding.source
    units = covers.field.definition.units
    written = source.name if isinstance(source, Parameter) else source.path
    kept = source.stored.name if isinstance(source, Quantity) else source.unit.name
    spread = f", spilling above {binding.cell_high}" if isinstance(binding, SplitBinding) else ""
    target = f"{covers.label} [{units}]" if units else covers.label
    origin = f"{written} [{kept}]" if kept and kept != units else written
    return f"{target}: {origin}{spread} ({covers.citation})"


def _source(source: Quantity | Parameter) -> str:
    if isinstance(source, Parameter):
        return f"state.parameters.{parameter_attribute(source.name)}"
    return f"{source.component}.{source.attribute}"


def _scale(factor: Fraction, rounding: Rounding) -> tuple[str, int, int] | None:
    return None if factor == 1 else (rounding.value, factor.numerator, factor.denominator)


def _before(factor: Fraction, low: Fraction, high: Fraction) -> tuple[str, str] | None:
    """Limits in stored steps, one step wider than the field, that keep the product of the scaling small."""
    if factor == 1:
        return None
    return str(math.floor(low / factor) - 1), str(math.ceil(high / factor) + 1)


def _stand_in(source: Quantity | Parameter) -> str | None:
    initial = source.initial if isinstance(source, Quantity) else None
    return None if initial is None else str(initial)


def _integer_view(binding: LiveBinding) -> LiveView:
    assert binding.unknown is None or isinstance(binding.unknown, int)
    unknown = _stand_in(binding.source) if binding.unknown is None else str(binding.unknown)
    return LiveView(
        comment=_comment(binding),
        source=_source(binding.source),
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        unknown=unknown,
        unknown_comment="unknown" if binding.unknown is not None else "until it is set",
        before=_before(binding.factor, binding.low, binding.high),
        scale=_scale(binding.factor, binding.rounding),
        low=str(binding.low),
        high=str(binding.high),
        hole=None if binding.hole is None else str(binding.hole),
        beside=str(binding.beside),
        divisor=None,
    )


def _float_view(binding: LiveBinding) -> LiveView:
    """A float field: everything up to the last division happens in stored steps."""
    factor = binding.factor
    unknown = _stand_in(binding.source) if binding.unknown is None else _number(binding.unknown)
    if binding.unknown is None and isinstance(binding.source, Quantity) and binding.source.initial is not None:
        unknown = repr(float(binding.source.initial * factor))
    low, high = math.ceil(binding.low / factor), math.floor(binding.high / factor)
    hole = None if binding.hole is None else binding.hole / factor
    divided = f" * {factor.numerator}" if factor.numerator != 1 else ""
    return LiveView(
        comment=_comment(binding),
        source=_source(binding.source),
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        unknown=unknown,
        unknown_comment="unknown" if binding.unknown is not None else "until it is set",
        before=None,
        scale=None,
        low=str(low),
        high=str(high),
        hole=str(hole) if hole is not None and hole.denominator == 1 else None,
        beside="" if binding.beside is None else str(binding.beside / factor),
        divisor=f"{divided} / {factor.denominator}",
    )


def _spill_view(binding: SplitBinding) -> SpillView:
    low, high = Fraction(binding.low), Fraction(binding.high)
    return SpillView(
        comment=_comment(binding),
        source=_source(binding.source),
        code=f"<{binding.covers.field.type.code}",
        offset=binding.covers.offset,
        size=binding.covers.field.type.size,
        cells=binding.covers.count,
        low=binding.low,
        high=binding.high,
        before=_before(binding.factor, low, high),
        scale=_scale(binding.factor, binding.rounding),
        cell_high=binding.cell_high,
        unused=binding.unused,
    )


def _flag_bytes(binding: FlagsBinding) -> Iterator[FlagByteView]:
    covers = binding.covers
    size = covers.field.type.size
    terms: dict[int, list[str]] = {}
    words = []
    for name, value, quantity in binding.conditional:
        words.append(f"{name} if {quantity.path}")
        for index, byte in enumerate(struct.pack("<Q", value)[:size]):
            if byte:
                source = f"{quantity.component}.{quantity.attribute}"
                terms.setdefault(index, []).append(f"({byte:#04x} if {source} else 0)")
    comment = _flag_comment(f"{covers.label}:", words, f"({covers.citation})")
    for index in sorted(terms):
        always = struct.pack("<Q", binding.mask)[index]
        parts = [f"{always:#04x}"] * bool(always) + terms[index]
        expression = " | ".join(parts) if len(parts) > 1 else parts[0].strip("()")
        yield FlagByteView(comment, covers.offset + index, expression)
        comment = ()


def _flag_comment(label: str, words: list[str], citation: str) -> tuple[str, ...]:
    """One line, or, where that gets long, a line for each flag."""
    line = f"{label} {', '.join(words)} {citation}"
    return (line,) if len(line) < 100 else (f"{label} {citation}", *(f"  {word}" for word in words))
