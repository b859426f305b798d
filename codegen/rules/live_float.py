"""Float fields that are written at each build: MicroPython keeps floats on the heap."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import System

RULE = Rule(
    "allocating-field",
    "A float field takes a live value. The value is right, but each build of the message allocates memory for it, so "
    "the message is no part of the steady telemetry cycle that allocates nothing.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every live float field."""
    for message in system.messages:
        for binding in message.live_floats:
            covers = binding.covers
            yield Diagnostic(
                covers.answer.place,
                RULE,
                f"{message.name}.{covers.label} is a float and allocates at each build",
                related=((covers.field.definition.place, "it is declared here"),),
            )
