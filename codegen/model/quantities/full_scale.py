"""The largest value that an input of the converter can show, and the largest that it has to."""

from fractions import Fraction

from codegen.model.quantities.conversion import Conversion, Factor
from codegen.model.units.unit import read_measure
from codegen.model.vehicle import Instance, Quantity


def largest(conversion: Conversion, multiplier: Factor, quantity: Quantity) -> Fraction:
    """Return what the ADC shows at full scale with the default of a multiplier, in the unit of the quantity."""
    product = conversion.channel.full_scale * multiplier.default * conversion.numerator
    return Fraction(product // conversion.denominator) / quantity.steps


def most_in_use(quantity: Quantity, part: Instance) -> Fraction | None:
    """Return what a quantity of an instance reaches, in its unit; None where nothing tells it."""
    reaches = quantity.spec.reaches
    if reaches is None:
        return None
    measure = read_measure(reaches) or read_measure(str(part.facts.get(reaches)))
    most = measure.in_unit(quantity.unit) if measure else None
    count = part.count(quantity.spec.per) if quantity.spec.per else 1
    return None if most is None or count is None else most * count
