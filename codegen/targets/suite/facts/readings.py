"""Facts about single readings that the tests of whole components leave out."""

from collections.abc import Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.quantities.conversion import Factor
from codegen.model.system import System
from codegen.model.vehicle import Parameter, Reading
from codegen.targets.firmware.readings.board import adc_input
from codegen.targets.naming import parameter_attribute
from codegen.targets.suite.cases.messages import first_attribute

Settings = Mapping[str, int]
"""Steps of parameters, by their attributes."""


@dataclass(frozen=True, slots=True)
class InputFacts:
    """A reading as others know it: its input in the mock, its attribute, and two counts that differ in its value."""

    name: str
    input: str
    component: str
    several: bool
    attribute: str
    counts: tuple[int, int]


@dataclass(frozen=True, slots=True)
class LastingFacts:
    """The time that ``left`` lasts: ``left * factor`` over a mean that follows the reading within so many readings."""

    attribute: str
    left: str
    factor: int
    readings: int
    most: int
    citation: str


@dataclass(frozen=True, slots=True)
class SumFacts:
    """A sum of a reading, or of its products with ``times`` where that is a name; ``parts`` are a step of the sum.

    ``is_after``: of the same pass, in which ``times`` is read before it.
    """

    attribute: str
    times: str | None
    is_after: bool
    parts: int
    least: int
    most: int
    citation: str


@dataclass(frozen=True, slots=True)
class RestFacts:
    """The rest of the parameter ``full`` after the sum ``after``; its step is so many ``steps`` of the sum.

    ``share``: the steps that are all of it, where a part of it is told. ``sizes`` are values of the parameter.
    """

    attribute: str
    after: str
    full: str
    steps: int
    share: int | None
    most: int
    sizes: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class ReadingFacts:
    """A reading with the others of its component; ``on`` are the settings with which it is read.

    With each of ``off`` it is not; with those of ``apart``, one for each instance, that one alone is read, at the pin
    ``pins[0]``, and the parameters of all others have ``pins[1]``, and other factors. ``extremes`` are those with the
    smallest and the largest factors, and ``builders`` the messages that notice its age.
    """

    own: InputFacts
    others: tuple[InputFacts, ...]
    instances: int
    full_scale: int
    invalid_after: int | None
    stale_after_ms: int | None
    on: Settings
    off: tuple[Settings, ...]
    apart: tuple[Settings, ...]
    pins: tuple[int, ...]
    extremes: tuple[Settings, ...]
    builders: tuple[str, ...]
    lasting: LastingFacts | None
    sums: tuple[SumFacts, ...]
    rests: tuple[RestFacts, ...]
    cited: Mapping[str, str]


def reading_facts(system: System) -> tuple[ReadingFacts, ...]:
    """The readings behind the first of a component, and those that are more than a count times a parameter."""
    return tuple(_facts(reading, system) for reading in system.readings() if not reading.is_plain)


def _facts(reading: Reading, system: System) -> ReadingFacts:
    component, quantity, conversion = reading.component, reading.quantity, reading.conversion
    on, off = switched(reading)
    apart, pins = _apart(reading)
    others = [each for each in component.readings if each is not reading and each.quantity is not quantity]
    return ReadingFacts(
        own=_input(reading, system),
        others=tuple(_input(each, system) for each in others),
        instances=component.instances,
        full_scale=conversion.channel.full_scale,
        invalid_after=quantity.trust.invalid_after,
        stale_after_ms=quantity.trust.stale_after_ms,
        on=on,
        off=off,
        apart=apart,
        pins=pins,
        extremes=tuple({**on, **found} for found in _extremes(conversion.factors)),
        builders=_builders(reading, system),
        lasting=_lasting(reading),
        sums=tuple(_sums(reading)),
        rests=tuple(_rests(reading)),
        cited={
            "failure": quantity.cited("invalid_after"),
            "stale_after": quantity.cited("stale_after"),
            "robustness": component.cited("robustness"),
            "steady": component.cited("steady"),
            "when": conversion.channel.cited("when"),
            "pin": conversion.channel.cited("pin"),
        },
    )


def _lasting(reading: Reading) -> LastingFacts | None:
    for quantity in reading.given:
        if found := quantity.derivation.lasts:
            left = reading.component.quantities[found.left]
            most, citation = int(quantity.maximum), str(quantity.citation or "")
            return LastingFacts(quantity.attribute, left.attribute, found.factor, found.readings, most, citation)
    return None


def _sums(reading: Reading) -> Iterator[SumFacts]:
    order = [each.quantity.name for each in reading.component.readings]
    for quantity in reading.sums:
        if found := quantity.derivation.sums:
            yield SumFacts(
                quantity.attribute,
                reading.component.quantities[found.times].attribute if found.times else None,
                found.times in order[: order.index(found.of)],
                found.parts,
                int(quantity.minimum),
                int(quantity.maximum),
                str(quantity.citation or ""),
            )


