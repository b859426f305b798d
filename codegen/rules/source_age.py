"""Values of sensors that are believed for too short a time, or for ever."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import System

TOO_SHORT = Rule(
    "stale-before-reading",
    "What a sensor gives is forgotten before it is asked again, so that the quantity is unknown most of the time. Make "
    "stale_after longer than the time between two readings.",
)
FOR_EVER = Rule(
    "believed-for-ever",
    "A sensor gives a quantity that nothing makes unknown once it fails: the last value would be sent for ever, as if "
    "it were a new one. Say stale_after, or invalid_after.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every quantity that sensors give."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            trust = quantity.trust
            for name, _, _ in quantity.derivation.gives:
                polling = system.sources[name].polling
                if trust.stale_after_ms is not None and trust.stale_after_ms * 1000 <= polling.period_us:
                    message = f"{quantity.path} is old after {trust.stale_after_ms} ms"
                    message += f", and {name} is asked every {polling.period_us // 1000} ms"
                    related = ((polling.spec.at("rate"), "the rate is stated here"),)
                    hint = f"stale_after: {3 * polling.period_us // 1000} ms, so that one failure changes nothing"
                    yield Diagnostic(quantity.spec.at("stale_after"), TOO_SHORT, message, hint, related=related)
                elif trust.stale_after_ms is None and trust.invalid_after is None:
                    hint = "add stale_after: 2 s" if quantity.initial is None else "add invalid_after: 3"
                    message = f"nothing makes {quantity.path} unknown when {name} fails"
                    yield Diagnostic(quantity.spec.at("source"), FOR_EVER, message, hint)
