"""The derivation that measures with an ADC: the conversion of its counts, and the threshold of a logged warning."""

import dataclasses
import math
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.derivations.follows import BAD_FOLLOWING
from codegen.derivations.set_by_code import set_by_code
from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.measure import BAD_AMOUNT, UNCARRIED_CONVERSION, UNIT_MISMATCH
from codegen.model.answers.step import Step
from codegen.model.dialect.literals import exact_number
from codegen.model.quantities.conversion import Constant, Conversion, Factor, factors_by_instance
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.quantities.trust import Threshold
from codegen.model.spec.derivation import MeasuredSpec
from codegen.model.units.unit import NUMBER, Unit, conversion, decimal, ratio, read_measure, unit_named
from codegen.model.vehicle import Parameter, Quantity, Represented, by_instance

if TYPE_CHECKING:
    from codegen.model.system import System

VOLT = unit_named("V")
"""The unit that an ADC measures in."""

UNKNOWN_ADC = Rule(
    "unknown-adc",
    "A quantity names an ADC channel that board.yaml does not have.",
    remedy="write it in board.yaml: adc: {name: {pin: PARAMETER}}",
)

BAD_PREFERENCE = Rule(
    "bad-preference",
    "What a measured quantity prefers is a list of the same component that code sets, in the same unit "
    "and stored alike.",
    remedy="write prefers: and the name of a list of this component that code sets",
)

ADC_FAULTS = {
    "fail": "ADC readings fail",
    "absent": "ADC absent",
    "slow": "ADC readings take longer",
    "stuck": "ADC readings stay as they were",
}
"""Faults of an input in a simulation."""


