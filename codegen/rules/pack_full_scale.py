"""Packs whose voltage is more than their ADC input can show."""

import math
from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.conversion import Conversion, Factor, factors_by_instance
from codegen.model.system import System
from codegen.model.unit import decimal, read_measure, unit_named
from codegen.model.vehicle import Instance, Parameter, Quantity
from codegen.source import Place

RULE = Rule(
    "pack-beyond-adc",
    "A full pack has more volts than the ADC shows at full scale with the default multiplier of this instance: the "
    "reading stops there, and a failsafe threshold above it is never passed, so that the vehicle cannot be armed. The "
    "full voltage is the number of cells times the fact charging_maximum_voltage, or times the top of the discharge "
    "curve, whichever is higher. Build the divider for it and give its multiplier as the default.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every instance of what is measured; those with one cause are one finding."""
    for name, quantity, conversion in system.measured():
        component = system.components[name]
        if quantity.unit.kind != "voltage" or conversion.offset is not None:
            continue
        multipliers = factors_by_instance(conversion.multiplier, system.parameters, component.instances)
        beyond: dict[tuple[Place, Fraction, int], list[int]] = {}
        for part, multiplier in zip(component.parts, multipliers, strict=True):
            full = full_voltage(system, part)
            if full is not None and full > largest(conversion, multiplier, quantity):
                place = system.spec.board.fact_place(name, part.number, "cells")
                beyond.setdefault((place, full, multiplier.default), []).append(part.number)
        for (place, full, _), numbers in beyond.items():
            multiplier = multipliers[numbers[0]]
            if not isinstance(multiplier, Parameter):
                message = f"{name} has {decimal(full)} V when full, and the ADC shows less"
                yield Diagnostic(place, RULE, message, f"a divider, and a multiplier greater than {multiplier.name}")
                continue
            shown = largest(conversion, multiplier, quantity)
            listed = " and ".join(str(number + 1) for number in numbers)
            who = f"{name} {listed}" if component.instances > 1 else name
            holds = "have" if len(numbers) > 1 else "has"
            message = f"{who} {holds} {decimal(full)} V when full, and the ADC shows {decimal(shown)} V at most"
            related = (multiplier.spec.at("default"), f"with this default of {multiplier.name}")
            yield Diagnostic(place, RULE, message, _hint(full, conversion, multiplier, quantity, numbers), (related,))


def full_voltage(system: System, part: Instance) -> Fraction | None:
    """What a full pack has, in V; None where nothing tells it."""
    cells = part.facts.get("cells")
    if not isinstance(cells, Fraction):
        return None
    tops = list(system.spec.board.discharge_curves.get(str(part.facts.get("chemistry")), {}))
    measures = [read_measure(text) for text in (*tops, str(part.facts.get("charging_maximum_voltage", "")))]
    volts = [measure.in_unit(unit_named("V")) for measure in measures if measure]
    known = [each for each in volts if each is not None]
    return max(known) * cells if known else None


def largest(conversion: Conversion, multiplier: Factor, quantity: Quantity) -> Fraction:
    """What the ADC shows at full scale with the default of a multiplier, in V."""
    product = conversion.channel.full_scale * multiplier.default * conversion.numerator
    return Fraction(product // conversion.denominator) / quantity.steps


def least_multiplier(volts: Fraction, conversion: Conversion, multiplier: Parameter, quantity: Quantity) -> Fraction:
    """The smallest multiplier with which the ADC shows so many volts."""
    per_step = Fraction(conversion.channel.full_scale * conversion.numerator, conversion.denominator)
    return math.ceil(math.ceil(volts * quantity.steps) / per_step) * multiplier.step


def _hint(full: Fraction, conversion: Conversion, multiplier: Parameter, quantity: Quantity, numbers: list[int]) -> str:
    least = least_multiplier(full, conversion, multiplier, quantity)
    hint = f"a divider and {multiplier.name} of at least {decimal(least)}"
    threshold = quantity.derivation.threshold
    if threshold is not None:
        above = Fraction(threshold.above[numbers[0]] + 1) / quantity.steps
        better = least_multiplier(above, conversion, multiplier, quantity)
        if better > least:
            hint += f", {decimal(better)} for the warning above {decimal(above - 1 / quantity.steps)} V"
            least = better
    most = multiplier.maximum * multiplier.step
    return hint if least <= most else f"{hint}; its max in parameters.yaml is {decimal(most)}, raise it, too"
