"""The cases of the generated test suite, as data: what is set, what must go out, and which criterion asks for it."""

from collections.abc import Iterator
from dataclasses import replace
from heapq import nsmallest

from codegen.frozen import dataclass
from codegen.model.answers.account import StateCase
from codegen.model.answers.known import Known, Stored
from codegen.model.quantities.conversion import Conversion
from codegen.model.system import PopulatedMessage, System
from codegen.model.vehicle import Parameter, Quantity, Reading
from codegen.once import once
from codegen.targets.firmware.readings.board import adc_input
from codegen.targets.naming import parameter_attribute
from codegen.targets.suite.cases.case import MessageCase, set_to
from codegen.targets.suite.cases.representations import representation_cases
from codegen.targets.suite.expected import converted, expected_fields, nominal_values


@dataclass(frozen=True, slots=True)
class ConversionCase:
    """An ADC count and parameters in steps, by their attributes, and the stored integer that must come of them.

    ``setter`` is the method of the mock that sets the count.
    """

    name: str
    requirement: str
    component: str
    parameters: dict[str, int]
    setter: str
    count: int
    attribute: str
    expect: int


@once
def message_cases(system: System) -> list[MessageCase]:
    """Every case of every populated message, in order of id and offset."""
    return [case for message in system.messages for case in _cases_of(message, system)]


@once
def conversion_cases(system: System) -> list[ConversionCase]:
    """Counts over the whole range of each ADC, with the smallest, the default and the largest of each factor."""
    return [
        case
        for place, reading in enumerate(system.readings())
        for case in _of_reading(reading, f"set_{adc_input(reading.name, place)}_value")
    ]


def _of_reading(reading: Reading, setter: str) -> Iterator[ConversionCase]:
    conversion, quantity = reading.conversion, reading.quantity
    full, multiplier, offset = conversion.channel.full_scale, conversion.multiplier, conversion.offset
    when = conversion.channel.when
    switched = {} if when is None else {first_attribute(when[0]): when[1]}
    for steps in sorted({multiplier.minimum, multiplier.default, multiplier.maximum}):
        is_default = steps == multiplier.default
        ends = {0} if offset is None else {offset.default} if is_default else {offset.minimum, offset.maximum}
        for away in sorted(ends):
            sharp = _sharpest(conversion, steps, away, 8 if offset is None else 3)
            for count in sorted({0, 1, full // 2, 3000 * full // 4095, full - 1, full, *sharp}):
                name = f"{reading.component.name}.{quantity.name}-{count}-times-{steps}"
                settings = switched | {
                    first_attribute(factor): value
                    for factor, value in zip(conversion.factors, (steps, away), strict=False)
                    if isinstance(factor, Parameter)
                }
                yield ConversionCase(
                    name=name if offset is None else f"{name}-from-{away}",
                    requirement=quantity.cited("rounding"),
                    component=reading.component.name,
                    parameters=settings,
                    setter=setter,
                    count=count,
                    attribute=quantity.attribute,
                    expect=converted(quantity, conversion, count, steps, away),
                )


def first_attribute(parameter: Parameter) -> str:
    """The attribute of a parameter, of a family that of the first instance."""
    return parameter_attribute(parameter.siblings[0] if parameter.siblings else parameter.name)


def _sharpest(conversion: Conversion, steps: int, away: int, most: int) -> list[int]:
    """The counts whose exact result lies nearest to a half, for their size: the first to notice a wrong factor."""
    denominator = conversion.denominator
    counts = range(1, conversion.channel.full_scale + 1)

    def distance(count: int) -> float:
        product = (count * conversion.numerator - away * conversion.offset_numerator) * steps
        return abs(2 * (product % denominator) - denominator) / count

    return nsmallest(most, counts, key=distance)


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
    unknown: Known = {path: (None,) * len(value) if isinstance(value, tuple) else None for path, value in base.items()}
    yield _case(message, "everything-unknown", str(message.citation), unknown, 0, used)
    for answer in message.answers:
        for state in answer.cases(base, message.instances, message.pages):
            name = f"{answer.covers.label}-{state.name}"
            yield _state_case(message, name, str(answer.covers.citation), state, used)
    yield from representation_cases(message, used)


def _constant_criteria(message: PopulatedMessage) -> tuple[str, ...]:
    """The criteria of what no state changes, and of which no other case is made."""
    constant = [answer.covers for answer in message.answers if not answer.varies]
    return tuple(sorted({str(covers.citation) for covers in constant} - {str(message.citation)}))


def _base(used: dict[str, Quantity], instance: int) -> dict[str, Stored]:
    """A plain value of everything that is read; a component of a single instance has only that."""
    return {
        path: nominal_values(quantity, instance if quantity.elements and instance < len(quantity.elements) else 0)
        for path, quantity in used.items()
    }


def used_quantities(message: PopulatedMessage, system: System) -> dict[str, Quantity]:
    """The quantities that tests of the message set, by path: those it reads, and those that these follow."""
    used = {}
    for answer in message.answers:
        for quantity in answer.quantities:
            source = system.quantity(quantity.decided_by) or quantity
            used[source.path] = source
    return used


def _state_case(
    message: PopulatedMessage, name: str, criterion: str, state: StateCase, used: dict[str, Quantity]
) -> MessageCase:
    """The case of a state; what is written through a property for people is not set otherwise."""
    known = {**_base(used, state.instance), **state.changes}
    case = _case(message, name, criterion, known, state.instance, used, state.page)
    if state.written is None:
        return case
    quantity, value = state.written
    settings = [setting for setting in case.settings if setting[:2] != (quantity.component, quantity.attribute)]
    return replace(case, settings=(*settings, (quantity.component, quantity.name, value, 0)))


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
        set_to(used[path], value, instance if used[path].component == own else 0)
        for path, value in known.items()
        if path in used
    ]
    settings += [
        ("parameters", first_attribute(parameter), steps, 0)
        for parameter in {each.path: each for answer in message.answers for each in answer.parameters}.values()
        if isinstance(steps := known.get(parameter.path), int)
    ]
    for choice in message.represents.values():
        enabled = choice.component.enabled
        if enabled is not None:  # switched off, so that the message is about the first instance
            settings += [set_to(enabled, 0, number) for number in range(1, choice.component.instances)]
    return MessageCase(
        name=f"{message.name}.{name}",
        requirement=requirement,
        message=message.wire.name,
        table=message.name,
        instance=instance,
        settings=tuple(settings),
        expect=expected_fields(message, known, instance, page),
        page=page,
    )
