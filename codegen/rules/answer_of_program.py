"""A table of a message with which the program answers."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.program import SENT
from codegen.model.system import System

RULE = Rule(
    "answer-of-program",
    "The program sends this message itself, as an answer or a text. Streamed or on request it would say what nobody "
    "has asked: an acknowledgement of a command that was not given, a parameter that the list does not have.",
    Severity.ERROR,
    remedy="leave the table out",
)
_INSTEAD = {"STATUSTEXT": "code says texts with self.texts.say(severity, text); leave the table out"}


def check(system: System) -> Iterator[Diagnostic]:
    """Every table of such a message, where there is a program."""
    for message in system.messages if system.program else ():
        if message.wire.name in SENT:
            name = message.wire.name
            text = f"the program sends {name} itself"
            yield Diagnostic(message.population.place, RULE, text, _INSTEAD.get(name))
