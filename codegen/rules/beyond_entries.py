"""Numbers without an enum that fill a field with one, and can be what is none of its entries."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.answers.live_numbers import live_numbers
from codegen.model.answers.scaling import Scaling
from codegen.model.dialect.dialect import EnumDefinition
from codegen.model.dialect.free_values import is_left_free
from codegen.model.quantities.declared_ends import declared_ends, in_own_unit
from codegen.model.system import System
from codegen.model.units.unit import shortly
from codegen.model.vehicle import Parameter, Quantity

RULE = Rule(
    "beyond-entries",
    "A field with an enum is filled with a parameter or with a quantity that is a number, and its limits go beyond the "
    "entries of the enum: receivers get numbers that mean nothing to them. Narrow it, or give the quantity the enum.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each such field; bitmasks have bits, and no ends."""
    for message in system.messages:
        for answer in message.answers:
            enum = system.dialect.enums.get(answer.covers.field.definition.enum or "")
            if enum is None or enum.is_bitmask or answer.covers.field.definition.is_bitmask or not enum.entries:
                continue
            for source, scaling in live_numbers(answer):
                yield from _beyond(answer, source, scaling, enum)


def _beyond(
    answer: Answer, source: Quantity | Parameter, scaling: Scaling, enum: EnumDefinition
) -> Iterator[Diagnostic]:
    covers, written = answer.covers, answer.covers.written
    first, last = min(enum.entries, key=lambda each: each.value), max(enum.entries, key=lambda each: each.value)
    low, high = declared_ends(source)
    beyond: list[str] = []
    if low is not None and written.min is None and max(low * scaling.factor, scaling.low) < first.value:
        beyond.append(f"down to {shortly(in_own_unit(source, low))}, and {first.name} is {first.value}")
    end = None if high is None else min(high * scaling.factor, scaling.high)
    is_more = end is not None and last.value < end and not is_left_free(int(end), covers.field)
    if high is not None and is_more and written.max is None:
        beyond.append(f"up to {shortly(in_own_unit(source, high))}, and {last.name} is {last.value}")
    if not beyond:
        return
    ends = [shortly(in_own_unit(source, Fraction(each.value) / scaling.factor)) for each in (first, last)]
    hint = f"limits of {source.path} from {ends[0]} to {ends[1]}"
    hint += "" if isinstance(source, Parameter) else f", or enum: {enum.name} in place of them"
    yield Diagnostic(
        written.at("parameter" if isinstance(source, Parameter) else "state"),
        RULE,
        f"{covers.label} is a {enum.name}, and {source.path} goes {' and '.join(beyond)}",
        hint,
        ((enum.place, f"{enum.name} is declared here"),),
    )
