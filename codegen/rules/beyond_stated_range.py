"""Quantities whose limits go beyond the range that the dialect's words state for a field that carries them."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.answers.scaling import Scaling
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.dialect.stated_range import StatedRange, stated_range
from codegen.model.system import System
from codegen.model.units.unit import shortly
from codegen.model.vehicle import Quantity, QuantityKind

RULE = Rule(
    "beyond-stated-range",
    "The words of a field state a range for its values, such as -pi to pi, and the limits of the quantity that fills "
    "it, its own or those of its sensor, go beyond: receivers get numbers that they do not expect. Narrow the "
    "quantity, or fill the field with one that is counted as the field is, from -180 to 180 degrees. With a min or a "
    "max in the table the field is limited there, on purpose.",
    Severity.WARNING,
)
_NEAR = Fraction(1, 1000)
"""The part of a range by which a float may be beyond it: limits such as 3.1416 are rounded."""


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each field and quantity of which one end, or both, are beyond the words."""
    for message in system.messages:
        for answer in message.answers:
            stated = stated_range(answer.covers.field)
            if stated is None:
                continue
            for quantity, scaling in zip(answer.carried, answer.scalings, strict=False):
                if quantity.kind is QuantityKind.NUMBER:
                    yield from _beyond(message.wire.name, answer, quantity, scaling, stated)


def _beyond(
    message: str, answer: Answer, quantity: Quantity, scaling: Scaling, stated: StatedRange
) -> Iterator[Diagnostic]:
    """Yield the finding about one quantity, if there is one."""
    covers, written = answer.covers, answer.covers.written
    near = Fraction(0) if covers.field.type.is_integer else (stated.high - stated.low) * _NEAR
    low, high = _declared(quantity)
    beyond: list[str] = []
    if low is not None and written.min is None and max(low * scaling.factor, scaling.low) < stated.low - near:
        beyond.append(f"down to {shortly(low / quantity.steps)}")
    if high is not None and written.max is None and min(high * scaling.factor, scaling.high) > stated.high + near:
        beyond.append(f"up to {shortly(high / quantity.steps)}")
    if not beyond:
        return
    unit = quantity.unit.name
    ends = [end / (scaling.factor * quantity.steps) for end in (stated.low, stated.high)]
    allowed = " to ".join(f"{float(end):.6g}" for end in ends)
    yield Diagnostic(
        written.at("state"),
        RULE,
        f"{quantity.path} goes {' and '.join(beyond)} {unit}".rstrip()
        + f", and the words of {message}.{covers.label} say {stated.words!r}",
        f"fill it with a quantity from {allowed} {unit}".rstrip()
        + "; with min and max written here it is limited to these, and what is beyond goes out as the end",
        ((covers.field.definition.place, "the dialect says so here"),),
    )


def _declared(quantity: Quantity) -> tuple[Fraction | None, Fraction | None]:
    """Return the smallest and the largest stored value, each None where neither the table nor a sensor says it."""
    low = None if quantity.spec.min is None else Fraction(quantity.minimum)
    high = None if quantity.spec.max is None else Fraction(quantity.maximum)
    for _, output, factor in quantity.derivation.gives:
        if low is None and output.low > -SMALL_INT_MAX:
            low = output.low * factor
        if high is None and output.high < SMALL_INT_MAX:
            high = output.high * factor
    return low, high
