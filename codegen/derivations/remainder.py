"""The derivations of a remainder: the rest of a full store after a sum is drawn, and how long that rest lasts."""

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.derivations.integral import is_sensed
from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.quantities.summed import Lasting, Rest, whole
from codegen.model.spec.derivation import IntegralSpec, LastsSpec, LeftSpec, MeasuredSpec
from codegen.model.units.unit import Unit, decimal, ratio, unit_named
from codegen.model.vehicle import Parameter, Quantity

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_REMAINDER = Rule(
    "bad-remainder",
    "left_of names the parameter of a full store and after an integral of the same component: what is left is in the "
    "unit of the integral, or a share of the store in %. lasts names what is left so, at the measured quantity that is "
    "taken from it, and over a time of 1 to 1000 readings. Units fit by whole numbers, and products fit 30 bits.",
    remedy="write left_of, a parameter, and after, an integral; or lasts, at and over",
)


@dataclass(frozen=True, slots=True)
class Left(Derivation):
    """The remainder ``rest``, renewed with each reading of ``of``; unknown while that is, or the store has no size."""

    rest: Rest
    of: str
    is_sensed: bool

    @property
    def remains(self) -> Rest | None:
        return self.rest

    @property
    def ages_with(self) -> str | None:
        return self.of if self.is_sensed else None

    @property
    def comes_of_readings(self) -> bool:
        return True

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.of, self.rest.after)

    def uses(self, quantity: Quantity) -> Iterator[tuple[Parameter, str]]:
        yield self.rest.full, f"what {quantity.path} is counted from"

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        rest = self.rest
        share = "" if rest.share is None else f", of {rest.share}"
        text = (
            f"{rest.full.name} * {rest.steps} after {rest.after} of {_basis(self.of, is_sensed=self.is_sensed)}{share}"
        )
        yield DerivationFact("left of", text, "left_of")

    def words(self, quantity: Quantity) -> str:
        return f"{self.rest.full.name} less {quantity.component}.{self.rest.after}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        share = " as a share" if self.rest.share is not None else ""
        yield "follows", f"what {self.rest.after} leaves of {self.rest.full.name}{share}, unknown while {self.of} is"


@dataclass(frozen=True, slots=True)
class Lasts(Derivation):
    """The remaining time ``lasting``, renewed with each reading of the drawn quantity; unknown while none is drawn."""

    lasting: Lasting
    is_sensed: bool

    @property
    def lasts(self) -> Lasting | None:
        return self.lasting

    @property
    def ages_with(self) -> str | None:
        return self.lasting.at if self.is_sensed else None

    @property
    def comes_of_readings(self) -> bool:
        return True

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.lasting.at, self.lasting.left)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        lasting = self.lasting
        at = _basis(lasting.at, is_sensed=self.is_sensed)
        text = f"{lasting.left} * {lasting.factor} at {at} over {lasting.readings} readings"
        yield DerivationFact("lasts", text, "lasts")

    def words(self, quantity: Quantity) -> str:
        owner, lasting = quantity.component, self.lasting
        return f"{owner}.{lasting.left} at the mean of {owner}.{lasting.at} over {lasting.readings} readings"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        lasting = self.lasting
        yield "follows", f"{lasting.left} at {lasting.at}, smoothed over {lasting.readings} readings; else unknown"


