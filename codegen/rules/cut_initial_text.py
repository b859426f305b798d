"""Initial texts that are longer than a field that carries them."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.code.letters import cut
from codegen.model.system import System

RULE = Rule(
    "cut-initial-text",
    "The initial text of a quantity is longer than a field that carries it: its end is cut off in every message until "
    "another text is set, which is known now. A constant or a fact of that length is an error.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each field that has no room for one."""
    for message in system.messages:
        for answer in message.answers:
            for quantity in answer.carried:
                text, room = quantity.initial, answer.covers.count
                if not isinstance(text, str) or len(text.encode()) <= room:
                    continue
                yield Diagnostic(
                    answer.covers.written.place,
                    RULE,
                    f"{quantity.path} is initially {text!r}, {len(text.encode())} bytes, and "
                    f"{message.wire.name}.{answer.covers.label} has room for {room}",
                    f"initial: {cut(text, room)!r} would fit",
                    ((quantity.spec.at("initial"), "it is declared here"),),
                )
