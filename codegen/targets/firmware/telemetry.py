"""View of telemetry.py: one builder per populated message, ready to print."""

from collections import Counter
from dataclasses import dataclass
from textwrap import wrap

from codegen.answers.fact import FactAnswer
from codegen.answers.fixed import FixedAnswer
from codegen.answers.flags import FlagsAnswer
from codegen.answers.instance import InstanceAnswer
from codegen.answers.page import PageAnswer
from codegen.answers.text import TextAnswer
from codegen.model.answer import Answer, Elements
from codegen.model.dialect import Kind, WireField
from codegen.model.system import Policy, PopulatedMessage, Representation, System
from codegen.model.vehicle import Component
from codegen.targets.firmware.live import live_names, live_views, writes_payload
from codegen.targets.firmware.live_view import EachView, FlagByteView, LiveView, SpillView, View
from codegen.targets.naming import (
    builder_name,
    class_names,
    instance_expression,
    number,
    parameter_attribute,
    prefill_name,
    quoted,
)


@dataclass(frozen=True, slots=True)
class FixedView:
    """A line of the prefilled payload: a statement with its comment, or only a comment where the bytes stay zero.

    What gets too long for one line has its comment in the lines ``above``.
    """

    statement: str
    comment: str

    @property
    def above(self) -> tuple[str, ...]:
        """The comment in lines of its own, or nothing."""
        is_long = self.statement and len(self.statement) + len(self.comment) > 110
        return tuple(wrap(self.comment, 110)) if is_long else ()


@dataclass(frozen=True, slots=True)
class ChoiceView:
    """The function that chooses which of several instances a single message is about."""

    function: str
    component: str
    message: str
    instances: int
    parameter: str | None
    parameter_name: str
    lowest: str | None
    lowest_name: str
    enabled: str | None
    expires: bool


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
    is_paged: bool
    chosen: tuple[ChoiceView, ...]
    components: tuple[tuple[str, str], ...]
    expiring: tuple[str, ...]
    fixed: tuple[FixedView, ...]
    live_names: tuple[str, ...]
    live: tuple[View, ...]
    uses_wire: bool


@dataclass(frozen=True, slots=True)
class TelemetryView:
    """The module: the builders in order of message id, and the names that it imports from conversion."""

    builders: tuple[BuilderView, ...]
    conversions: tuple[str, ...]
    uses_nan: bool
    uses_chip: bool
    packs: bool
    puts_floats: bool
    machine_code: bool


LOCALS = 2
"""Components that a builder has as variables of its own."""


def telemetry_view(system: System) -> TelemetryView:
    """The view of the whole module."""
    classes = class_names(wire.name for wire in system.wires)
    builders = tuple(_builder(message, classes[message.name], system) for message in system.messages)
    used: set[str] = set()
    bindings = [binding for message in system.messages for binding in message.answers]
    for builder in builders:
        views = [part for view in builder.live for part in (view, getattr(view, "spill", None)) if part]
        for view in views:
            if isinstance(view, EachView):
                used.update(["limited", view.scale[0]] if view.scale else [])
                used.update(["complete"] if view.room is not None else [])
            if isinstance(view, LiveView | SpillView) and view.scale:
                used.update(["limited", view.scale[0]])
            if isinstance(view, LiveView) and view.is_float:
                used.add("limited")
            used.update(["spill"] if isinstance(view, SpillView) else [])
    values = [view for builder in builders for view in builder.live if isinstance(view, LiveView)]
    unknowns = [view.unknown for view in values]
    prefilled = [fixed.statement for builder in builders for fixed in builder.fixed]
    return TelemetryView(
        builders=builders,
        conversions=tuple(sorted(used)),
        uses_nan="NAN" in unknowns or any("NAN" in statement for statement in prefilled),
        uses_chip=any(isinstance(binding, TextAnswer) for binding in bindings),
        packs=any(view.packs for view in values) or any("pack_into" in statement for statement in prefilled),
        puts_floats=any(view.ratio for view in values),
        machine_code=system.spec.project.machine_code,
    )


