"""Live values that no integer arithmetic of the firmware brings into a float: MicroPython would allocate for one."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.answers.scaling import DIVISOR_MAX, NUMERATOR_MAX, float_parts
from codegen.model.system import System

SMALLEST = 126
"""A float of 32 bits that is smaller than 2 to the power of minus this has fewer digits."""
RULE = Rule(
    "beyond-float",
    "A float field takes a whole number times a factor, rounded once to the nearest float by whole numbers of several "
    "words, for which nothing is allocated. Without its powers of 2 the numerator of the factor has to be at most "
    f"{NUMERATOR_MAX}, the denominator at most {DIVISOR_MAX}, and one step in a float of 32 bits at least 2 ** "
    f"-{SMALLEST}. Keep the quantity in a unit that is closer to that of the field.",
    remedy="keep the quantity in a unit that is closer to that of the field",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every scaling into a float field."""
    for message in system.messages:
        for answer in message.answers:
            covers = answer.covers
            for scaling in () if covers.field.type.is_integer else answer.scalings:
                parts, factor = float_parts(scaling.factor), scaling.factor
                is_small = covers.field.type.size == 4 and factor * 2**SMALLEST < 1
                if parts.numerator <= NUMERATOR_MAX and parts.divisor <= DIVISOR_MAX and not is_small:
                    continue
                yield Diagnostic(
                    covers.written.place,
                    RULE,
                    f"{message.name}.{covers.label} is a {covers.field.type.name}, and one step is {factor} of it",
                    f"keep it in {covers.field.unit_text}" if covers.field.unit_text else None,
                    ((covers.field.definition.place, "it is declared here"),),
                )
