"""Quantities that reach more in use than their ADC input can show."""

import math
from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.quantities.conversion import Conversion, factors_by_instance
from codegen.model.quantities.full_scale import largest, most_in_use
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Instance, Parameter, Quantity
from codegen.source import Place

RULE = Rule(
    "reach-beyond-adc",
    "A quantity reaches more in use (reaches in state.yaml) than the ADC shows at full scale with the default "
    "multiplier of this instance: the reading stops there, and a failsafe threshold above it is never passed, so that "
    "the vehicle cannot be armed. Build the input for it, such as a divider, and give its multiplier as the default.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every instance of what is measured; those with one cause are one finding."""
    for name, quantity, conversion in system.measured():
        component = system.components[name]
        unit = f" {quantity.unit.name}".rstrip()
        if quantity.spec.reaches is None or conversion.offset is not None:
            continue
        multipliers = factors_by_instance(conversion.multiplier, system.parameters, component.instances)
        beyond: dict[tuple[Place, Fraction, int], list[int]] = {}
        for part, multiplier in zip(component.parts, multipliers, strict=True):
            full = most_in_use(quantity, part)
            if full is not None and full > largest(conversion, multiplier, quantity):
                place = _place(system, quantity, part)
                beyond.setdefault((place, full, multiplier.default), []).append(part.number)
        for (place, full, _), numbers in beyond.items():
            multiplier = multipliers[numbers[0]]
            if not isinstance(multiplier, Parameter):
                message = f"{name} reaches {decimal(full)}{unit}, and the ADC shows less"
                yield Diagnostic(place, RULE, message, f"an input with a multiplier greater than {multiplier.name}")
                continue
            shown = largest(conversion, multiplier, quantity)
            listed = " and ".join(str(number + 1) for number in numbers)
            who = f"{name} {listed}" if component.instances > 1 else name
            reach = "reach" if len(numbers) > 1 else "reaches"
            message = f"{who} {reach} {decimal(full)}{unit}, and the ADC shows {decimal(shown)}{unit} at most"
            related = (multiplier.spec.at("default"), f"with this default of {multiplier.name}")
            yield Diagnostic(place, RULE, message, _hint(full, conversion, multiplier, quantity, numbers), (related,))


def _place(system: System, quantity: Quantity, part: Instance) -> Place:
    """Return where it is said: at the count that multiplies it, at the fact, or at the quantity."""
    fact = quantity.spec.per or quantity.spec.reaches
    if fact is None or fact not in part.facts:
        return quantity.spec.at("reaches")
    return system.spec.board.fact_place(quantity.component, part.number, fact)


def least_multiplier(most: Fraction, conversion: Conversion, multiplier: Parameter, quantity: Quantity) -> Fraction:
    """The smallest multiplier with which the ADC shows so much."""
    per_step = Fraction(conversion.channel.full_scale * conversion.numerator, conversion.denominator)
    return math.ceil(math.ceil(most * quantity.steps) / per_step) * multiplier.step


def _hint(full: Fraction, conversion: Conversion, multiplier: Parameter, quantity: Quantity, numbers: list[int]) -> str:
    least = least_multiplier(full, conversion, multiplier, quantity)
    hint = f"an input and {multiplier.name} of at least {decimal(least)}"
    threshold = quantity.derivation.threshold
    if threshold is not None:
        above = Fraction(threshold.above[numbers[0]] + 1) / quantity.steps
        better = least_multiplier(above, conversion, multiplier, quantity)
        if better > least:
            limit = f"{decimal(above - 1 / quantity.steps)} {quantity.unit.name}".rstrip()
            hint += f", {decimal(better)} for the warning above {limit}"
            least = better
    most = multiplier.maximum * multiplier.step
    return hint if least <= most else f"{hint}; its max in parameters.yaml is {decimal(most)}, raise it, too"
