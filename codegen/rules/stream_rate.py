"""Messages that are sent more often than their values change."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import decimal

RULE = Rule(
    "rate-above-update",
    "A stream's default rate is above the update rate of a component that its messages report: the same values go "
    "out again and again.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every populated message with the slowest component that it reports."""
    for message in system.messages:
        if message.stream is None:
            continue
        rate = message.stream.default_rate
        for name in sorted(_components(message, system)):
            period = system.components[name].period_ms
            if period is not None and rate * period > 1000:
                yield Diagnostic(
                    message.population.at("stream"),
                    RULE,
                    f"{message.name} goes out at {decimal(rate)} Hz, but {name} is updated every {period} ms",
                    f"update_rate: {decimal(rate)} Hz at {name}, or a stream of {decimal(Fraction(1000, period))} Hz",
                    related=((system.components[name].spec.at("update_rate"), f"{name} is updated at this rate"),),
                )


def _components(message: PopulatedMessage, system: System) -> set[str]:
    """The components at whose rate what is reported changes: code, sensors and messages have times of their own."""
    carried = {quantity.path: quantity for answer in message.answers for quantity in answer.carried}
    return {
        quantity.component
        for quantity in carried.values()
        if not (quantity.derivation.ages_alone and system.components[quantity.component].readings)
    }
