"""What an ADC measures: the conversion from its counts, and the value above which a warning is logged."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.derivations.follows import BAD_FOLLOWING
from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.measure import UNIT_MISMATCH
from codegen.model.derivation import Derivation, DerivationFact
from codegen.model.derivation_spec import MeasuredSpec
from codegen.model.simulated import SimulatedInput
from codegen.model.step import Step
from codegen.model.unit import NUMBER, Unit, decimal, ratio, unit_named
from codegen.model.vehicle import Conversion, Parameter, Quantity, Threshold, by_instance

if TYPE_CHECKING:
    from codegen.model.system import System

UNKNOWN_ADC = Rule("unknown-adc", "A quantity names an ADC channel that board.yaml does not have.")

ADC_FAULTS = {
    "fail": "ADC readings fail",
    "absent": "ADC absent",
    "slow": "ADC readings take longer",
    "stuck": "ADC readings stay as they were",
}
"""What can be wrong with an input in a simulation."""


@dataclass(frozen=True, slots=True)
class Measured(Derivation):
    """Read from ``adc`` at the update rate of the component; ``warns`` above a threshold, or never."""

    adc: Conversion
    warns: Threshold | None

    @property
    def conversion(self) -> Conversion | None:
        return self.adc

    @property
    def threshold(self) -> Threshold | None:
        return self.warns

    def names(self, quantity: Quantity) -> tuple[str, ...]:
        return (f"{quantity.name}_from_adc",)

    def uses(self, quantity: Quantity) -> Iterator[tuple[Parameter, str]]:
        yield self.adc.multiplier, f"the multiplier of {quantity.path}"

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        adc, stored = self.adc, quantity.stored.name
        text = f"ADC {adc.channel.name} * {adc.multiplier.name} steps * {adc.numerator} / {adc.denominator}"
        yield DerivationFact("measured", text, "adc")
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
        multiplier = by_instance(conversion.multiplier, system.parameters, count)[instance]
        gpio: float = channel.gpio
        if channel.pin is not None:
            pin = by_instance(channel.pin, system.parameters, count)[instance]
            gpio = parameters.get(pin.name, float(pin.default * pin.step))
        stored = parameters.get(multiplier.name)
        steps = multiplier.default if stored is None else Fraction(stored).limit_denominator(10**6) / multiplier.step
        full = channel.full_scale * steps * Fraction(conversion.numerator, conversion.denominator) / quantity.steps
        return SimulatedInput("adc", {"gpio": round(gpio), "zero": 0.0, "full": float(full)}, ADC_FAULTS)

    def words(self, quantity: Quantity) -> str:
        channel = self.adc.channel
        return f"GPIO {channel.pin.name if channel.pin else channel.gpio}: {self.adc.formula}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        samples = f"mean of {self.adc.channel.samples} samples on GPIO {self._pins(quantity, system)}"
        yield "measured", f"{samples}, {self.adc.formula}"
        if self.warns is not None:
            pause = "" if self.warns.every_ms is None else f", every {self.warns.every_ms} ms at most"
            limits = ", ".join(str(limit) for limit in dict.fromkeys(self.warns.above))
            yield "warning", f"above {limits} {quantity.stored.name}{pause}"

    def way(self, quantity: Quantity, system: "System") -> Iterator[Step]:
        channel, multiplier = self.adc.channel, self.adc.multiplier
        chosen = f", chosen by {channel.pin.name}" if channel.pin else ""
        yield Step(
            "sensor",
            f"ADC, GPIO {self._pins(quantity, system)}{chosen}",
            (
                f"mean of {channel.samples} samples of {channel.bits} bits, 0..{channel.full_scale}",
                f"every {system.components[quantity.component].period_ms or 100} ms",
            ),
            tuple(dict.fromkeys((*channel.criteria("samples"), *channel.criteria()))),
        )
        low, default, high = (
            decimal(steps * multiplier.step) for steps in (multiplier.minimum, multiplier.default, multiplier.maximum)
        )
        yield Step(
            "conversion",
            self.adc.formula,
            (f"{multiplier.name} {default} by default, {low}..{high}", f"to the nearest {quantity.stored.name}"),
            quantity.criteria("multiplier", "rounding"),
        )

    def _pins(self, quantity: Quantity, system: "System") -> str:
        gpios = system.gpios(system.components[quantity.component], self.adc.channel)
        return " and ".join(dict.fromkeys(map(str, gpios)))


def resolve_measured(written: MeasuredSpec, kept: Kept, around: Surroundings) -> Measured | None:
    """The conversion and the threshold; None after a finding."""
    warns, conversion = _threshold(written, kept, around), _conversion(written, around, kept.stored)
    if conversion is None:
        return None
    first = next(name for name, other in around.others.items() if other.written(MeasuredSpec) is not None)
    if first != around.name:
        related = [(around.others[first].at("adc"), f"{first} is measured, too")]
        around.bad("adc", "a component has one quantity that an ADC measures", related=related)
    return Measured(conversion, warns)


def _conversion(written: MeasuredSpec, around: Surroundings, stored: Unit) -> Conversion | None:
    if written.adc is None and written.multiplier is None:
        for key in ("warn_above", "warn_every"):
            if getattr(written, key) is not None:
                around.bad(key, f"{around.name} has no adc, so {key} says nothing")
        return None
    if written.adc is None or written.multiplier is None:
        given = "adc" if written.adc else "multiplier"
        around.bad(given, f"{around.name} needs both adc and multiplier, or neither")
        return None
    channel = around.channels.get(written.adc)
    if channel is None and f"adc.{written.adc}" not in around.whole.board.places:
        hint = did_you_mean(written.adc, around.channels)
        around.bad("adc", f"board.yaml has no ADC channel {written.adc}", UNKNOWN_ADC, hint)
    multiplier = around.parameter("multiplier", written.multiplier)
    factor = ratio(unit_named("V"), stored)
    if factor is None:
        around.bad("adc", f"an ADC measures a voltage, {around.name} is a {stored.kind}", UNIT_MISMATCH)
    if channel is None or multiplier is None or factor is None:
        return None  # without them there is no conversion; whatever is wrong with them was reported
    if multiplier.unit is not NUMBER or multiplier.minimum < 0:
        around.bad("multiplier", f"{multiplier.name} is not a pure number that is never negative", UNIT_MISMATCH)
    exact = channel.reference / channel.full_scale * multiplier.step * factor
    return Conversion(channel, multiplier, exact.numerator, exact.denominator)


def _threshold(written: MeasuredSpec, kept: Kept, around: Surroundings) -> Threshold | None:
    """The value above which a warning is logged, by instance; None where none is written, or after a finding."""
    every_ms = around.time_ms("warn_every", written.warn_every)
    if written.warn_above is None:
        return None
    limits = [written.warn_above * kept.steps] * len(around.parts)
    if around.spec.per_cell:
        counts = around.counted("cells", "per_cell", BAD_FOLLOWING) or ()
        limits = [Fraction(round(limit * count)) for limit, count in zip(limits, counts, strict=False)]
    return Threshold(tuple(around.in_steps("warn_above", limit, Fraction(1)) for limit in limits), every_ms)
