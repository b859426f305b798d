"""View of state.py: the components of the vehicle state as views of words, and their updates from the ADC."""

from collections.abc import Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.clock import CLOCK
from codegen.model.reach import Reach, reaches
from codegen.model.state_spec import ComponentSpec, QuantitySpec
from codegen.model.system import System
from codegen.model.unit import decimal
from codegen.model.vehicle import Component, Quantity, QuantityKind
from codegen.targets.families import FamilyView, family_view
from codegen.targets.firmware.attribute import (
    VIEWS,
    AttributeView,
    attributes,
    initial_words,
)
from codegen.targets.firmware.reading import ABOVE, FIRST, RETURNED, WAITING, expires
from codegen.targets.firmware.words import TREND_WORDS, Block, ConstantView, Layout, differ, measured_of
from codegen.targets.imports import either_import, import_lines
from codegen.targets.naming import parameter_attribute, parameter_expression, prose, state_class


@dataclass(frozen=True, slots=True)
class MeasuredView:
    """How a component's quantity comes from an ADC count, and what is told about its readings.

    ``formula`` is for people, in volts, with the names adc and mult. ``own_multiplier`` is the expression of the
    steps of an instance's parameter, ``own_name`` that of its name.
    """

    name: str
    word: str
    unit: str
    formula: str
    citation: str
    multiplier_name: str
    own_multiplier: str
    own_name: str
    names: tuple[str, ...]
    latched: bool
    warn_text: str
    invalid_after: int | None
    stale_after_ms: int | None
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class TellView:
    """What is logged, as arguments of the generated Python, where a reading has given cause to: a bit of its result."""

    bit: int
    text: str


@dataclass(frozen=True, slots=True)
class EstimateView:
    """The charge that is estimated from what is measured: its word, and the curve of each instance."""

    word: str
    constant: str
    each: str
    text: str
    name: str


@dataclass(frozen=True, slots=True)
class ComponentView:
    """One class of the state, and what is done with each reading of it.

    ``start`` are the words that are known from the start, with their values, by instance where these differ; ``set_up``
    those that parameters decide. What is logged is given as literals, which name the instance where there are several.
    """

    name: str
    class_name: str
    doc: str
    instances: int
    several: bool
    base: str
    size: str
    attributes: tuple[AttributeView, ...]
    start: tuple[tuple[str, str], ...]
    switch: str | None
    forgotten: tuple[str, ...]
    expires: bool
    measured: MeasuredView | None
    estimate: EstimateView | None
    emptied: tuple[str, ...]
    set_up: tuple[tuple[str, str], ...]
    told: tuple[TellView, ...]
    unreadable: str
    period_ms: int | None
    citation: str
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class StateView:
    """The module: what it imports, the constants of its words, and the components in order.

    ``modules`` are those of views that not every state has.
    """

    imports: tuple[str, ...]
    reading_imports: tuple[str, ...]
    constants: tuple[ConstantView, ...]
    size: int
    components: tuple[ComponentView, ...]
    families: tuple[FamilyView, ...]
    has_estimate: bool
    modules: tuple[str, ...]
    is_measured: bool
    waiting: int = WAITING


def state_view(system: System, layout: Layout) -> StateView:
    """The view of the whole module."""
    told = reaches(system)
    components = tuple(_component(component, layout, told) for component in system.components.values())
    measured = [component for component in components if component.measured]
    has_estimate = any(component.estimate for component in components)
    words = {"Component", "UNKNOWN", "together"} | {
        attribute.expression.partition("(")[0] for component in components for attribute in component.attributes
    }
    names = {("array", "array"), ("micropython", "const"), ("parameters", "Parameters")}
    names |= {(VIEWS.get(word, "words"), word) for word in words}
    modules = {VIEWS[word] for word in words & VIEWS.keys()}
    names.add(("frames", "address"))
    names |= {("guard", "Guard")} if measured else set()
    names |= {("discharge", "percent")} if has_estimate else set()
    constants = [
        constant
        for block in layout.blocks.values()
        for constant in (
            ConstantView(block.base_constant, block.base),
            ConstantView(block.size_constant, block.size),
            *(ConstantView(block.constant(name), at) for name, at in block.offsets.items()),
        )
    ]
    readings = [f"read_{component.name}" for component in measured]
    readings += [f"expire_{component.name}" for component in measured if component.expires]
    machine_code = system.spec.project.machine_code
    return StateView(
        imports=import_lines(["time"] if measured or CLOCK in system.components else [], names),
        reading_imports=either_import("state", sorted(readings), machine_code=machine_code) if readings else (),
        constants=tuple(constants),
        size=layout.size,
        components=components,
        families=_families(system),
        has_estimate=has_estimate,
        modules=tuple(sorted(modules | ({"wide"} if "rows" in modules else set()))),
        is_measured=bool(measured),
    )


