"""Constants, and limits of what fills a field, beyond the range that the dialect's words state for it."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.answers.live_numbers import live_numbers
from codegen.model.answers.scaling import Scaling
from codegen.model.dialect.stated_range import StatedRange, stated_range
from codegen.model.quantities.declared_ends import declared_ends, in_own_unit
from codegen.model.system import System
from codegen.model.units.unit import shortly
from codegen.model.vehicle import Parameter, Quantity

RULE = Rule(
    "beyond-stated-range",
    "The words of a field state a range for its values, such as -pi to pi, and what fills it goes beyond: the limits "
    "of a quantity, its own or those of its sensor, those of a parameter, a constant or a fact. Receivers get numbers "
    "that they do not expect. Narrow it, or fill the field with what is counted as the field is, from -180 to 180 "
    "degrees. With a min or a max in the table the field is limited there, on purpose.",
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
            yield from _stated(message.wire.name, answer, stated)
            for source, scaling in live_numbers(answer):
                yield from _beyond(message.wire.name, answer, source, scaling, stated)


def _stated(message: str, answer: Answer, stated: StatedRange) -> Iterator[Diagnostic]:
    """Yield the finding about a constant or a fact, if there is one."""
    covers, near = answer.covers, _nearness(answer, stated)
    for value in dict.fromkeys(answer.constants):
        if isinstance(value, str) or stated.low - near <= value <= stated.high + near:
            continue
        yield Diagnostic(
            covers.written.place,
            RULE,
            f"{covers.label} is {value:.6g} {covers.field.unit_text}".rstrip()
            + f", and the words of {message}.{covers.label} say {stated.words!r}",
            f"write one from {float(stated.low):.6g} to {float(stated.high):.6g}",
            ((covers.field.definition.place, "the dialect says so here"),),
        )


def _nearness(answer: Answer, stated: StatedRange) -> Fraction:
    return Fraction(0) if answer.covers.field.type.is_integer else (stated.high - stated.low) * _NEAR


def _beyond(
    message: str, answer: Answer, source: Quantity | Parameter, scaling: Scaling, stated: StatedRange
) -> Iterator[Diagnostic]:
    """Yield the finding about one quantity or parameter, if there is one."""
    covers, written = answer.covers, answer.covers.written
    near = _nearness(answer, stated)
    low, high = declared_ends(source)
    beyond: list[str] = []
    if low is not None and written.min is None and max(low * scaling.factor, scaling.low) < stated.low - near:
        beyond.append(f"down to {shortly(in_own_unit(source, low))}")
    if high is not None and written.max is None and min(high * scaling.factor, scaling.high) > stated.high + near:
        beyond.append(f"up to {shortly(in_own_unit(source, high))}")
    if not beyond:
        return
    unit = source.unit.name
    kind = "a parameter" if isinstance(source, Parameter) else "a quantity"
    ends = [in_own_unit(source, end / scaling.factor) for end in (stated.low, stated.high)]
    allowed = " to ".join(f"{float(end):.6g}" for end in ends)
    yield Diagnostic(
        written.at("parameter" if isinstance(source, Parameter) else "state"),
        RULE,
        f"{source.path} goes {' and '.join(beyond)} {unit}".rstrip()
        + f", and the words of {message}.{covers.label} say {stated.words!r}",
        f"fill it with {kind} from {allowed} {unit}".rstrip()
        + "; with min and max written here it is limited to these, and what is beyond goes out as the end",
        ((covers.field.definition.place, "the dialect says so here"),),
    )
