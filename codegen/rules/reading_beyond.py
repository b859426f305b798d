"""Rule for readings beyond the limits of messages: they go out as they are, and no setter would report a limit."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.quantities.attainable import measured_ends
from codegen.model.quantities.reach import Reach, reaches
from codegen.model.system import System
from codegen.model.vehicle import Component, Quantity

RULE = Rule(
    "reading-beyond-limits",
    "What an ADC measures, its trend or the charge that is estimated of it can lie beyond the limits of the quantity, "
    "or of a field that carries it, while the parameter of the conversion is at its largest. Nobody sets it, so it "
    "would be limited without a word. Widen the limits, narrow those of the parameter, or give the field a 'min' or "
    "'max' of its own in its table: that says that it is limited on purpose.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every quantity that readings give, against the limits within which all messages carry it."""
    told = reaches(system)
    for reading in system.readings():
        component = reading.component
        ends = measured_ends(component, reading.conversion, system)
        for one in reading.given:
            given = ends if one is reading.quantity else _derived(one, component, ends[1] - ends[0])
            low, high = told[one.path]
            if given is not None and not low <= given[0] <= given[1] <= high:
                yield _found(one, given, (low, high))


def _derived(quantity: Quantity, component: Component, most: int | Fraction) -> Reach | None:
    """Return the ends of a trend or an estimate; None for quantities that readings do not give."""
    readings = quantity.derivation.kept_readings
    if readings and component.period_ms:
        rate = Fraction(most) * 1000 / (readings // 2 * component.period_ms)
        return -rate, rate
    percents = [percent for curve in quantity.derivation.curves_by_instance for _, percent in curve]
    return (min(percents), max(percents)) if percents else None


def _found(quantity: Quantity, given: Reach, limits: Reach) -> Diagnostic:
    unit = quantity.stored.name
    return Diagnostic(
        quantity.spec.at("max"),
        RULE,
        f"{quantity.path} is {float(given[0]):g} to {float(given[1]):g} {unit}".rstrip(),
        f"its limits, and those of the fields that carry it, leave {float(limits[0]):g} to {float(limits[1]):g}",
    )