def _families(system: System) -> tuple[FamilyView, ...]:
    """The families of parameters that the state reads: those that switch a component on, and multipliers."""
    quantities = [quantity for component in system.components.values() for quantity in component.quantities.values()]
    switches = [quantity.derivation.switch for quantity in quantities if quantity.derivation.switch]
    multipliers = [conversion.multiplier for _, _, conversion in system.measured()]
    return tuple(family_view(parameter) for parameter in (*switches, *multipliers) if parameter.siblings)


def _component(component: Component, layout: Layout, told: Mapping[str, Reach]) -> ComponentView:
    block = layout.blocks[component.name]
    quantities = component.quantities.values()
    measured = measured_of(component)
    enabled = component.enabled
    view = _measured(measured, component, block) if measured else None
    return ComponentView(
        name=component.name,
        class_name=state_class(component.name),
        doc=prose(component.spec.doc),
        instances=component.instances,
        several=component.instances > 1,
        base=block.base_constant,
        size=block.size_constant,
        attributes=tuple(attributes(component, block, told)),
        start=tuple(_start(component, block)),
        switch=block.constant(enabled.attribute) if enabled else None,
        forgotten=tuple(_forgotten(component, block)),
        expires=expires(component),
        measured=view,
        estimate=next(filter(None, (_estimate(quantity, component, block) for quantity in quantities)), None),
        emptied=tuple(place for place, _ in _counters(component, block)),
        set_up=tuple(_set_up(component, block, view)),
        told=tuple(_told(component, view)) if view else (),
        unreadable=_unreadable(component),
        period_ms=component.period_ms,
        citation=str(component.citation or ""),
        cited={aspect: component.cited(aspect) for aspect in ComponentSpec.ASPECTS},
    )


def _unreadable(component: Component) -> str:
    """The text about a board that raises, as a literal of the generated Python."""
    if component.instances == 1:
        return f'"error: the board cannot read the {component.name}:"'
    return f'f"error: the board cannot read {component.name} {{instance + 1}}:"'


def _told(component: Component, measured: MeasuredView) -> Iterator[TellView]:
    """What a reading can give cause to tell: that it is the first, that something came back, that it is too high."""
    name, several = component.name, component.instances > 1
    number, mark = (" {instance + 1}", "f") if several else ("", "")
    yield TellView(FIRST, f'f"{name}{number}: {measured.name} {{value:.2f}} {measured.unit}"')
    if component.returns:
        yield TellView(RETURNED, f'{mark}"notice: {name.capitalize()}{number} connected"')
    if measured.warn_text:
        owner = f"{name}{number}'s" if several else f"the {name}'s"
        text = f"warning: {owner} {measured.name} is above {measured.warn_text}:"
        yield TellView(ABOVE, f'{"f" if "{" in text else ""}"{text}", value')


def _set_up(component: Component, block: Block, measured: MeasuredView | None) -> Iterator[tuple[str, str]]:
    """The words that parameters decide at the start."""
    if component.name == CLOCK:
        yield block.constant("last_us"), "time.ticks_us()"
        yield block.constant("last_ms"), "time.ticks_ms()"
    if component.first_number:
        first = f"self.parameters.{parameter_attribute(component.first_number.name)}"
        yield block.constant("number"), f"{first} + instance" if component.instances > 1 else first
    if component.enabled and component.switch:
        switch = parameter_expression(component.switch, "self.parameters")
        yield block.constant(component.enabled.attribute), f"1 if {switch} != 0 else 0"
    if measured:
        yield block.constant("multiplier"), measured.own_multiplier


