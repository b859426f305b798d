"""The change per second of a measured quantity."""

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings, told_origin
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.spec.derivation import MeasuredSpec, TrendSpec
from codegen.model.units.unit import Unit, ratio
from codegen.model.vehicle import Quantity

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_TREND = Rule(
    "bad-trend",
    "A trend is the change per second of a measured quantity of the same component, kept in the same unit per second. "
    "Its window is an even number of readings, 4 to 200.",
    remedy="write trend_of: and the name of what an ADC measures in this component",
)


@dataclass(frozen=True, slots=True)
class Trend(Derivation):
    """The change per second of ``quantity``, over ``readings`` of the component, an even number."""

    quantity: str
    readings: int
    spec: TrendSpec

    @property
    def kept_readings(self) -> int:
        return self.readings

    @property
    def comes_of_readings(self) -> bool:
        return True

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.quantity,)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact("trend of", f"{self.quantity} over {self.readings} readings", "trend_of")

    def words(self, quantity: Quantity) -> str:
        return f"change of {quantity.component}.{self.quantity} over {self.readings} readings"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"the change of {self.quantity} over {self.spec.window}, {self.readings} readings"


def resolve_trend(written: TrendSpec, kept: Kept, around: Surroundings) -> Trend | None:
    """The quantity and the number of readings; None after a finding."""
    if written.trend_of is None or written.window is None:
        around.bad(
            "window" if written.window else "trend_of",
            "a trend has both trend_of and window",
            BAD_TREND,
            hint="trend_of: a measured quantity, and window: 10 s",
        )
        return None
    name, followed = written.trend_of, around.others.get(written.trend_of)
    if followed is None:
        around.no_quantity("trend_of", name, BAD_TREND)
        return None
    if followed.written(MeasuredSpec) is None:
        message = f"{name} is {told_origin(followed)}, and a trend follows what the ADC of the component measures"
        around.bad("trend_of", message, BAD_TREND, f"write adc and multiplier at {name}, or set {around.name} by code")
        return None
    window = around.time_ms("window", written.window)
    if window is None:
        return None
    readings = Fraction(window, around.period_ms) if around.period_ms else Fraction(0)
    if readings.denominator != 1 or readings % 2 or not 4 <= readings <= 200:
        hint = "the component needs an update_rate"
        if around.period_ms:
            hint = (
                f"readings are {around.period_ms} ms apart: write an even number of them, as {10 * around.period_ms} ms"
            )
        around.bad("window", f"{written.window} is not an even number of readings, 4 to 200", BAD_TREND, hint)
        return None
    unit = followed.stored or followed.unit
    if not _is_rate_of(unit, kept.stored):
        message = f"the change of {name} is kept in {unit}/s, not {kept.stored.name}"
        around.bad("stored", message, BAD_TREND, hint=f"stored: {unit or 1}/s")
    return Trend(name, int(readings), written)


def _is_rate_of(unit: str | None, stored: Unit) -> bool:
    """Return whether a unit is another one per second, however it is spelled."""
    rate = Unit.parse(f"{unit or 1}/s")
    return rate is not None and ratio(rate, stored) == 1
