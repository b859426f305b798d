"""Facts about components for the generated tests: their quantities, and how one of them is measured."""

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.code.storage import Storage
from codegen.model.quantities.conversion import factors_by_instance
from codegen.model.quantities.reach import Reach, reaches
from codegen.model.spec.state import ComponentSpec, QuantitySpec
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Quantity, QuantityKind, Reading, by_instance
from codegen.targets.naming import parameter_attribute
from codegen.targets.suite.cases.case import literal_of
from codegen.targets.suite.cases.messages import first_attribute
from codegen.targets.suite.expected import nominal_values
from codegen.targets.suite.facts.edges import Edge, edges
from codegen.targets.suite.facts.set_together import SetTogetherFacts, set_together_facts


@dataclass(frozen=True, slots=True)
class QuantityFacts:
    """One quantity: its attributes, and how many steps make one of its units. ``is_stored``: it follows no other.

    ``stale_after_ms``: so long after code has set it, it is unknown.
    ``is_object``: it is a float or a text, and MicroPython allocates where code sets it. ``samples`` are two plain
    values as literals, of a list for all of it, and ``tried`` many of one value; ``is_unknown`` is how to compare it
    with none, as an end of an expression.
    ``row`` is a literal with some for the elements of a list of what more than a word holds, or nothing.
    ``initial`` is what it has at the start, as a literal; of a list that of each value.
    ``within`` and ``beyond`` are literals of what code can set without a word, and of what is limited and told as
    ``called``.
    """

    name: str
    attribute: str
    is_stored: bool
    is_object: bool
    samples: tuple[str, str]
    tried: tuple[str, ...]
    is_unknown: str
    elements: int | None
    row: str
    initial: str
    numerator: int
    denominator: int
    citation: str
    stale_after_ms: int | None
    stale_criterion: str
    called: str
    within: str
    beyond: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class RepresentedFacts:
    """The parameter with which code sets the first instance: its attribute with its steps.

    A ``value`` is believed for so many ``readings``; then it is unknown, and with it what is ``forgotten``: attributes,
    each with something that it can be set to, and with the comparison that says that it is unknown.

    ``parameters`` are those of all instances; ``by_default`` the ones with which code sets an instance from the start,
    each with its steps, and with others, with which it is off, or read.
    """

    parameter: str
    steps: int
    value: int
    readings: int
    forgotten: tuple[tuple[str, str, str], ...]
    parameters: tuple[str, ...]
    by_default: tuple[tuple[str, int, int], ...]


@dataclass(frozen=True, slots=True)
class MeasuredFacts:
    """The conversion of an ADC count to a component's quantity: ``count * steps * numerator / denominator``.

    ``period_us`` is the time between two readings. ``warning_counts`` are, by instance, the smallest counts that are
    warned about; None where there is none. ``edges`` are readings of the first instance.
    """

    name: str
    attribute: str
    period_us: int
    full_scale: int
    citation: str
    multiplier: str
    multiplier_name: str
    latched: bool
    numerator: int
    denominator: int
    warns: bool
    warn_every_ms: int | None
    warning_counts: tuple[int | None, ...]
    edges: tuple[Edge, ...]
    invalid_after: int | None
    stale_after_ms: int | None
    represented: RepresentedFacts | None
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class ReturnsFacts:
    """The count of a component's returns, and the quantities that begin anew with it: attributes and first values."""

    gone: str
    below: tuple[int, ...]
    back_from: tuple[int, ...]
    count: str
    title: str
    restarting: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class ExtremeFacts:
    """The lowest or the highest of ``count`` values of a list, which is forgotten after so many ``passes``."""

    name: str
    attribute: str
    listed: str
    count: int
    function: str
    passes: int
    citation: str


@dataclass(frozen=True, slots=True)
class TrendFacts:
    """The trend of what is measured, over twice ``half`` readings."""

    attribute: str
    half: int


@dataclass(frozen=True, slots=True)
class EstimateFacts:
    """An estimate from a measured quantity; ``curves`` are, by instance, points of stored steps of both."""

    attribute: str
    curves: tuple[tuple[tuple[int, int], ...], ...]


@dataclass(frozen=True, slots=True)
class ComponentFacts:
    """One component; ``measured`` is what its first of so many ``readings`` gives, where a parameter multiplies that.

    ``estimates`` follow what that gives, ``estimated`` are the attributes of all. ``not_estimated`` are attributes that
    criteria about estimates are about, and that nothing sets. ``enabled`` is the attribute that says whether it is
    measured, ``enabled_by`` its parameter's.
    """

    name: str
    instances: int
    several: bool
    enabled: str | None
    enabled_by: str | None
    quantities: tuple[QuantityFacts, ...]
    measured: MeasuredFacts | None
    readings: int
    trend: TrendFacts | None
    estimates: tuple[EstimateFacts, ...]
    estimated: tuple[str, ...]
    not_estimated: tuple[str, ...]
    returns: ReturnsFacts | None
    set_together: SetTogetherFacts | None
    extremes: tuple[ExtremeFacts, ...]
    cited: Mapping[str, str]


