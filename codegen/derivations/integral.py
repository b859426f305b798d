"""The derivation that integrates measured quantities over time: the charge of a current, the energy of a power."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.answers.step import Step
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.quantities.summed import RADIX, Sum, whole
from codegen.model.spec.derivation import IntegralSpec, MeasuredSpec, SourcedSpec
from codegen.model.units.unit import Unit, ratio, unit_named
from codegen.model.vehicle import Quantity

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_INTEGRAL = Rule(
    "bad-integral",
    "An integral sums what is measured in the same component over time, by an ADC or another sensor, or its product "
    "with another quantity that is measured there in the same way: one step of it is a whole number of steps and "
    "milliseconds, of a product a whole number of millions. What is summed has a stale_after, since a longer pause is "
    "a gap, and both together fit 30 bits.",
    remedy="write integral_of: and the name of what is measured in this component",
)


@dataclass(frozen=True, slots=True)
class Integral(Derivation):
    """Counted on with each reading of what ``sum`` is of."""

    sum: Sum
    anew_with: str | None

    @property
    def sums(self) -> Sum | None:
        return self.sum

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.sum.of,) if self.sum.times is None else (self.sum.of, self.sum.times)

    @property
    def restarts_with(self) -> str | None:
        return self.anew_with

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact("integral of", f"{' * '.join(self.sources)}, {self.sum.parts} parts", "integral_of")
        if self.anew_with is not None:
            yield DerivationFact("restarts with", self.anew_with, "restarts_with")

    def words(self, quantity: Quantity) -> str:
        text = f"sum of {' * '.join(f'{quantity.component}.{name}' for name in self.sources)} over time"
        return text if self.anew_with is None else f"{text}; anew with {quantity.component}.{self.anew_with}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"{' * '.join(self.sources)}, summed exactly: each reading for the time since the one before"
        yield "gaps", f"while {self.sum.of} is unknown nothing is counted"
        if self.anew_with is not None:
            yield "begins anew", f"when {self.anew_with} counts up"

    def way(self, quantity: Quantity, system: "System") -> Iterator[Step]:
        yield Step("sum", self.words(quantity), ("exact: what is less than a step is kept",), quantity.criteria())


def resolve_integral(written: IntegralSpec, kept: Kept, around: Surroundings) -> Integral | None:
    """Return what is summed; None after a finding."""
    if written.integral_of is None:
        around.bad(
            "times",
            "times says nothing without integral_of",
            BAD_INTEGRAL,
            hint="name what is summed: integral_of: NAME, or leave times out",
        )
        return None
    product, names = unit_named("ms"), [written.integral_of, *([written.times] if written.times else [])]
    for key, name in zip(("integral_of", "times"), names, strict=False):
        unit = measured_unit(key, name, around)
        if unit is None:
            return None
        product = unit.times(product)
    if len({is_sensed(name, around) for name in names}) > 1:
        message = f"an ADC measures one of {names[0]} and {names[1]}, and another sensor gives the other"
        around.bad("times", message, BAD_INTEGRAL, "both have to be measured in the same way")
        return None
    if around.others[names[0]].stale_after is None:
        message = f"{names[0]} has no stale_after, so nothing says which pause is a gap"
        around.bad("integral_of", message, BAD_INTEGRAL, f"write stale_after at {names[0]}")
    ways = ratio(kept.stored, product)
    parts = whole(ways)
    if ways is None:
        around.bad(
            "integral_of",
            f"{' * '.join(names)} over time makes no {kept.stored.kind}",
            BAD_INTEGRAL,
            hint="give the sum a unit that fits, such as mAh for A, and J for W",
        )
        return None
    most = 2**29 if written.times is None else RADIX * RADIX * 2**20
    if parts is None or parts >= most or (written.times is not None and parts % (RADIX * RADIX)):
        message = f"a step of {kept.stored.name} is {ways} steps of {product.name}, which is not counted exactly"
        around.bad("integral_of", message, BAD_INTEGRAL, "keep it in another unit by stored")
        return None
    return Integral(Sum(names[0], written.times, parts), around.spec.restarts_with)


def measured_unit(key: str, name: str, around: Surroundings) -> Unit | None:
    """The unit in which a measured quantity of the component is kept; None after a finding."""
    followed = around.others.get(name)
    if followed is None:
        around.no_quantity(key, name, BAD_INTEGRAL)
        return None
    if followed.written(MeasuredSpec) is None and not is_sensed(name, around):
        around.bad(
            key,
            f"{name} is not measured, by an ADC or another sensor",
            BAD_INTEGRAL,
            hint=f"write adc and multiplier, or source, at {name}",
        )
        return None
    return around.unit_of(name)


def is_sensed(name: str, around: Surroundings) -> bool:
    """Return whether a sensor other than an ADC gives a quantity of the component."""
    return around.others[name].written(SourcedSpec) is not None
