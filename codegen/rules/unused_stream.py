"""Streams that send nothing."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import System

RULE = Rule(
    "unused-stream",
    "No message belongs to a stream, so its rate, and the parameter that sets it, have no effect.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every stream."""
    used = {message.population.stream for message in system.messages}
    for stream in system.streams.values():
        if stream.name not in used:
            yield Diagnostic(stream.spec.place, RULE, f"no message belongs to the stream {stream.name}")
