"""Readings that are called old before the next one can come."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System

RULE = Rule(
    "stale-before-update",
    "A reading is forgotten before the next one is taken, so that the quantity is unknown most of the time. Make "
    "stale_after longer than the time between two updates.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every measured quantity of a component with an update rate."""
    for name, quantity, _ in system.measured():
        period_ms, stale_ms = system.components[name].period_ms, quantity.trust.stale_after_ms
        if period_ms is not None and stale_ms is not None and stale_ms <= period_ms:
            yield Diagnostic(
                quantity.spec.at("stale_after"),
                RULE,
                f"{quantity.path} is old after {stale_ms} ms, and read every {period_ms} ms",
                f"stale_after: {3 * period_ms} ms, so that one failure changes nothing",
                related=((system.components[name].spec.at("update_rate"), "the update rate is stated here"),),
            )
