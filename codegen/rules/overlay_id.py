"""Messages of overlays and own dialects whose name or id another dialect has given away."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import System

RULE = Rule(
    "taken-elsewhere",
    "A file of the project, its dialect or an overlay, adds a message with an id, or a name, that another dialect uses "
    "for another message: one that pymavlink ships, or that codegen.yaml names under known. Receivers with that "
    "dialect drop it, or worse, take it for theirs. Choose a free id, in the XML or in a correction.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every message that a file of the project adds; the same name with the same id is the same message."""
    for message in system.dialect.added_messages():
        for other in system.dialect.known:
            if (other.name == message.name) == (other.id == message.id):
                continue
            taken = f"the id {message.id} of {other.name}" if other.id == message.id else f"the id {other.id} elsewhere"
            definition = message.definition
            yield Diagnostic(
                definition.id_place or definition.place,
                RULE,
                f"{message.name} has {taken}",
                "choose another id" if other.id == message.id else "choose another name, or that id",
                ((other.place, f"{other.name} is {other.id} here"),),
            )
