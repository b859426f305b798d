"""Streams that can be asked for more often than links are served."""

import math
from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System

RULE = Rule(
    "stream-beyond-links",
    "A stream may be asked for at a higher rate than vehicle.yaml serves links at, so that it would fall behind. Raise "
    "links, or lower the maximum of the stream's parameter, or fastest.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every stream of a project that has a program."""
    if system.program is None:
        return
    served = Fraction(1000000, system.program.links_us)
    for stream in system.streams.values():
        if stream.fastest > served:
            yield Diagnostic(
                stream.spec.place,
                RULE,
                f"{stream.name} goes up to {stream.fastest} Hz, above the rate that links are served at",
                f"links: {math.ceil(stream.fastest)} Hz under control in vehicle.yaml, or a slower stream",
                related=((system.program.spec.control.at("links"), "the rate of links is stated here"),),
            )
