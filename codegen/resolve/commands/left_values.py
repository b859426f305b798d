"""Numbers of a parameter with which nothing is to change, so that the method is given None."""

import math
from fractions import Fraction

from codegen.diagnostics import Report
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.model.spec.command import CommandParamSpec
from codegen.model.units.unit import decimal
from codegen.resolve.dialect.sentinel import Problem, number_on_wire
from codegen.resolve.dialect.special_numbers import SPECIAL_VALUE


def left_values(label: str, spec: CommandParamSpec, report: Report) -> tuple[tuple[Fraction, ...], bool]:
    """Return the numbers, as the floats of 32 bits that COMMAND_LONG has for them, and whether NaN is among them."""
    found: list[Fraction] = []
    is_nan_left = False
    for written in spec.unchanged or ():
        text = written if isinstance(written, str) else decimal(written)
        number = number_on_wire(text, WIRE_TYPES["float"], None)
        if isinstance(number, Problem):
            report.add(SPECIAL_VALUE, spec.at("unchanged"), f"{label}: {number.message}", number.hint)
        elif math.isnan(number):
            is_nan_left = True
        elif Fraction(number) not in found:
            found.append(Fraction(number))
    if is_nan_left and isinstance(spec.default, Fraction):
        message = f"{label}: NaN has a default, and is listed as what leaves things as they are"
        report.add(SPECIAL_VALUE, spec.at("unchanged"), message, "leave out one of both")
    return tuple(found), is_nan_left
