"""Two generations of messages that are both sent by default."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.price import price
from codegen.model.spec.spec import Generation
from codegen.model.system import System

RULE = Rule(
    "both-generations",
    "Both generations of messages are sent by default, so that a link carries everything twice. That is for the time "
    "in which receivers move from one to the other: make one of them the default, and both a choice of the operator.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every pair of generations."""
    for generations in system.generations:
        if generations.default is not Generation.BOTH:
            continue
        old, new, both = (price(generations, choice, system) for choice in Generation)
        parameter = generations.parameter
        place = generations.spec.at("send") if parameter is None else parameter.spec.at("default")
        related = [] if parameter is None else [(generations.spec.at("parameter"), "it chooses here")]
        yield Diagnostic(
            place,
            RULE,
            f"both generations of {generations.component.name} cost {both} bytes/s: {old} the old, {new} the new one",
            "let receivers that need the old one ask for it, and send the new one alone",
            related=tuple(related),
        )
