"""Thresholds that no reading can reach."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.quantities.conversion import factors_by_instance
from codegen.model.quantities.full_scale import largest, most_in_use
from codegen.model.system import System

RULE = Rule(
    "unreachable-threshold",
    "A warning threshold lies at or above what the ADC reads at full scale with the default multiplier: the warning "
    "never comes. Lower it, or correct the multiplier or the reference.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every measured quantity with a threshold; what is beyond full scale in use is reported as that."""
    for name, quantity, conversion in system.measured():
        threshold = quantity.derivation.threshold
        if threshold is None or conversion.offset is not None:
            continue
        component = system.components[name]
        multipliers = factors_by_instance(conversion.multiplier, system.parameters, component.instances)
        found = set()
        for part, multiplier, limit in zip(component.parts, multipliers, threshold.above, strict=True):
            most = largest(conversion, multiplier, quantity)
            full = most_in_use(quantity, part)
            if most * quantity.steps > limit or (full is not None and full > most):
                continue
            found.add((int(most * quantity.steps), limit))
        for full_scale, limit in sorted(found):
            yield Diagnostic(
                quantity.spec.at("warn_above"),
                RULE,
                f"{quantity.path} reads at most {full_scale} {quantity.stored.name}",
                f"the threshold is {limit} {quantity.stored.name}",
            )
