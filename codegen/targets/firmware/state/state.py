"""View of state.py: the components of the vehicle state as views of words, and their updates from the ADC."""

from collections.abc import Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.code.clock import CLOCK
from codegen.model.quantities.reach import Reach, reaches
from codegen.model.spec.state import ComponentSpec
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Quantity, QuantityKind
from codegen.targets.firmware.families import FamilyView, family_view
from codegen.targets.firmware.readings.estimates import EstimateView, estimate_views
from codegen.targets.firmware.readings.measured_view import (
    FurtherView,
    MeasuredView,
    TellView,
    further_view,
    measured_view,
    read_words,
    texts_of,
    unreadable,
)
from codegen.targets.firmware.readings.reading import WAITING, expires
from codegen.targets.firmware.readings.sum_words import fulls, rest_words
from codegen.targets.firmware.state.attribute import VIEWS, AttributeView, LineView, attributes, initial_words
from codegen.targets.firmware.words import TREND_WORDS, AgedWords, Block, ConstantView, Layout, aged_words, differ
from codegen.targets.imports import either_import, import_lines
from codegen.targets.naming import parameter_attribute, parameter_expression, prose, state_class


@dataclass(frozen=True, slots=True)
class ComponentView:
    """One class of the state, and what is done with each reading of it.

    ``start`` are the words that are known from the start, with their values, by instance where these differ; ``set_up``
    those that parameters decide. ``estimates`` follow what the first reading measures. What is logged is given as
    literals, which name the instance where there are several.
    """

    name: str
    class_name: str
    doc: str
    instances: int
    several: bool
    base: str
    size: str
    attributes: tuple[AttributeView, ...]
    lines: tuple[LineView, ...]
    start: tuple[tuple[str, str], ...]
    switch: str | None
    forgotten: tuple[str, ...]
    expires: bool
    measured: MeasuredView | None
    further: tuple[FurtherView, ...]
    followed: tuple[tuple[str, str], ...]
    estimates: tuple[EstimateView, ...]
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

    ``modules`` are those of views that not every state has, ``kinds`` those of them that words.py is told of. ``aged``
    is what is forgotten so long after it was set.
    """

    imports: tuple[str, ...]
    kinds: tuple[str, ...]
    reading_imports: tuple[str, ...]
    constants: tuple[ConstantView, ...]
    size: int
    components: tuple[ComponentView, ...]
    families: tuple[FamilyView, ...]
    aged: tuple[AgedWords, ...]
    modules: tuple[str, ...]
    is_measured: bool
    waiting: int = WAITING


def state_view(system: System, layout: Layout) -> StateView:
    """The view of the whole module."""
    told = reaches(system)
    components = tuple(_component(component, layout, told) for component in system.components.values())
    measured = [component for component in components if component.measured]
    has_estimate = any(component.estimates for component in components)
    words = {"Component", "UNKNOWN", "together"} | {
        attribute.expression.partition("(")[0] for component in components for attribute in component.attributes
    }
    kinds = {line.kind for component in components for line in component.lines} & VIEWS.keys()
    words |= kinds | ({"KINDS"} if kinds else set())
    names = {("array", "array"), ("micropython", "const"), ("parameters", "Parameters")}
    names |= {(VIEWS.get(word, "words"), word) for word in words}
    modules = {VIEWS[word] for word in words & VIEWS.keys()}
    names.add(("frames", "address"))
    names |= {("curve", "value_at")} if has_estimate else set()
    constants = [
        constant
        for block in layout.blocks.values()
        for constant in (
            ConstantView(block.base_constant, block.base),
            ConstantView(block.size_constant, block.size),
            *(ConstantView(block.constant(name), at) for name, at in block.offsets.items()),
        )
    ]
    readings = [f"read_{reading.name}" for reading in system.readings() if reading.is_first]
    readings += [f"expire_{component.name}" for component in measured if component.expires]
    aged = tuple(aged_words(layout))
    machine_code = system.spec.project.machine_code
    return StateView(
        imports=import_lines(["time"] if measured or aged or CLOCK in system.components else [], names),
        kinds=tuple(sorted(kinds)),
        reading_imports=either_import("state", sorted(readings), machine_code=machine_code) if readings else (),
        constants=tuple(constants),
        size=layout.size,
        components=components,
        families=_families(system),
        aged=aged,
        modules=tuple(sorted(modules | ({"wide"} if "rows" in modules else set()))),
        is_measured=bool(measured),
    )


def _families(system: System) -> tuple[FamilyView, ...]:
    """The families of parameters that the state reads: those that switch a component on, and multipliers."""
    quantities = [quantity for component in system.components.values() for quantity in component.quantities.values()]
    used = [quantity.derivation.switch for quantity in quantities if quantity.derivation.switch]
    for reading in system.readings():
        conversion = reading.conversion
        used += [conversion.channel.when[0]] if conversion.channel.when else []
        represented = reading.quantity.derivation.represented
        used += [represented.parameter] if represented else []
        if reading.is_first:
            used += [factor for factor in conversion.factors if isinstance(factor, Parameter)]
            used += fulls(reading).values()
    used += [full for component in system.components.values() for _, full in _sizes(component)]
    by_name = {parameter.name: parameter for parameter in used if parameter.siblings}
    return tuple(family_view(parameter) for parameter in by_name.values())


def _component(component: Component, layout: Layout, told: Mapping[str, Reach]) -> ComponentView:
    block = layout.blocks[component.name]
    readings = component.readings
    enabled = component.enabled
    view = measured_view(readings[0], block) if readings else None
    at_once, lines = attributes(component, block, told)
    return ComponentView(
        name=component.name,
        class_name=state_class(component.name),
        doc=prose(component.spec.doc),
        instances=component.instances,
        several=component.instances > 1,
        base=block.base_constant,
        size=block.size_constant,
        attributes=at_once,
        lines=lines,
        start=tuple(_start(component, block)),
        switch=block.constant(enabled.attribute) if enabled else None,
        forgotten=tuple(_forgotten(component, block)),
        expires=expires(component),
        measured=view,
        further=tuple(further_view(reading, "self.parameters") for reading in readings[1:]),
        followed=view.followed if view else (),
        estimates=tuple(estimate_views(readings[0], block)) if readings else (),
        emptied=tuple(place for place, _ in _counters(component, block)),
        set_up=tuple(_set_up(component, block, view)),
        told=tuple(texts_of(readings[0], view)) if view else (),
        unreadable=unreadable(component),
        period_ms=component.period_ms,
        citation=str(component.citation or ""),
        cited={aspect: component.cited(aspect) for aspect in ComponentSpec.ASPECTS},
    )


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
        yield from measured.set_up
    for word, full in _sizes(component):
        yield block.constant(word), parameter_expression(full, "self.parameters")
    for reading in component.readings[:1]:
        yield from read_words(reading, block, "self.parameters")


def _sizes(component: Component) -> Iterator[tuple[str, Parameter]]:
    """The words with the sizes of what is full where a sensor gives what is taken from it, with their parameters."""
    for basis in component.counted_on:
        yield from fulls(basis).items()


def _start(component: Component, block: Block) -> Iterator[tuple[str, str]]:
    """The words that are known from the start, with their values; one that depends on the instance has all of them."""
    for quantity in component.quantities.values():
        yield from _own(quantity, block)
        if quantity.is_computed:
            continue
        if quantity.elements is not None:
            yield from _first_elements(quantity, block.constant(quantity.attribute))
            continue
        if quantity.derivation.switch:
            yield block.constant(quantity.attribute), "1"
        elif quantity.kind is QuantityKind.BOOLEAN:
            yield block.constant(quantity.attribute), str(int(bool(quantity.initial)))
        elif quantity.initial is not None:
            yield from initial_words(quantity, block.constant(quantity.attribute))
        yield from ((block.constant(word), str(at)) for word, at in rest_words(quantity).items())
    yield from _counters(component, block)
    counted = (reading.word(word) for reading in component.readings for word in ("failures", "is_logged"))
    for word in ("number", *counted, "gone"):
        if word in block.offsets:
            yield block.constant(word), "0"


def _first_elements(quantity: Quantity, first: str) -> Iterator[tuple[str, str]]:
    """The words of a list whose values are known from the start; ``first`` is the constant with the first place."""
    if quantity.elements is None or quantity.initial is None:
        return
    words = [word for _, word in initial_words(quantity, first)] * max(quantity.elements)
    yield from ((f"{first} + {place}" if place else first, word) for place, word in enumerate(words))


def _own(quantity: Quantity, block: Block) -> Iterator[tuple[str, str]]:
    """Yield what each instance has of its own: limits and counts."""
    threshold = quantity.derivation.threshold
    own = {
        f"{quantity.name}_limit": quantity.derivation.own_limits,
        f"{quantity.name}_floor": quantity.derivation.own_floors,
        f"{quantity.name}_back_from": quantity.derivation.back_from,
        f"{quantity.attribute}_count": quantity.elements or (),
    }
    if threshold is not None:
        is_first = f"{quantity.name}_count" not in block.offsets
        own["warn_above" if is_first else f"{quantity.name}_warn_above"] = threshold.above
    for word, numbers in own.items():
        if differ(numbers):
            yield block.constant(word), f"({', '.join(map(str, numbers))})"


def _counters(component: Component, block: Block) -> Iterator[tuple[str, str]]:
    """Yield what a trend counts, which is nothing at the start."""
    for quantity in component.quantities.values():
        if quantity.derivation.kept_readings:
            for word in TREND_WORDS:
                yield block.constant(f"{quantity.name}_{word}"), "0"


def _forgotten(component: Component, block: Block) -> Iterator[str]:
    """The words of what is measured, which forget() makes unknown."""
    for quantity in component.quantities.values():
        if quantity.derivation.comes_of_readings:
            yield block.constant(quantity.attribute)