def _rests(reading: Reading) -> Iterator[RestFacts]:
    for quantity in reading.given:
        if found := quantity.derivation.remains:
            after, full = reading.component.quantities[found.after], found.full
            sizes = sorted({full.minimum, full.default, min(full.minimum + 7, full.maximum)})
            yield RestFacts(
                quantity.attribute,
                after.attribute,
                first_attribute(full),
                found.steps,
                found.share,
                int(quantity.maximum),
                tuple(sizes),
            )


def _input(reading: Reading, system: System) -> InputFacts:
    place = [each.name for each in system.readings()].index(reading.name)
    component = reading.component
    several = component.instances > 1
    attribute = reading.quantity.attribute
    return InputFacts(
        reading.name, adc_input(reading.name, place), component.name, several, attribute, _counts(reading)
    )


def _counts(reading: Reading) -> tuple[int, int]:
    """Two counts of different values, with the default factors, within all limits and without a warning."""
    conversion, threshold = reading.conversion, reading.quantity.derivation.threshold
    steps = [factor.default for factor in conversion.factors]
    ends = (conversion.low, conversion.high, *(threshold.above if threshold else ()))
    found: dict[int, int] = {}
    for part in range(20, 0, -1):
        count = conversion.channel.full_scale * part // 32
        value = conversion.stored(count, *steps)
        if value not in ends and not any(
            threshold and value > limit for limit in (threshold.above if threshold else ())
        ):
            found.setdefault(value, count)
    counts = list(found.values())
    return (counts[0], counts[1]) if len(counts) > 1 else (0, conversion.channel.full_scale)


def switched(reading: Reading) -> tuple[dict[str, int], tuple[Settings, ...]]:
    """Return parameter values with which the reading is taken, and sets of values with which it is not."""
    switch, when = reading.component.switch, reading.conversion.channel.when
    on: dict[str, int] = {}
    off: list[Settings] = []
    if switch is not None and not reading.is_first:  # others may be at the pin that the first one takes then
        on.update({parameter_attribute(name): 0 for name in switch.siblings[1:]})
    if switch is not None and switch.default == 0:
        on[first_attribute(switch)] = max(switch.choices or (switch.maximum,))
    if when is not None:
        parameter, steps = when
        on[first_attribute(parameter)] = steps
        other = [value for value in parameter.choices or (parameter.minimum, parameter.maximum) if value != steps]
        off += [{**on, first_attribute(parameter): value} for value in other]
    return on, tuple(off)


def _apart(reading: Reading) -> tuple[tuple[Settings, ...], tuple[int, ...]]:
    """Return settings with which one instance alone is read, for each, and the two pins of these; none without such."""
    channel, count = reading.conversion.channel, reading.component.instances
    pin, switch = channel.pin, reading.component.switch
    if pin is None or count < 2 or len(pin.siblings) != count:
        return (), ()
    known = tuple(pin.choices) or (pin.minimum, pin.maximum)
    chosen = [] if switch is None else [(switch, max(switch.choices or (switch.maximum,)))]
    chosen += [channel.when] if channel.when else []
    rests = [quantity.derivation.remains for quantity in reading.given]
    factors = [*reading.conversion.factors, *(rest.full for rest in rests if rest)]
    chosen += [(each, each.default) for each in factors if isinstance(each, Parameter)]
    found = []
    for instance in range(count):
        steps = dict.fromkeys(pin.siblings, known[-1]) | {pin.siblings[instance]: known[0]}
        for parameter, value in chosen:
            other = parameter.minimum if parameter.minimum != value else parameter.maximum
            steps |= dict.fromkeys(parameter.siblings, other)
            steps[(parameter.siblings or (parameter.name,) * count)[instance]] = value
        found.append({parameter_attribute(name): steps[name] for name in sorted(steps)})
    return (tuple(found), (known[0], known[-1])) if known[0] != known[-1] else ((), ())


def _extremes(factors: tuple[Factor, ...]) -> Iterator[dict[str, int]]:
    for at in (0, 1):
        yield {
            first_attribute(factor): (factor.minimum, factor.maximum)[at]
            for factor in factors
            if isinstance(factor, Parameter)
        }


def _builders(reading: Reading, system: System) -> tuple[str, ...]:
    """The messages, in lower case, whose builders read what comes of a reading and so notice that it is old."""
    given = {f"{reading.component.name}.{quantity.name}" for quantity in reading.given}
    return tuple(
        message.name.lower()
        for message in system.messages
        if any(quantity.decided_by in given for answer in message.answers for quantity in answer.quantities)
    )
