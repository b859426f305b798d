"""Limits of the time of a reading that no reading can pass before the next one is due."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.model.system import System

RULE = Rule(
    "idle-limit",
    "A mean of an ADC channel may take longer than the time from one reading to the next (read_limit, or limit of a "
    "sensor): it is dropped only when the next ones are late as well, so that the limit guards nothing.",
    Severity.WARNING,
    remedy="write a time that a mean takes at most, such as 2 ms",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every ADC channel that something measures."""
    periods: dict[str, list[int]] = {}
    for component in system.components.values():
        for quantity in component.quantities.values():
            conversion = quantity.derivation.conversion
            if conversion is not None and component.period_ms is not None:
                periods.setdefault(conversion.channel.name, []).append(component.period_ms)
    for name, found in periods.items():
        channel = system.channels[name]
        limit, period = channel.read_limit_us, min(found)
        if limit is not None and limit >= period * 1000:
            place = channel.spec.at("read_limit")
            message = f"a mean of {name} may take {limit // 1000} ms, and it is read every {period} ms"
            hint = f"write less than {period} ms: a mean takes some microseconds"
            yield Diagnostic(place, RULE, message, hint, fingerprint=fingerprint(RULE.id, place.file, name))
