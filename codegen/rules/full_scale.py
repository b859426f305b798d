"""Thresholds that no reading can reach."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import System

RULE = Rule(
    "unreachable-threshold",
    "A warning threshold lies at or above what the ADC reads at full scale with the default multiplier: the warning "
    "never comes. Lower it, or correct the multiplier or the reference.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every measured quantity with a threshold."""
    for _, quantity in system.measured():
        conversion = quantity.conversion
        if conversion is None or quantity.warn_above is None:
            continue
        product = conversion.channel.full_scale * conversion.multiplier.default * conversion.numerator
        full_scale = product // conversion.denominator
        if full_scale <= quantity.warn_above:
            yield Diagnostic(
                quantity.spec.at("warn_above"),
                RULE,
                f"{quantity.path} reads at most {full_scale} {quantity.stored.name}",
                f"the threshold is {quantity.warn_above} {quantity.stored.name}",
            )
