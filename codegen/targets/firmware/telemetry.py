"""View of telemetry.py: one builder per populated message, ready to print."""

from dataclasses import dataclass

from codegen.model.dialect import Kind, WireField
from codegen.model.system import (
    Elements,
    FixedBinding,
    FlagsBinding,
    InstanceBinding,
    LiveBinding,
    PopulatedMessage,
    SplitBinding,
    System,
    read_quantities,
)
from codegen.targets.firmware.live import FlagByteView, LiveView, SpillView, live_views
from codegen.targets.naming import builder_name, class_name, instance_expression, number, quoted


@dataclass(frozen=True, slots=True)
class FixedView:
    """A line of the prefilled payload: a statement with its comment, or only a comment where the bytes stay zero."""

    statement: str
    comment: str


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
        for quantity in read_quantities(binding):
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
        live=tuple(view for binding in message.bindings for view in live_views(binding)),
    )


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
    shown = [number(value) for value in values]
    if len(values) == 1:
        return FixedView(_packed(field, covers.offset, shown[0]), comment)
    code = f'"<{len(values)}{field.type.code}"'
    listed = f"*[{shown[0]}] * {len(shown)}" if len(set(shown)) == 1 else ", ".join(shown)
    return FixedView(f"pack_into({code}, payload, {covers.offset}, {listed})", comment)


def _packed(field: WireField, offset: int, value: str) -> str:
    if field.type.code == "B":
        return f"payload[{offset}] = {value}"
    return f'pack_into("<{field.type.code}", payload, {offset}, {value})'