def _start(component: Component, block: Block) -> Iterator[tuple[str, str]]:
    """The words that are known from the start, with their values; one that depends on the instance has all of them."""
    for quantity in component.quantities.values():
        yield from _own(quantity, block)
        if quantity.is_computed or quantity.elements is not None:
            continue
        if quantity.derivation.switch:
            yield block.constant(quantity.attribute), "1"
        elif quantity.kind is QuantityKind.BOOLEAN:
            yield block.constant(quantity.attribute), str(int(bool(quantity.initial)))
        elif quantity.initial is not None:
            yield from initial_words(quantity, block.constant(quantity.attribute))
    yield from _counters(component, block)
    for word in ("number", "failures", "is_logged", "gone"):
        if word in block.offsets:
            yield block.constant(word), "0"


def _own(quantity: Quantity, block: Block) -> Iterator[tuple[str, str]]:
    """What each instance has of its own: limits and counts."""
    threshold = quantity.derivation.threshold
    own = {
        f"{quantity.name}_limit": quantity.derivation.own_limits,
        f"{quantity.attribute}_count": quantity.elements or (),
    }
    own["warn_above"] = threshold.above if threshold else ()
    for word, numbers in own.items():
        if differ(numbers):
            yield block.constant(word), f"({', '.join(map(str, numbers))})"


def _counters(component: Component, block: Block) -> Iterator[tuple[str, str]]:
    """What a trend counts, which is nothing at the start."""
    for quantity in component.quantities.values():
        if quantity.derivation.kept_readings:
            for word in TREND_WORDS:
                yield block.constant(f"{quantity.name}_{word}"), "0"


def _forgotten(component: Component, block: Block) -> Iterator[str]:
    """The words of what is measured, which forget() makes unknown."""
    for quantity in component.quantities.values():
        if quantity.derivation.comes_of_readings:
            yield block.constant(quantity.attribute)


def _estimate(quantity: Quantity, component: Component, block: Block) -> EstimateView | None:
    curves = quantity.derivation.curves_by_instance
    if not curves:
        return None
    several = component.instances > 1
    constant = f"_{component.name.upper()}_CURVE{'S' if several else ''}"
    each = f"{constant}[self._instance]" if several else constant
    text = repr(curves if several else curves[0])
    return EstimateView(block.constant(quantity.attribute), constant, each, text, quantity.name)


def _measured(quantity: Quantity, component: Component, block: Block) -> MeasuredView:
    conversion, threshold = quantity.derivation.conversion, quantity.derivation.threshold
    assert conversion is not None
    channel, multiplier = conversion.channel, conversion.multiplier
    warn_text = ""
    if threshold is not None:
        text = decimal(threshold.above[0] / quantity.steps)
        if differ(threshold.above):
            text = (
                f"{{self.{component.name}_words[instance][{block.constant('warn_above')}] / {decimal(quantity.steps)}}}"
            )
        warn_text = f"{text} {quantity.unit.name}"
    return MeasuredView(
        name=quantity.name,
        word=block.constant(quantity.attribute),
        unit=quantity.unit.name,
        formula=f"adc / {channel.full_scale} * {decimal(channel.reference)} * mult",
        citation=str(quantity.citation or ""),
        multiplier_name=multiplier.name,
        own_multiplier=parameter_expression(multiplier, "self.parameters"),
        own_name=_own_name(multiplier.name, multiplier.siblings),
        names=multiplier.siblings,
        latched=multiplier.spec.reboot,
        warn_text=warn_text,
        invalid_after=quantity.trust.invalid_after,
        stale_after_ms=quantity.trust.stale_after_ms,
        cited={aspect: quantity.cited(aspect) for aspect in QuantitySpec.ASPECTS},
    )


def _own_name(name: str, siblings: tuple[str, ...]) -> str:
    """The expression of a parameter's name; of a family that of the instance."""
    if not siblings:
        return f'"{name}"'
    names = ", ".join(f'"{sibling}"' for sibling in siblings)
    return f"({names})[instance]" if len(siblings) > 1 else f'"{siblings[0]}"'
