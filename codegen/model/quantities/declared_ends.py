"""The ends of a quantity or a parameter as far as somebody has declared them."""

from fractions import Fraction

from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.vehicle import Parameter, Quantity


def declared_ends(source: Quantity | Parameter) -> tuple[Fraction | None, Fraction | None]:
    """Return the smallest and the largest stored value, each None where neither the table nor a sensor says it."""
    low = None if source.spec.min is None else Fraction(source.minimum)
    high = None if source.spec.max is None else Fraction(source.maximum)
    if isinstance(source, Parameter):
        return low, high
    for _, output, factor in source.derivation.gives:
        if low is None and output.low > -SMALL_INT_MAX:
            low = output.low * factor
        if high is None and output.high < SMALL_INT_MAX:
            high = output.high * factor
    return low, high


def in_own_unit(source: Quantity | Parameter, stored: Fraction) -> Fraction:
    """Return a stored value in the unit of its source."""
    return stored * source.step if isinstance(source, Parameter) else stored / source.steps
