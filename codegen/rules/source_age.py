"""Values of sensors that are believed for too short a time, or for ever."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.quantities.source_kind import Source
from codegen.model.system import System

TOO_SHORT = Rule(
    "stale-before-reading",
    "What a sensor gives is forgotten before it gives a new value, so that the quantity is unknown meanwhile, and a "
    "sum of it counts nothing: each pause is a gap. Make stale_after longer than the time between two values: that of "
    "the rate, of the conversions that a monitor averages (average), or of the fixes of a receiver (fixes), with the "
    "turns in which it is asked.",
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
                source = system.sources[name]
                if trust.stale_after_ms is not None and trust.stale_after_ms * 1000 <= source.renewed_us:
                    message = f"{quantity.path} is old after {trust.stale_after_ms} ms, and {_renewed(source)}"
                    key = source.renewed_key
                    related = ((source.polling.spec.at(key), f"{key} is stated here"),)
                    hint = f"stale_after: {3 * source.renewed_us // 1000} ms, so that one failure changes nothing"
                    hint += "" if key == "rate" else f", or another {key} of {name}"
                    yield Diagnostic(quantity.spec.at("stale_after"), TOO_SHORT, message, hint, related=related)
                elif trust.stale_after_ms is None and trust.invalid_after is None:
                    hint = "add stale_after: 2 s" if quantity.initial is None else "add invalid_after: 3"
                    message = f"nothing makes {quantity.path} unknown when {name} fails"
                    yield Diagnostic(quantity.spec.at("source"), FOR_EVER, message, hint)


def _renewed(source: Source) -> str:
    """Return the words for how often a new value comes."""
    if source.renewed_key == "rate":
        return f"{source.name} is asked every {source.polling.period_us // 1000} ms"
    return f"{source.name} gives a new value every {source.renewed_us // 1000} ms"
