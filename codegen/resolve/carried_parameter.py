"""The values of a parameter that its protocol and the storage carry: both have floats of 32 bits.

As C casts PARAM_VALUE and PARAM_SET carry the number itself as a float, whatever type the parameter has, and so does a
record of the storage in each encoding.
"""

from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.model.code.storage import Storage
from codegen.model.dialect.literals import exact_number
from codegen.model.units.unit import decimal
from codegen.resolve.families import Member

_EXACT = 2**24
"""A float of 32 bits has every whole number up to this one."""

_TOLD_APART = 2**21 - 1
"""Steps up to this many are found again where their values are no floats exactly.

A board makes floats of a number of steps and divides it, multiplies what arrives and divides it again. Four times up
to one part in 2 ** 24 is less than half a step then.
"""

PARAMETER_BEYOND_FLOAT = Rule(
    "parameter-beyond-float",
    "A parameter can have values that a float of 32 bits does not carry. The storage carries nothing else, and neither "
    f"do PARAM_VALUE and PARAM_SET but for whole types sent bytewise: whole numbers up to {_EXACT}, or that many times "
    "the largest power of two in the step; of steps that are no binary fractions, such as 0.1, up to "
    f"{_TOLD_APART}. Narrow min and max, or choose a larger "
    "step.",
)


def check_carried(member: Member, report: Report) -> None:
    """Report the limits, or the single values, that a parameter would not keep; of a family once."""
    name, spec = member.name, member.spec
    if member.instance:
        return
    largest = most_steps(spec.step) * spec.step
    if spec.values:
        lost = [(f"values.{written}", exact_number(written) or Fraction(0)) for written in spec.values]
        lost = [(key, value) for key, value in lost if abs(value) > largest and not _is_float(value)]
    else:
        lost = [(key, value) for key, value in (("min", spec.min), ("max", spec.max)) if abs(value) > largest]
    for key, value in lost:
        what = f"{decimal(value)} of {name}" if spec.values else f"{key} of {name} is {decimal(value)}: that"
        end = decimal(-largest if value < 0 else largest)
        hint = f"choose values up to {end}" if spec.values else f"{key}: {end}, or a larger step"
        why = "is more than floats of 32 bits carry"
        if _is_float(value):  # the last one is there, and not the one before it
            why = f"is more steps of {decimal(spec.step)} than floats of 32 bits tell apart"
        message = f"{what} {why}, in which parameters are sent and stored"
        report.add(PARAMETER_BEYOND_FLOAT, member.at(key), message, hint)


def most_steps(step: Fraction) -> int:
    """Return up to how many steps each value comes back as it was; 0 where not even one does."""
    largest = Storage.BINARY32.limits[1]
    if max(step.numerator, step.denominator) > largest:
        return 0
    is_binary = step.denominator & (step.denominator - 1) == 0
    odd = step.numerator // (step.numerator & -step.numerator)
    return min(_EXACT // odd if is_binary else _TOLD_APART, int(largest / step))


def _is_float(value: Fraction) -> bool:
    return Storage.BINARY32.nearest(value) == value