def _builder(message: PopulatedMessage, class_name: str, system: System) -> BuilderView:
    read = Counter(quantity.component for binding in message.answers for quantity in binding.quantities)
    expiring = tuple(name for name in sorted(read) if _expires(system.components[name]))
    reach = {}
    for name in [*read, *([message.component.name] if message.component else [])]:
        is_each = message.component is not None and message.component.name == name
        reach[name] = instance_expression(system.components[name], is_each)
    chosen = tuple(_choice(choice, message) for choice in message.represents.values() if _chooses(choice))
    reach |= {choice.component: f"{choice.function}(state)" for choice in chosen}
    # A board keeps only so many variables and intermediate values of a function off the heap: so only the components
    # that are read most are variables, and none where values are written into the payload: that takes five intermediate
    # ones.
    most_read = [] if writes_payload(message) else read.most_common(LOCALS)
    frequent = [name for name, count in most_read if count > 1 or name in expiring]
    frequent += [choice.component for choice in chosen if choice.component not in frequent]
    locals_ = tuple((name, reach[name]) for name in sorted(frequent))
    reach |= {name: name for name in frequent}
    live = live_views(message, reach)
    lowered = message.name.lower()
    return BuilderView(
        name=message.name,
        id=message.wire.id,
        class_name=class_name,
        function=builder_name(message),
        prefill=prefill_name(message),
        store=f"_{lowered}",
        citation=str(message.citation),
        instances=message.instances,
        is_for_each=message.component is not None,
        is_paged=any(isinstance(binding, PageAnswer) for binding in message.answers),
        chosen=chosen,
        components=locals_,
        expiring=tuple(reach[name] for name in expiring),
        fixed=tuple(fixed for binding in message.answers if (fixed := _fixed(binding)) is not None),
        live_names=live_names(message),
        live=live,
        uses_wire=writes_payload(message) or any(isinstance(view, FlagByteView) for view in live),
    )


def _expires(component: Component) -> bool:
    return any(quantity.trust.stale_after_ms is not None for quantity in component.quantities.values())


def _chooses(choice: Representation) -> bool:
    return choice.policy is not Policy.FIRST and choice.component.instances > 1


def _choice(choice: Representation, message: PopulatedMessage) -> ChoiceView:
    component = choice.component
    return ChoiceView(
        function=f"_{message.name.lower()}_{component.name}",
        component=component.name,
        message=message.name,
        instances=component.instances,
        parameter=parameter_attribute(choice.parameter.name) if choice.parameter else None,
        parameter_name=choice.parameter.name if choice.parameter else "",
        lowest=choice.quantity.attribute if choice.quantity else None,
        lowest_name=choice.quantity.name if choice.quantity else "",
        enabled=component.enabled.attribute if component.enabled else None,
        expires=_expires(component),
    )


def _fixed(binding: Answer) -> FixedView | None:
    """The line of the prefilled payload; None for what is written at each build."""
    covers = binding.covers
    field = covers.field
    if isinstance(binding, FixedAnswer):
        return _prefilled(covers, binding.fixed, binding.meaning)
    if isinstance(binding, FactAnswer):
        return _by_instance(binding)
    if isinstance(binding, TextAnswer):
        text = f"hexlify(machine.unique_id()).decode()[:{field.count}]"
        return FixedView(f'message.set("{field.name}", {text})', f"{covers.label}: number of the chip")
    if isinstance(binding, InstanceAnswer) and binding.first is None:
        return FixedView(_packed(field, covers.offset, "instance"), f"{covers.label}: the {binding.component}'s number")
    if isinstance(binding, FlagsAnswer):
        words = " | ".join(binding.names) or "no flag"
        return _prefilled(covers, (binding.mask,) * covers.count, words)
    return None if binding.always is None else _prefilled(covers, binding.always, binding.words().source)


def _by_instance(binding: FactAnswer) -> FixedView:
    """A fact that differs: the prefilled payload of each instance picks its own."""
    covers, field = binding.covers, binding.covers.field
    values = [part.fixed[0] for part in binding.parts]
    comment = f"{covers.label}: {', '.join(part.meaning for part in binding.parts)}"
    if field.type.kind is Kind.CHAR:
        texts = ", ".join(quoted(str(value)) for value in values)
        return FixedView(f'message.set("{field.name}", ({texts})[instance])', f"{covers.label}: text")
    picked = f"({', '.join(map(number, values))})[instance]"
    if covers.count == 1:
        return FixedView(_packed(field, covers.offset, picked), comment)
    code = f'"<{covers.count}{field.type.code}"'
    return FixedView(f"pack_into({code}, wire, {covers.offset}, *[{picked}] * {covers.count})", comment)


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
    return FixedView(f"pack_into({code}, wire, {covers.offset}, {listed})", comment)


def _packed(field: WireField, offset: int, value: str) -> str:
    if field.type.code == "B":
        return f"wire[{offset}] = {value}"
    return f'pack_into("<{field.type.code}", wire, {offset}, {value})'
