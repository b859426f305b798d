"""View of state.py: the vehicle state with its integers, their views for people and the updates from the ADC."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from codegen.derivations.estimate import Estimate
from codegen.derivations.follows import Follows
from codegen.derivations.trend import Trend
from codegen.model.state_spec import ComponentSpec, QuantitySpec
from codegen.model.system import System
from codegen.model.unit import decimal
from codegen.model.vehicle import Component, Conversion, Quantity, QuantityKind, by_instance
from codegen.targets.families import FamilyView, family_view
from codegen.targets.naming import parameter_attribute, parameter_expression, prose, state_class


@dataclass(frozen=True, slots=True)
class OwnView:
    """An attribute that is not the same in all instances: its value in the first, and in each, as expressions."""

    attribute: str
    first: str
    each: str


@dataclass(frozen=True, slots=True)
class QuantityView:
    """One quantity: its attribute, its value at start, and, with a unit, its property for people.

    ``shown`` says what the property returns. A boolean that ``follows`` an attribute is true while that is known and
    ``condition`` holds. ``elements`` is the number of values of a list. ``own`` is what instances have of their own.
    """

    name: str
    attribute: str
    initial: str
    comment: str
    unit: str
    shown: str
    has_property: bool
    read_only: bool
    follows: str | None
    condition: str
    own: OwnView | None
    elements: int | None
    enabled_by: str | None
    enabled_attribute: str
    enabled_by_name: str
    numerator: int
    denominator: int
    citation: str


@dataclass(frozen=True, slots=True)
class MeasuredView:
    """How a component's quantity comes from an ADC count: ``count * steps * numerator / denominator``.

    ``formula`` is the same for people, in volts, with the names adc and mult.
    """

    name: str
    attribute: str
    unit: str
    formula: str
    full_scale: int
    citation: str
    multiplier: str
    multiplier_name: str
    own_multiplier: str
    names: tuple[str, ...]
    latched: bool
    numerator: int
    denominator: int
    warn_above: str | None
    warn_text: str
    warn_every_ms: int | None
    warnings: OwnView | None
    warning_counts: tuple[int | None, ...]
    invalid_after: int | None
    stale_after_ms: int | None
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class TrendView:
    """The trend of what is measured: the sum of ``half`` of the readings is compared with that of the others.

    The difference times ``numerator / denominator`` is the change per second.
    """

    attribute: str
    half: int
    numerator: int
    denominator: int


@dataclass(frozen=True, slots=True)
class EstimateView:
    """The charge that is estimated from what is measured; ``curves`` are, by instance, (stored steps, %), rising."""

    attribute: str
    name: str
    curves: tuple[tuple[tuple[int, int], ...], ...]


@dataclass(frozen=True, slots=True)
class RestartView:
    """What begins anew when something has come back: with 0 if it is known, or ``initial``, a boolean."""

    attribute: str
    initial: str | None


@dataclass(frozen=True, slots=True)
class ReturnsView:
    """``gone`` is the boolean whose end counts in the attribute ``count``; ``below`` its limit by instance, if any.

    ``title`` is what texts call the component.
    """

    gone: str
    below: tuple[int, ...]
    count: str
    title: str
    restarting: tuple[RestartView, ...]
    citation: str


@dataclass(frozen=True, slots=True)
class ComponentView:
    """One class of the state, and how SystemState holds it: alone, or as a list of several."""

    name: str
    class_name: str
    doc: str
    instances: int
    several: bool
    first_number: str | None
    quantities: tuple[QuantityView, ...]
    measured: MeasuredView | None
    trend: TrendView | None
    estimate: EstimateView | None
    returns: ReturnsView | None
    enabled: str | None
    period_ms: int | None
    citation: str
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class StateView:
    """The module: the components in order, and the names that it imports from conversion."""

    components: tuple[ComponentView, ...]
    families: tuple[FamilyView, ...]
    conversions: tuple[str, ...]
    is_measured: bool
    uses_clock: bool
    has_trend: bool
    has_estimate: bool


def state_view(system: System) -> StateView:
    """The view of the whole module."""
    components = tuple(_component(component, system) for component in system.components.values())
    used = set()
    if any(component.measured for component in components):
        used |= {"product"}
    if any(quantity.has_property for component in components for quantity in component.quantities):
        used |= {"to_steps"}
    measured = [component.measured for component in components if component.measured]
    return StateView(
        components,
        families=_families(system),
        conversions=tuple(sorted(used)),
        is_measured=bool(measured),
        uses_clock=any(reading.stale_after_ms is not None or reading.warn_every_ms for reading in measured),
        has_trend=any(component.trend for component in components),
        has_estimate=any(component.estimate for component in components),
    )


def _families(system: System) -> tuple[FamilyView, ...]:
    """The families of parameters that the state reads: those that switch a component on, and multipliers."""
    quantities = [quantity for component in system.components.values() for quantity in component.quantities.values()]
    switches = [quantity.derivation.switch for quantity in quantities if quantity.derivation.switch]
    multipliers = [conversion.multiplier for _, _, conversion in system.measured()]
    return tuple(family_view(parameter) for parameter in (*switches, *multipliers) if parameter.siblings)


def _component(component: Component, system: System) -> ComponentView:
    measured = [
        _measured(quantity, conversion, component, system)
        for name, quantity, conversion in system.measured()
        if name == component.name
    ]
    return ComponentView(
        name=component.name,
        class_name=state_class(component.name),
        doc=prose(component.spec.doc),
        instances=component.instances,
        several=component.instances > 1,
        first_number=parameter_attribute(component.first_number.name) if component.first_number else None,
        quantities=tuple(_quantity(quantity, component) for quantity in component.quantities.values()),
        measured=measured[0] if measured else None,
        trend=next(filter(None, (_trend(quantity, component) for quantity in component.quantities.values())), None),
        estimate=next(filter(None, (_estimate(quantity) for quantity in component.quantities.values())), None),
        returns=_returns(component),
        enabled=component.enabled.name if component.enabled else None,
        period_ms=component.period_ms,
        citation=str(component.citation or ""),
        cited={aspect: component.cited(aspect) for aspect in ComponentSpec.ASPECTS},
    )


def _quantity(quantity: Quantity, component: Component) -> QuantityView:
    initial = "None"
    if quantity.kind is QuantityKind.BOOLEAN:
        initial = str(bool(quantity.initial))
    elif quantity.initial is not None:
        initial = str(quantity.initial)
    stored = f" [{quantity.stored.name}]" if quantity.stored.name else ""
    enum = f" ({quantity.enum.name})" if quantity.enum else ""
    follows, switch = quantity.derivation.follows, quantity.derivation.switch
    return QuantityView(
        name=quantity.name,
        attribute=quantity.attribute,
        initial=initial,
        comment=f"{prose(quantity.spec.doc).rstrip('.')}{stored}{enum}",
        unit=quantity.unit.name,
        shown=_shown(quantity),
        has_property=quantity.attribute != quantity.name,
        read_only=isinstance(quantity.derivation, Trend),
        follows=component.quantities[follows].attribute if follows else None,
        condition=_condition(quantity),
        own=_own(quantity),
        elements=quantity.elements[0] if quantity.elements else None,
        enabled_by=parameter_expression(switch, "self.parameters") if switch else None,
        enabled_attribute=parameter_attribute(switch.name) if switch else "",
        enabled_by_name=switch.name if switch else "",
        numerator=quantity.steps.numerator,
        denominator=quantity.steps.denominator,
        citation=str(quantity.citation) if quantity.citation else "",
    )


def _shown(quantity: Quantity) -> str:
    """What the property returns: ``V, or None while it is unknown``."""
    what = quantity.unit.name or "A number"
    return f"{what}, known from the start" if quantity.initial is not None else f"{what}, or None while it is unknown"


def _condition(quantity: Quantity) -> str:
    """The comparison of a boolean that follows a limit; where instances differ, with the limit of its own."""
    follows = quantity.derivation
    if not isinstance(follows, Follows):
        return ""
    sign = "<" if follows.is_below else ">="
    limit = str(follows.limits[0]) if len(set(follows.limits)) == 1 else f"self.{_limit_name(quantity)}"
    return f"{sign} {limit}"


def _limit_name(quantity: Quantity) -> str:
    return f"{quantity.name}_limit"


def _own(quantity: Quantity) -> OwnView | None:
    """What is not the same in all instances, if there is such a thing."""
    if isinstance(quantity.derivation, Follows):
        return _own_numbers(_limit_name(quantity), quantity.derivation.limits)
    own = _own_numbers(quantity.attribute, quantity.elements or ())
    return own and OwnView(own.attribute, f"[None] * {own.first}", f"[None] * {own.each}")


def _own_numbers(attribute: str, numbers: tuple[int, ...]) -> OwnView | None:
    if len(set(numbers)) <= 1:
        return None
    return OwnView(attribute, str(numbers[0]), f"({', '.join(map(str, numbers))})[instance]")


def _trend(quantity: Quantity, component: Component) -> TrendView | None:
    trend = quantity.derivation
    if not isinstance(trend, Trend) or component.period_ms is None:
        return None
    half = trend.readings // 2
    scale = Fraction(1000, half * half * component.period_ms)
    return TrendView(quantity.attribute, half, scale.numerator, scale.denominator)


def _estimate(quantity: Quantity) -> EstimateView | None:
    estimate = quantity.derivation
    return EstimateView(quantity.attribute, quantity.name, estimate.curves) if isinstance(estimate, Estimate) else None


def _returns(component: Component) -> ReturnsView | None:
    returns = component.returns
    if returns is None:
        return None
    follows = returns.gone.derivation
    return ReturnsView(
        gone=returns.gone.name,
        below=follows.limits if isinstance(follows, Follows) and follows.is_below else (),
        count=returns.count.attribute,
        title=component.name.capitalize(),
        restarting=tuple(
            RestartView(each.attribute, str(bool(each.initial)) if each.kind is QuantityKind.BOOLEAN else None)
            for each in returns.restarting
        ),
        citation=str(returns.count.citation or ""),
    )


def _measured(quantity: Quantity, conversion: Conversion, component: Component, system: System) -> MeasuredView:
    channel, multiplier = conversion.channel, conversion.multiplier
    warn_text = ""
    warn_above = None
    threshold = quantity.derivation.threshold
    if threshold is not None:
        same = len(set(threshold.above)) == 1
        warn_above = str(threshold.above[0]) if same else f"{quantity.component}.warn_above"
        text = decimal(threshold.above[0] / quantity.steps)
        if not same:
            text = f"{{{warn_above} / {decimal(quantity.steps)}}}"
        warn_text = f"{text} {quantity.unit.name}"
    return MeasuredView(
        name=quantity.name,
        attribute=quantity.attribute,
        unit=quantity.unit.name,
        formula=f"adc / {channel.full_scale} * {decimal(channel.reference)} * mult",
        full_scale=channel.full_scale,
        citation=str(quantity.citation or ""),
        multiplier=parameter_attribute(multiplier.name),
        multiplier_name=multiplier.name,
        own_multiplier=parameter_expression(multiplier, "self.parameters"),
        names=multiplier.siblings,
        latched=multiplier.spec.reboot,
        numerator=conversion.numerator,
        denominator=conversion.denominator,
        warn_above=warn_above,
        warn_text=warn_text,
        warn_every_ms=threshold.every_ms if threshold else None,
        warnings=_own_numbers("warn_above", threshold.above if threshold else ()),
        warning_counts=_warning_counts(quantity, conversion, component, system),
        invalid_after=quantity.trust.invalid_after,
        stale_after_ms=quantity.trust.stale_after_ms,
        cited={aspect: quantity.cited(aspect) for aspect in QuantitySpec.ASPECTS},
    )


def _warning_counts(
    quantity: Quantity, conversion: Conversion, component: Component, system: System
) -> tuple[int | None, ...]:
    """The smallest count of each instance that is warned about with its default multiplier; None if there is none."""
    threshold = quantity.derivation.threshold
    if threshold is None:
        return (None,) * component.instances
    multipliers = by_instance(conversion.multiplier, system.parameters, component.instances)
    counts = []
    for multiplier, limit in zip(multipliers, threshold.above, strict=True):
        per_count = Fraction(multiplier.default * conversion.numerator, conversion.denominator)
        # Rounded to nearest, a result is above the threshold from half a step above it.
        first = math.ceil((limit + Fraction(1, 2)) / per_count)
        counts.append(first if 0 < first <= conversion.channel.full_scale else None)
    return tuple(counts)
