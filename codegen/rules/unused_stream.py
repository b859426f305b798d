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
        is_shared = not system.spec.is_own(stream.spec.place.file)  # others may use what a program does not
        if stream.name not in used and not is_shared:
            hint = f"write stream: {stream.name} in a table of messages/, or leave the stream out"
            yield Diagnostic(stream.spec.place, RULE, f"no message belongs to the stream {stream.name}", hint)
