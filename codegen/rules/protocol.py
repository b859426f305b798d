"""Rule for messages that MAVLink 1 cannot carry."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System

RULE = Rule(
    "needs-mavlink-2",
    "The project sends MAVLink 1, which has message ids up to 255 only. Set protocol to 2, or leave the message out.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every populated message of a project that sends MAVLink 1."""
    if system.spec.project.protocol != 1:
        return
    for message in system.messages:
        if message.wire.id > 255:
            yield Diagnostic(
                message.population.at("message"),
                RULE,
                f"{message.name} has the id {message.wire.id}",
                "protocol: 2",
                related=((system.spec.project.at("protocol"), "the protocol is chosen here"),),
            )