def resolve_left(written: LeftSpec, kept: Kept, around: Surroundings) -> Left | None:
    """Return what is left of which parameter; None after a finding."""
    name = written.after
    if written.left_of is None or name is None:
        around.bad(
            "left_of" if name is None else "after",
            "what is left has both left_of and after",
            BAD_REMAINDER,
            hint="left_of: the parameter of a full store, and after: an integral",
        )
        return None
    full = around.parameter("left_of", written.left_of)
    integral = _integral(name, around)
    if full is None or integral is None:
        return None
    spelt = around.others[name].stored or around.others[name].unit
    unit = Unit.parse(spelt)
    if unit is not None and ratio(full.unit, unit) is None:
        kinds = f"{full.name} is {full.unit.a_kind}, and {name} is {unit.a_kind}"
        around.bad("left_of", kinds, BAD_REMAINDER, hint=f"name a parameter in {spelt}")
        return None
    steps = None if unit is None else whole((ratio(full.unit, unit) or Fraction(0)) * full.step)
    if steps is None or unit is None or full.minimum < 0:
        message = f"a step of {full.name} is no whole number of {spelt}, or it can be below 0"
        around.bad("left_of", message, BAD_REMAINDER, hint=f"give {full.name} min: 0 and a step of whole {spelt}")
        return None
    share = ratio(unit_named("%"), kept.stored)
    if share is None and ratio(unit, kept.stored) != 1:
        around.bad(
            "left_of", f"what is left of {full.name} is in {spelt} or in %", BAD_REMAINDER, hint=f"unit: {spelt}, or %"
        )
        return None
    of_all = None if share is None else int(100 * share)
    of = integral.integral_of or ""
    sensed = of in around.others and is_sensed(of, around)
    if sensed and not full.spec.reboot:
        message = f"{full.name} can change at any time, and with what a sensor gives it counts from the start on"
        around.bad("left_of", message, BAD_REMAINDER, f"reboot: true at {full.name}")
        return None
    return Left(Rest(full, name, steps, of_all), of, sensed)


def resolve_lasts(written: LastsSpec, kept: Kept, around: Surroundings) -> Lasts | None:
    """Return what lasts, and at what; None after a finding."""
    name, at = written.lasts, written.drawn
    if name is None or at is None or written.over is None:
        given = {"lasts": name, "at": at, "over": written.over}
        key = next(key for key, value in given.items() if value is not None)
        around.bad(
            key,
            "a time that is left has lasts, at and over",
            BAD_REMAINDER,
            hint="lasts: what is left, at: what is measured, and over: 10 s",
        )
        return None
    over = around.time_ms("over", written.over)
    for key, other in (("lasts", name), ("at", at)):
        if other not in around.others:
            around.no_quantity(key, other, BAD_REMAINDER)
            return None
    left, drawn = around.others[name], around.others[at]
    sensed = is_sensed(at, around)
    if left.written(LeftSpec) is None or (drawn.written(MeasuredSpec) is None and not sensed):
        around.bad(
            "lasts",
            f"{name} is not what is left of something, or {at} is not measured",
            BAD_REMAINDER,
            hint=f"write left_of and after at {name}, and adc or source at {at}",
        )
        return None
    if sensed and not around.given_to(at):
        return None  # what is wrong with the sensor, or with its name, has been reported
    period_ms = _period_ms(at, around)
    readings = (over or 0) / period_ms if period_ms else Fraction(0)
    if readings.denominator != 1 or not 1 <= readings <= 1000:
        hint = "the component needs an update_rate, or its sensors one rate"
        if period_ms:
            hint = f"readings are {decimal(period_ms)} ms apart: write a multiple of that"
        around.bad("over", f"{written.over} is not 1 to 1000 readings", BAD_REMAINDER, hint)
        return None
    of = around.unit_of(at)
    product = None if of is None else kept.stored.times(of)
    unit = Unit.parse(left.stored or left.unit)
    factor = None if product is None or unit is None else whole(ratio(unit, product))
    if factor is None:
        around.bad(
            "lasts",
            f"{name} at {at} is no whole number of {kept.stored.name}",
            BAD_REMAINDER,
            hint="keep the time in a finer unit, or both others in coarser ones: stored",
        )
        return None
    return Lasts(Lasting(name, at, int(readings), factor), sensed)


def _basis(name: str, *, is_sensed: bool) -> str:
    """Return the words for the readings that a time is counted in: of a quantity, or of the sensor that measures it."""
    return f"{name} of a sensor" if is_sensed else name


def _period_ms(name: str, around: Surroundings) -> Fraction | None:
    """The time between two values of what is measured, in ms; None where there is not one for all instances."""
    periods = {Fraction(source.polling.period_us, 1000) for source, _ in around.given_to(name)}
    if not periods:
        return None if around.period_ms is None else Fraction(around.period_ms)
    return periods.pop() if len(periods) == 1 else None


def _integral(name: str, around: Surroundings) -> IntegralSpec | None:
    followed = around.others.get(name)
    if followed is None:
        around.no_quantity("after", name, BAD_REMAINDER)
        return None
    written = followed.written(IntegralSpec)
    if written is None or written.times is not None:
        around.bad("after", f"{name} is no integral of one quantity", BAD_REMAINDER, f"integral_of at {name}")
        return None
    return written