@dataclass(frozen=True, slots=True)
class Measured(Derivation):
    """Read from ``adc`` at the update rate of the component; ``warns`` above a threshold, or never.

    The sum of ``first``, a list of the component, comes before what is read while all of it is known.
    """

    adc: Conversion
    warns: Threshold | None
    first: str | None
    by_code: Represented | None = None

    @property
    def prefers(self) -> str | None:
        return self.first

    @property
    def conversion(self) -> Conversion | None:
        return self.adc

    @property
    def threshold(self) -> Threshold | None:
        return self.warns

    @property
    def represented(self) -> Represented | None:
        return self.by_code

    def names(self, quantity: Quantity) -> tuple[str, ...]:
        return (f"{quantity.name}_from_adc",)

    def uses(self, quantity: Quantity) -> Iterator[tuple[Parameter, str]]:
        for factor, role in zip(self.adc.factors, ("multiplier", "offset"), strict=False):
            if isinstance(factor, Parameter):
                yield factor, f"the {role} of {quantity.path}"
        if self.adc.channel.when is not None:
            yield self.adc.channel.when[0], f"whether {quantity.path} is read"
        if self.by_code is not None:
            yield self.by_code.parameter, f"whether code sets {quantity.path}"

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        adc, stored = self.adc, quantity.stored.name
        text = f"ADC {adc.channel.name} * {adc.multiplier.name} steps * {adc.numerator} / {adc.denominator}"
        if adc.offset is not None or adc.offset_numerator:
            away = adc.offset.name if adc.offset else "no"
            text = f"{text} - {away} steps * {adc.offset_numerator} / {adc.denominator}"
        if adc.low is not None or adc.high is not None:
            text = f"{text}, limited to {adc.low}..{adc.high}"
        if adc.channel.when is not None:
            text = f"{text}, while {adc.channel.when[0].name} is {adc.channel.when[1]}"
        yield DerivationFact("measured", text, "adc")
        if self.first is not None:
            yield DerivationFact("prefers", f"the sum of {self.first}", "prefers")
        if self.by_code is not None:
            where = f"while {self.by_code.parameter.name} is {self.by_code.steps}"
            yield DerivationFact("set by code", f"{where}, for {self.by_code.stale_after_ms} ms", "set_at")
        if self.warns is not None:
            above = ", ".join(f"{limit} {stored}".rstrip() for limit in dict.fromkeys(self.warns.above))
            yield DerivationFact("warns above", above, "warn_above", is_trust=True)
            if self.warns.every_ms is not None:
                yield DerivationFact("warns every", f"{self.warns.every_ms} ms", "warn_every", is_trust=True)

    def simulated(
        self, quantity: Quantity, instance: int, system: "System", parameters: Mapping[str, float]
    ) -> SimulatedInput:
        conversion, count = self.adc, system.components[quantity.component].instances
        channel = conversion.channel
        if self.by_code is not None:
            setting = by_instance(self.by_code.parameter, system.parameters, count)[instance]
            if parameters.get(setting.name, float(setting.default * setting.step)) == self.by_code.steps * setting.step:
                return set_by_code(quantity, instance)
        gpio: float = channel.gpio
        if channel.pin is not None:
            pin = by_instance(channel.pin, system.parameters, count)[instance]
            gpio = parameters.get(pin.name, float(pin.default * pin.step))
        steps = []
        for factor in conversion.factors:
            own = factors_by_instance(factor, system.parameters, count)[instance]
            stored = parameters.get(own.name)
            steps.append(own.default if stored is None else round(Fraction(stored).limit_denominator(10**6) / own.step))
        zero, full = (conversion.exact(end, *steps) / quantity.steps for end in (0, channel.full_scale))
        return SimulatedInput("adc", {"gpio": round(gpio), "zero": float(zero), "full": float(full)}, ADC_FAULTS)

    def words(self, quantity: Quantity) -> str:
        channel = self.adc.channel
        return f"GPIO {channel.pin.name if channel.pin else channel.gpio}: {self.adc.formula}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        samples = f"mean of {self.adc.channel.samples} samples on GPIO {self._pins(quantity, system)}"
        yield "measured", f"{samples}, {self.adc.formula}"
        if self.first is not None:
            yield "rather", f"the sum of {self.first}, while all of them are known"
        if self.by_code is not None:
            held = f"which counts for {self.by_code.stale_after_ms} ms"
            yield "elsewhere", f"set by code where {self.by_code.parameter.name} is {self.by_code.steps}, {held}"
        if self.warns is not None:
            pause = "" if self.warns.every_ms is None else f", every {self.warns.every_ms} ms at most"
            limits = ", ".join(str(limit) for limit in dict.fromkeys(self.warns.above))
            yield "warning", f"above {limits} {quantity.stored.name}{pause}"

    def way(self, quantity: Quantity, system: "System") -> Iterator[Step]:
        channel = self.adc.channel
        chosen = f", chosen by {channel.pin.name}" if channel.pin else ""
        yield Step(
            "sensor",
            f"ADC, GPIO {self._pins(quantity, system)}{chosen}",
            (
                f"mean of {channel.samples} samples of {channel.bits} bits, 0..{channel.full_scale}",
                f"every {system.components[quantity.component].read_every_ms} ms",
            ),
            tuple(dict.fromkeys((*channel.criteria("samples"), *channel.criteria()))),
        )
        yield Step(
            "conversion",
            self.adc.formula,
            (*map(_range, self.adc.factors), f"to the nearest {quantity.stored.name}".rstrip()),
            quantity.criteria("multiplier", "rounding"),
        )

    def _pins(self, quantity: Quantity, system: "System") -> str:
        gpios = system.gpios(system.components[quantity.component], self.adc.channel)
        return " and ".join(dict.fromkeys(map(str, gpios)))


def resolve_measured(written: MeasuredSpec, kept: Kept, around: Surroundings) -> Measured | None:
    """The conversion and the threshold; None after a finding."""
    warns, conversion = _threshold(written, kept, around), _conversion(written, kept, around)
    if conversion is None or not _can_prefer(written, around):
        return None
    represented = _represented(written, around)
    return None if around.failed else Measured(conversion, warns, written.prefers, represented)


