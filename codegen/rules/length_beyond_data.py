"""Numbers of bytes that are more than the array of the message holds."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.answers.live_numbers import live_numbers
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.stated_length import stated_lengths
from codegen.model.quantities.declared_ends import declared_ends
from codegen.model.system import System
from codegen.model.units.unit import shortly

RULE = Rule(
    "length-beyond-data",
    "A field says how many bytes of an array of its message are used, and a constant, a fact, a parameter or the "
    "limits of a quantity make it more than the array holds: a receiver that believes it reads on into what follows. "
    "Narrow it; with a max in the table the field ends there.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each such field."""
    for message in system.messages:
        lengths = stated_lengths(message.wire.fields)
        for answer in message.answers:
            data = lengths.get(answer.covers.field.name)
            told = _most(answer, data.count) if data is not None else None
            if data is not None and told is not None:
                covers = answer.covers
                yield Diagnostic(
                    covers.written.place,
                    RULE,
                    f"{told}, and {message.wire.name}.{data.name} has {data.count}",
                    f"{_end(data, answer)} at most: in the source, or as max here",
                    (
                        (covers.field.definition.place, f"{covers.field.name} is declared here"),
                        (data.definition.place, f"{data.name} is declared here"),
                    ),
                )


def _end(data: WireField, answer: Answer) -> str:
    return f"{data.count} {answer.covers.field.unit_text}".rstrip()


def _most(answer: Answer, room: int) -> str | None:
    """Return the words for what is more than ``room``; None where nothing is."""
    name, written = answer.covers.label, answer.covers.written
    for value in answer.constants:
        if not isinstance(value, str) and value > room:
            return f"{name} is {value}"
    for source, scaling in live_numbers(answer):
        _, high = declared_ends(source)
        most = None if high is None else min(high * scaling.factor, scaling.high)
        if most is not None and most > room and written.max is None:
            return f"{source.path} makes {name} up to {shortly(Fraction(most))}"
    return None
