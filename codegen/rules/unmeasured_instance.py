"""Instances that nothing measures."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import System

RULE = Rule(
    "unmeasured-instance",
    "A component has several instances, and the ADC measures the first one only: the others stay unknown until other "
    "code sets them.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every measured quantity."""
    for name, quantity, _ in system.measured():
        if system.components[name].instances > 1:
            place = quantity.spec.at("adc")
            yield Diagnostic(place, RULE, f"{quantity.path} is measured for {name}[0] only")
