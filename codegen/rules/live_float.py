"""Values for which a float is made at each build: MicroPython keeps floats on the heap."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answer import Answer
from codegen.model.scaling import FLOAT_DIVISOR_MAX
from codegen.model.storage import SMALL_INT_MAX
from codegen.model.system import System

RULE = Rule(
    "allocating-field",
    "A float field takes a live value that integer arithmetic cannot bring into the form of the wire. What is sent is "
    "right, but each build of the message allocates memory for a float, so the message is no part of the steady "
    "telemetry cycle that allocates nothing. A float of 32 bits does without where the stored value, times the "
    f"numerator of its conversion, stays within {SMALL_INT_MAX} and the denominator is at most {FLOAT_DIVISOR_MAX}.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every value that only a float can carry to its field."""
    for message in system.messages:
        for answer in message.answers:
            if not answer.makes_float:
                continue
            covers = answer.covers
            yield Diagnostic(
                covers.written.place,
                RULE,
                f"{message.name}.{covers.label} is a {covers.field.type.name} and allocates at each build",
                _way_out(answer),
                ((covers.field.definition.place, "it is declared here"),),
            )


def _way_out(answer: Answer) -> str | None:
    """What would make it a value that integer arithmetic can send; None for a double, which always takes a float."""
    if answer.covers.field.type.size != 4:
        return None
    numerator, denominator = answer.scalings[0].factor.numerator, answer.scalings[0].factor.denominator
    if denominator > FLOAT_DIVISOR_MAX:
        return f"it is divided by {denominator}: keep it in a coarser unit"
    return f"limit it with min and max: times {numerator} it has to stay within {SMALL_INT_MAX}"
