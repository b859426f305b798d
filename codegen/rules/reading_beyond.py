"""What comes of readings goes out as it is: nobody sets it, so that nobody would be told of a limit."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.population_spec import Rounding
from codegen.model.reach import Reach, reaches
from codegen.model.scaling import rounded
from codegen.model.system import System
from codegen.model.vehicle import Component, Conversion, Quantity, by_instance

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
    for name, quantity, conversion in system.measured():
        component = system.components[name]
        most = _largest(component, conversion, system)
        for one in component.quantities.values():
            given = (Fraction(0), most) if one is quantity else _derived(one, component, most)
            low, high = told[one.path]
            if given is not None and not low <= given[0] <= given[1] <= high:
                yield _found(one, given, (low, high))


def _largest(component: Component, conversion: Conversion, system: System) -> Fraction:
    """In stored units: the highest count with the largest multiplier of all instances."""
    multipliers = by_instance(conversion.multiplier, system.parameters, component.instances)
    steps = conversion.channel.full_scale * max(multiplier.maximum for multiplier in multipliers)
    return Fraction(rounded(Fraction(steps * conversion.numerator, conversion.denominator), Rounding.NEAREST))


def _derived(quantity: Quantity, component: Component, most: Fraction) -> Reach | None:
    """Between what a trend or an estimate can be; None for what readings do not give."""
    readings = quantity.derivation.kept_readings
    if readings and component.period_ms:
        rate = most * 1000 / (readings // 2 * component.period_ms)
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