def component_facts(system: System) -> tuple[ComponentFacts, ...]:
    """Every component, in order."""
    told = reaches(system)
    return tuple(_component(component, system, told) for component in system.components.values())


def _component(component: Component, system: System, told: Mapping[str, Reach]) -> ComponentFacts:
    quantities = tuple(component.quantities.values())
    first = next(iter(component.readings), None)
    measured = first.quantity if first and first.is_plain else None
    enabled = component.enabled
    switch = component.switch
    trend = next((quantity for quantity in quantities if quantity.derivation.kept_readings), None)
    return ComponentFacts(
        name=component.name,
        instances=component.instances,
        several=component.instances > 1,
        enabled=enabled.name if enabled else None,
        enabled_by=parameter_attribute(switch.name) if switch else None,
        quantities=tuple(_quantity(quantity, told[quantity.path]) for quantity in quantities),
        measured=_measured(measured, component, system) if measured else None,
        readings=len(component.readings),
        trend=TrendFacts(trend.attribute, trend.derivation.kept_readings // 2) if trend else None,
        estimates=tuple(_estimates(first)) if first else (),
        estimated=tuple(quantity.attribute for quantity in quantities if quantity.derivation.curves_by_instance),
        not_estimated=tuple(
            quantity.attribute
            for quantity in quantities
            if "estimate" in quantity.aspects and quantity.spec.derivations == ()
        ),
        returns=_returns(component),
        set_together=set_together_facts(component),
        extremes=tuple(_extremes(component)),
        cited={aspect: component.cited(aspect) for aspect in ComponentSpec.ASPECTS},
    )


def _quantity(quantity: Quantity, told: Reach) -> QuantityFacts:
    low, high = _samples(quantity)
    least, most = map(Fraction, told)
    step = max(abs(least), abs(most)) + 1 if quantity.storage.is_float else 1
    is_number = quantity.kind not in (QuantityKind.BOOLEAN, QuantityKind.TEXT)
    is_limited = is_number and least <= most
    return QuantityFacts(
        name=quantity.name,
        attribute=quantity.attribute,
        is_stored=not quantity.is_computed,
        is_object=quantity.storage.is_float or quantity.length > 0,
        samples=(_alike(quantity, low), _alike(quantity, high)),
        tried=_tried(quantity),
        is_unknown=f"== {_alike(quantity, 'None')}" if quantity.elements else "is None",
        elements=quantity.elements[0] if quantity.elements else None,
        row=_row(quantity),
        initial=literal_of(quantity.initial),
        numerator=quantity.steps.numerator,
        denominator=quantity.steps.denominator,
        citation=str(quantity.citation or ""),
        stale_after_ms=quantity.trust.stale_after_ms if quantity.ages else None,
        stale_criterion=quantity.cited("stale_after"),
        called=quantity.attribute if quantity.elements else quantity.name,
        within=_literal(quantity, max(least, min(most, Fraction(5)))),
        beyond=(_literal(quantity, least - step), _literal(quantity, most + step)) if is_limited else (),
    )


def _literal(quantity: Quantity, value: Fraction) -> str:
    """A number as its attribute takes it; of a list the first one has it."""
    text = str(value)
    if quantity.storage.is_float:
        largest = Storage.BINARY64.limits[1]
        text = repr(float(value)) if abs(value) <= largest else f"{'-' if value < 0 else ''}(1 << 1024)"
    if quantity.elements is not None:
        return f"first({text}, {quantity.elements[0]})"
    return text


def _samples(quantity: Quantity) -> tuple[str, str]:
    """5 and 7, or the ends of a range that does not have them; floats are whole numbers, too, where they can be."""
    low, high = quantity.minimum, quantity.maximum
    if quantity.length:
        return '"5"', '"7"'
    if low <= 5 and high >= 7:
        return "5", "7"
    ends = (float(low), float(high)) if quantity.storage.is_float else (int(low), int(high))
    return repr(ends[0]), repr(ends[1])


def _tried(quantity: Quantity) -> tuple[str, ...]:
    """Values of every kind of float, or texts of every length of a character."""
    if quantity.length:
        return "None", '""', '"a"', f'"{"x" * quantity.length}"', f'"\\u20ac" * {quantity.length}'
    return "None", "0.0", "0.1", "-0.6", "1.5", "16777217.0", "-3.4e38", "1e-38"


def _alike(quantity: Quantity, value: str) -> str:
    return f"[{value}] * {quantity.elements[0]}" if quantity.elements else value


def _row(quantity: Quantity) -> str:
    is_one = quantity.storage is Storage.SMALL or quantity.elements is None
    return "" if is_one else literal_of(nominal_values(quantity, 0))


def _estimates(reading: Reading) -> Iterator[EstimateFacts]:
    for quantity in reading.given:
        if quantity.derivation.curves_by_instance:
            yield EstimateFacts(quantity.attribute, quantity.derivation.curves_by_instance)


def _returns(component: Component) -> ReturnsFacts | None:
    returns = component.returns
    if returns is None:
        return None
    follows = returns.gone.derivation
    limits = follows.own_limits
    return ReturnsFacts(
        gone=returns.gone.name,
        below=limits if limits and follows.deciding(0, None)["clear"] == limits[0] else (),
        back_from=returns.count.derivation.back_from,
        count=returns.count.attribute,
        title=component.name.capitalize(),
        restarting=tuple((each.attribute, _anew(each)) for each in returns.restarting),
    )


def _extremes(component: Component) -> Iterator[ExtremeFacts]:
    for quantity in component.quantities.values():
        listed = component.quantities.get(quantity.derivation.extreme_of or "")
        if listed is None or listed.elements is None:
            continue
        yield ExtremeFacts(
            name=quantity.name,
            attribute=quantity.attribute,
            listed=listed.attribute,
            count=listed.elements[0],
            function="min" if quantity.derivation.is_of_lowest else "max",
            passes=math.ceil((listed.trust.stale_after_ms or 0) / component.read_every_ms),
            citation=str(quantity.citation or ""),
        )


def _anew(quantity: Quantity) -> str:
    """Return what a quantity begins anew with, in Python."""
    if quantity.derivation.sums:
        return "0"
    if quantity.kind is QuantityKind.BOOLEAN:
        return str(bool(quantity.initial))
    return str(quantity.initial)


def _measured(quantity: Quantity, component: Component, system: System) -> MeasuredFacts:
    conversion, threshold = quantity.derivation.conversion, quantity.derivation.threshold
    assert conversion is not None
    multiplier = conversion.multiplier
    assert isinstance(multiplier, Parameter)
    return MeasuredFacts(
        name=quantity.name,
        attribute=quantity.attribute,
        period_us=component.read_every_ms * 1000,
        full_scale=conversion.channel.full_scale,
        citation=str(quantity.citation or ""),
        multiplier=parameter_attribute(multiplier.name),
        multiplier_name=multiplier.name,
        latched=multiplier.spec.reboot,
        numerator=conversion.numerator,
        denominator=conversion.denominator,
        warns=threshold is not None,
        warn_every_ms=threshold.every_ms if threshold else None,
        warning_counts=_warning_counts(quantity, component, system),
        edges=edges(quantity),
        invalid_after=quantity.trust.invalid_after,
        stale_after_ms=quantity.trust.stale_after_ms,
        represented=_represented(quantity, component, system),
        cited={aspect: quantity.cited(aspect) for aspect in QuantitySpec.ASPECTS},
    )


def _represented(quantity: Quantity, component: Component, system: System) -> RepresentedFacts | None:
    represented, conversion = quantity.derivation.represented, quantity.derivation.conversion
    if represented is None or conversion is None:
        return None
    returns = component.returns
    follows = returns is not None and returns.gone.derivation.follows == quantity.name
    restarting = returns.restarting if returns is not None and follows else ()
    own = by_instance(represented.parameter, system.parameters, component.instances)
    choices = represented.parameter.choices or (0, represented.parameter.minimum, represented.parameter.maximum)
    return RepresentedFacts(
        parameters=tuple(parameter_attribute(each.name) for each in own),
        by_default=tuple(
            (parameter_attribute(each.name), each.default, next(steps for steps in choices if steps != each.default))
            for each in own
            if each.default == represented.steps
        ),
        parameter=first_attribute(represented.parameter),
        steps=represented.steps,
        value=conversion.stored(conversion.channel.full_scale * 3 // 4, *(each.default for each in conversion.factors)),
        readings=represented.readings(component),
        forgotten=tuple(
            (each.attribute, _alike(each, "1"), f"== {_alike(each, 'None')}" if each.elements else "is None")
            for each in restarting
            if each.initial is None and each.name != quantity.derivation.prefers
        ),
    )


def _warning_counts(quantity: Quantity, component: Component, system: System) -> tuple[int | None, ...]:
    """The smallest count of each instance that is warned about with its default multiplier; None if there is none."""
    conversion, threshold = quantity.derivation.conversion, quantity.derivation.threshold
    if conversion is None or threshold is None:
        return (None,) * component.instances
    multipliers = factors_by_instance(conversion.multiplier, system.parameters, component.instances)
    counts = []
    for multiplier, limit in zip(multipliers, threshold.above, strict=True):
        per_count = Fraction(multiplier.default * conversion.numerator, conversion.denominator)
        # Rounded to nearest, a result is above the threshold from half a step above it.
        first = math.ceil((limit + Fraction(1, 2)) / per_count)
        counts.append(first if 0 < first <= conversion.channel.full_scale else None)
    return tuple(counts)