def _represented(written: MeasuredSpec, around: Surroundings) -> Represented | None:
    """Return where code sets the quantity in place of the ADC; None where that is nowhere, or after a finding."""
    if not written.set_at:
        if written.set_stale_after is not None:
            around.bad(
                "set_stale_after",
                f"{around.name} is set by code nowhere, so set_stale_after says nothing",
                hint="leave it out, or say when code sets it: set_at: {PARAMETER: 4}",
            )
        return None
    (name, value), *more = written.set_at.items()
    if more:
        around.bad(
            "set_at",
            f"set_at of {around.name} has one parameter, not {len(written.set_at)}",
            hint=f"keep one of them: {{{name}: {decimal(value)}}}",
        )
    inputs = [name for name, other in around.others.items() if (read := other.written(MeasuredSpec)) and read.adc]
    if inputs[0] != around.name:
        around.bad(
            "set_at",
            f"the converter reads {inputs[0]} before {around.name}: only the first one has set_at",
            hint=f"write set_at at {inputs[0]}",
        )
    if written.set_stale_after is None:
        around.bad(
            "set_at",
            f"{around.name} needs set_stale_after, for what code no longer sets is not true for ever",
            hint="set_stale_after: 2 s",
        )
    stale_ms = around.time_ms("set_stale_after", written.set_stale_after)
    parameter = around.parameter("set_at", name)
    if parameter is None or stale_ms is None or around.failed:
        return None
    steps = value / parameter.step
    if steps == 0 or steps not in (parameter.choices or range(parameter.minimum, parameter.maximum + 1)):
        around.bad(
            "set_at",
            f"{name} is never {decimal(value)}, so code never sets {around.name}",
            hint=f"write a value that {name} can have, other than 0",
        )
        return None
    if not parameter.spec.reboot:
        around.bad("set_at", f"{name} is looked at when the board starts", hint=f"{name}: reboot: true")
    return Represented(parameter, int(steps), stale_ms)


def _can_prefer(written: MeasuredSpec, around: Surroundings) -> bool:
    """Return whether what it prefers is a list of numbers that are stored alike; False after a finding."""
    name = written.prefers
    if name is None:
        return True
    other = around.others.get(name)
    if other is None:
        around.no_quantity("prefers", name, BAD_PREFERENCE)
    elif other.elements is None or other.enum is not None:
        around.bad(
            "prefers",
            f"{name} is no list of numbers",
            BAD_PREFERENCE,
            hint=f"write elements at {name}, or name a list of the component",
        )
    elif (other.unit, other.stored) != (around.spec.unit, around.spec.stored):
        message = f"{name} is not stored in {around.spec.stored or around.spec.unit}, as {around.name} is"
        around.bad(
            "prefers",
            message,
            BAD_PREFERENCE,
            hint=f"give both the same unit and stored, such as {around.spec.stored or around.spec.unit}",
        )
    elif other.derivations:
        around.bad(
            "prefers",
            f"{name} is not set by code",
            BAD_PREFERENCE,
            hint=f"name a list that code sets, or leave out what {name} comes from",
        )
    return not around.failed


def _conversion(written: MeasuredSpec, kept: Kept, around: Surroundings) -> Conversion | None:
    stored = kept.stored
    if not _is_whole(written, around):
        return None
    assert written.adc is not None
    assert written.multiplier is not None
    channel = around.channels.get(written.adc)
    if channel is None and f"adc.{written.adc}" not in around.whole.board.places:
        hint = did_you_mean(written.adc, around.channels)
        around.bad("adc", f"board.yaml has no ADC channel {written.adc}", UNKNOWN_ADC, hint)
    per_volt = Unit.parse(f"{stored.name or 1}/V")
    multiplier = _factor("multiplier", written.multiplier, around)
    offset = None if written.offset is None else _factor("offset", written.offset, around)
    if channel is None or multiplier is None or (written.offset is not None and offset is None):
        return None  # without them there is no conversion; whatever is wrong with them was reported
    factor = None if per_volt is None else ratio(multiplier.unit, per_volt)
    if factor is None:
        message = (
            f"{multiplier.name} makes no {stored.kind} of {VOLT.a_kind}: it is in {multiplier.unit.name or 'no unit'}"
        )
        hint = "a pure number" if ratio(VOLT, stored) else f"give it a unit per volt, such as {stored.name}/V"
        around.bad("multiplier", message, UNIT_MISMATCH, hint)
        return None
    _check_zero(multiplier, kept, around)
    away = Fraction(0) if offset is None else ratio(offset.unit, VOLT)
    if away is None:
        assert offset is not None
        around.bad(
            "offset",
            f"{offset.name} is {offset.unit.a_kind}, but {VOLT.a_kind} is needed",
            UNIT_MISMATCH,
            hint="name a parameter in V, or write an amount such as 330 mV",
        )
        return None
    if isinstance(multiplier, Constant) and not multiplier.minimum:
        message = f"{around.name} is 0 whatever is measured: its multiplier is {written.multiplier}"
        around.bad("multiplier", message, BAD_AMOUNT, "write how much a volt at the pin stands for, or leave out adc")
        return None
    if offset is None and multiplier.minimum < 0:
        around.bad(
            "multiplier",
            f"{multiplier.name} can be negative, and what is measured never is",
            UNIT_MISMATCH,
            hint="take one that is 0 or more, or add an offset",
        )
    step = multiplier.step * factor
    count = channel.reference / channel.full_scale * step
    shift = Fraction(0) if offset is None else offset.step * away * step
    denominator = math.lcm(count.denominator, shift.denominator)
    found = Conversion(channel, multiplier, int(count * denominator), denominator, offset, int(shift * denominator))
    if offset is None:
        return found
    low, high = found.ends(multiplier, offset)
    return dataclasses.replace(
        found,
        low=math.ceil(kept.minimum) if around.spec.min is not None and low < kept.minimum else None,
        high=math.floor(kept.maximum) if around.spec.max is not None and high > kept.maximum else None,
    )


