"""The cases of the generated test suite, as data: what is set, what must go out, and which criterion asks for it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from heapq import nsmallest

from codegen.model.system import (
    EachBinding,
    FlagsBinding,
    LiveBinding,
    PopulatedMessage,
    SplitBinding,
    System,
    read_quantities,
)
from codegen.model.vehicle import SMALL_INT_MAX, Quantity, QuantityKind
from codegen.targets.expected import (
    Known,
    Stored,
    converted,
    expected_fields,
    is_settable,
    limits_in_steps,
    nominal,
    nominal_values,
    rounded,
)
from codegen.targets.message_case import MessageCase, set_to
from codegen.targets.naming import parameter_attribute
from codegen.targets.representation_cases import representation_cases

_VARYING = (LiveBinding, SplitBinding, EachBinding, FlagsBinding)


@dataclass(frozen=True, slots=True)
class ConversionCase:
    """An ADC count and a multiplier in steps, and the stored integer that must come of them."""

    name: str
    requirement: str
    component: str
    parameter: str
    steps: int
    count: int
    attribute: str
    expect: int


def message_cases(system: System) -> list[MessageCase]:
    """Every case of every populated message, in order of id and offset."""
    return [case for message in system.messages for case in _cases_of(message, system)]


def conversion_cases(system: System) -> list[ConversionCase]:
    """Counts over the whole range of each ADC, with the smallest, the default and the largest multiplier."""
    cases = []
    for component, quantity in system.measured():
        conversion = quantity.conversion
        assert conversion is not None
        full = conversion.channel.full_scale
        parameter = conversion.multiplier
        for steps in sorted({parameter.minimum, parameter.default, parameter.maximum}):
            for count in sorted({0, 1, full // 2, 3000 * full // 4095, full - 1, full, *_sharpest(quantity, steps)}):
                cases.append(
                    ConversionCase(
                        name=f"{component}.{quantity.name}-{count}-times-{steps}",
                        requirement=quantity.cited("rounding"),
                        component=component,
                        parameter=parameter_attribute(parameter.name),
                        steps=steps,
                        count=count,
                        attribute=quantity.attribute,
                        expect=converted(quantity, count, steps),
                    )
                )
    return cases


def _sharpest(quantity: Quantity, steps: int) -> list[int]:
    """The counts whose exact result lies nearest to a half, for their size: the first to notice a wrong factor."""
    assert quantity.conversion is not None
    numerator, denominator = steps * quantity.conversion.numerator, quantity.conversion.denominator
    counts = range(1, quantity.conversion.channel.full_scale + 1)
    return nsmallest(8, counts, key=lambda count: abs(2 * (count * numerator % denominator) - denominator) / count)


def _cases_of(message: PopulatedMessage, system: System) -> Iterator[MessageCase]:
    used = used_quantities(message, system)
    for instance in range(message.instances):
        suffix = f"-{instance}" if message.instances > 1 else ""
        for page in range(message.pages):
            paged = f"{suffix}-page-{page}" if message.pages > 1 else suffix
            base = _base(used, instance)
            case = _case(message, f"nominal{paged}", str(message.citation), base, instance, used, page)
            yield replace(case, also=_constant_criteria(message))
    base = _base(used, 0)
    unknown: Known = {
        path: None if value is None or isinstance(value, int) else (None,) * len(value) for path, value in base.items()
    }
    yield _case(message, "everything-unknown", str(message.citation), unknown, 0, used)
    for binding in message.bindings:
        criterion = str(binding.covers.citation)
        if isinstance(binding, LiveBinding | SplitBinding) and isinstance(binding.source, Quantity):
            for name, value in _live_values(binding):
                known = {**base, binding.source.path: value}
                yield _case(message, f"{binding.covers.label}-{name}", criterion, known, 0, used)
            yield from _float_cases(message, binding, base, used)
        elif isinstance(binding, FlagsBinding):
            yield from _flag_cases(message, binding, used)
        elif isinstance(binding, EachBinding):
            yield from _each_cases(message, binding, used)
    yield from representation_cases(message, used)


def _constant_criteria(message: PopulatedMessage) -> tuple[str, ...]:
    """The criteria of what no state changes, and of which no other case is made."""
    constant = [binding.covers for binding in message.bindings if not isinstance(binding, _VARYING)]
    return tuple(sorted({str(covers.citation) for covers in constant} - {str(message.citation)}))


def _base(used: dict[str, Quantity], instance: int) -> dict[str, Stored]:
    """A plain value of everything that is read; a component of a single instance has only that."""
    return {
        path: nominal_values(quantity, instance if quantity.elements and instance < len(quantity.elements) else 0)
        for path, quantity in used.items()
    }


def _flag_cases(message: PopulatedMessage, binding: FlagsBinding, used: dict[str, Quantity]) -> Iterator[MessageCase]:
    """Each condition true and false, and of a limit also unknown: with the limit of every instance."""
    criterion, label = str(binding.covers.citation), binding.covers.label
    flags = [flag for flag, _, _ in binding.conditional]
    for flag, _, quantity in binding.conditional:
        path = quantity.path if is_settable(quantity) else f"{quantity.component}.{quantity.followed}"
        name = f"{label}-{flag}" + (f"-{quantity.name}" if flags.count(flag) > 1 else "")
        limits = quantity.follows.limits if quantity.follows else ()
        instances = range(message.instances) if len(set(limits)) > 1 else range(1)
        for instance in instances:
            base = _base(used, instance)
            values: dict[str, int | None] = {"set": 1, "clear": 0}
            if quantity.follows is not None:
                at, below = ("clear", "set") if quantity.follows.is_below else ("set", "clear")
                values = {at: limits[instance], below: limits[instance] - 1, "unknown": None}
            elif not is_settable(quantity):
                values = {"set": nominal(used[path]), "clear": None}
            suffix = f"-{instance}" if len(instances) > 1 else ""
            for state, value in values.items():
                yield _case(message, f"{name}-{state}{suffix}", criterion, {**base, path: value}, instance, used)


def _each_cases(message: PopulatedMessage, binding: EachBinding, used: dict[str, Quantity]) -> Iterator[MessageCase]:
    """All values at the ends of the range and beyond, each of them unknown, only one of them known."""
    criterion, label, path = str(binding.covers.citation), binding.covers.label, binding.source.path
    base = _base(used, 0)
    values = base[path]
    assert isinstance(values, tuple)
    rows: dict[str, tuple[int | None, ...]] = {
        name: (value,) * len(values) for name, value in _live_values(binding) if value is not None
    }
    for index in range(len(values)):
        rows[f"without-{index}"] = tuple(None if place == index else value for place, value in enumerate(values))
        rows[f"only-{index}"] = tuple(value if place == index else None for place, value in enumerate(values))
    for name, row in rows.items():
        for page in range(message.pages):
            suffix = f"-page-{page}" if message.pages > 1 else ""
            yield _case(message, f"{label}-{name}{suffix}", criterion, {**base, path: row}, 0, used, page)
    if binding.fallback is not None:
        for name, value in _live_values(binding.fallback):
            known = {**base, path: rows["without-0"], binding.fallback.source.path: value}
            yield _case(message, f"{label}-fallback-{name}", criterion, known, 0, used)


def used_quantities(message: PopulatedMessage, system: System) -> dict[str, Quantity]:
    """The quantities that tests of the message set, by path: those it reads, and those that these follow."""
    used = {}
    for binding in message.bindings:
        for quantity in read_quantities(binding):
            followed = quantity.followed
            source = system.components[quantity.component].quantities[followed] if followed else quantity
            used[source.path] = source
    return used


def _live_values(binding: LiveBinding | SplitBinding | EachBinding) -> Iterator[tuple[str, int | None]]:
    """Name and stored value: the ends of the range, beyond both, unknown, and what would read as the sentinel."""
    low, high = limits_in_steps(binding)
    source = binding.source
    yield "minimum", low
    yield "maximum", high
    yield "below-minimum", max(low - 1, -SMALL_INT_MAX)
    yield "above-maximum", min(high + 1, SMALL_INT_MAX)
    yield "far-below", -SMALL_INT_MAX
    yield "far-above", SMALL_INT_MAX
    yield "unknown", None
    yield "zero", 0
    step = 1 / binding.factor
    if isinstance(binding, SplitBinding):
        for cells in range(1, binding.covers.count + 1):
            for name, wire in (("full", 0), ("full-and-one", 1), ("full-less-one", -1)):
                yield f"{cells}-cells-{name}", rounded((cells * binding.cell_high + wire) * step, binding.rounding)
        yield "sentinel", rounded(binding.unused * step, binding.rounding)
        return
    sentinel = binding.covers.field.sentinel
    wire_sentinel = sentinel.values[binding.covers.first] if sentinel else None
    if isinstance(wire_sentinel, int) and isinstance(source, Quantity):
        yield "sentinel", rounded(Fraction(wire_sentinel) * step, binding.rounding)
    yield "minus-one", -1


def _float_cases(
    message: PopulatedMessage,
    binding: LiveBinding | SplitBinding,
    base: Known,
    used: dict[str, Quantity],
) -> Iterator[MessageCase]:
    """The same field set through the property for people: None, NaN, the infinities and a plain number."""
    quantity = binding.source
    if not isinstance(quantity, Quantity) or quantity.attribute == quantity.name:
        return
    if quantity.kind is not QuantityKind.NUMBER:
        return
    plain = nominal(quantity)
    for name, value, stored in (
        ("nan", "nan", None),
        ("none", None, None),
        ("infinity", "inf", SMALL_INT_MAX),
        ("minus-infinity", "-inf", -SMALL_INT_MAX),
        ("in-its-unit", float(plain / quantity.steps), plain),
    ):
        known = {**base, quantity.path: stored}
        case = _case(message, f"{binding.covers.label}-{name}", str(binding.covers.citation), known, 0, used)
        settings = [setting for setting in case.settings if setting[:2] != (quantity.component, quantity.attribute)]
        yield MessageCase(
            case.name,
            case.requirement,
            case.message,
            case.instance,
            (*settings, (quantity.component, quantity.name, value, 0)),
            case.expect,
        )


def _case(
    message: PopulatedMessage,
    name: str,
    requirement: str,
    known: Known,
    instance: int,
    used: dict[str, Quantity],
    page: int = 0,
) -> MessageCase:
    own = message.component.name if message.component else None
    settings = [
        setting
        for path, value in known.items()
        for setting in [set_to(used[path], value, instance if used[path].component == own else 0)]
    ]
    for choice in message.represents.values():
        enabled = choice.component.enabled
        if enabled is not None:  # so that it is about the first one
            settings += [set_to(enabled, 0, number) for number in range(1, choice.component.instances)]
    return MessageCase(
        name=f"{message.name}.{name}",
        requirement=requirement,
        message=message.name,
        instance=instance,
        settings=tuple(settings),
        expect=expected_fields(message, known, instance, page),
        page=page,
    )