def _check_zero(multiplier: Factor, kept: Kept, around: Surroundings) -> None:
    """Report a multiplier that counts from another zero than the quantity: 100 K/V makes kelvins, not degC."""
    top, _, _ = multiplier.unit.name.rpartition("/")
    made = Unit.parse(top) if top else None
    way = None if made is None else conversion(made, kept.unit)
    if way is not None and way.offset:
        unit = kept.unit.name
        message = f"{multiplier.name} makes {top} of {VOLT.a_kind}, and from those to {unit} leads an offset"
        hint = f"give it in {unit}/V, and as offset the {VOLT.kind} at 0 {unit}"
        around.bad("multiplier", message, UNCARRIED_CONVERSION, hint)


def _is_whole(written: MeasuredSpec, around: Surroundings) -> bool:
    """Return whether all is written that a conversion needs; what stands alone is reported."""
    if written.adc is None and written.multiplier is None and written.offset is None:
        for key in ("warn_above", "warn_every"):
            if getattr(written, key) is not None:
                around.bad(
                    key,
                    f"{around.name} has no adc, so {key} says nothing",
                    hint=f"leave out {key}, or write adc and multiplier",
                )
        return False
    if written.adc is None or written.multiplier is None:
        given = next(key for key in ("adc", "multiplier", "offset") if getattr(written, key) is not None)
        around.bad(
            given,
            f"{around.name} needs both adc and multiplier, or neither",
            hint="add the other one, or leave out all of adc, multiplier and offset",
        )
        return False
    return True


def _factor(key: str, written: str, around: Surroundings) -> Factor | None:
    """A parameter by its name, or an amount, or a number; None after a finding."""
    if not re.match(r"[-+.\d]", written):
        return around.parameter(key, written)
    measure = read_measure(written)
    if measure is not None:
        return Constant(measure.value, measure.unit)
    number = exact_number(written)
    if number is None:
        message = f"{written!r} is neither a parameter nor an amount"
        around.bad(key, message, BAD_AMOUNT, f"write {key}: and the name of a parameter, or {key}: 17 A/V")
        return None
    return Constant(number, NUMBER)


def _range(factor: Factor) -> str:
    """Return what a factor can be, for people."""
    if isinstance(factor, Constant):
        return f"always {factor.name}"
    low, default, high = (decimal(steps * factor.step) for steps in (factor.minimum, factor.default, factor.maximum))
    return f"{factor.name} {default} by default, {low}..{high}"


def _threshold(written: MeasuredSpec, kept: Kept, around: Surroundings) -> Threshold | None:
    """The value above which a warning is logged, by instance; None where none is written, or after a finding."""
    every_ms = around.time_ms("warn_every", written.warn_every)
    if written.warn_above is None:
        return None
    limits = [written.warn_above * kept.steps] * len(around.parts)
    if around.spec.per is not None:
        counts = around.counted(around.spec.per, "per", BAD_FOLLOWING) or ()
        limits = [Fraction(round(limit * count)) for limit, count in zip(limits, counts, strict=False)]
    return Threshold(tuple(around.in_steps("warn_above", limit, Fraction(1)) for limit in limits), every_ms)
