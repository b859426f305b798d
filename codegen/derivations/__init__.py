"""The sources of the values of quantities. Each kind has a module here, which knows all about it.

``codegen/model/quantities/derivation.py`` says what the stages ask a derivation, ``codegen/model/spec/derivation.py``
has the keys of ``state.yaml`` that it is written with.
"""

from collections.abc import Callable, Mapping
from typing import Any

from codegen.derivations.clock import clock_component
from codegen.derivations.counts_returns import resolve_counts_returns
from codegen.derivations.enabled_by import resolve_enabled_by
from codegen.derivations.estimate import resolve_estimate
from codegen.derivations.extreme import resolve_extreme
from codegen.derivations.follows import resolve_follows
from codegen.derivations.integral import resolve_integral
from codegen.derivations.measured import resolve_measured
from codegen.derivations.received import resolve_received
from codegen.derivations.remainder import resolve_lasts, resolve_left
from codegen.derivations.set_by_code import SetByCode
from codegen.derivations.sourced import resolve_sourced
from codegen.derivations.surroundings import Kept, Surroundings
from codegen.derivations.trend import resolve_trend
from codegen.derivations.while_known import resolve_while_known
from codegen.model.quantities.derivation import Derivation
from codegen.model.spec.derivation import (
    CountsReturnsSpec,
    DerivationSpec,
    EnabledBySpec,
    EstimateSpec,
    FollowsSpec,
    HighestSpec,
    IntegralSpec,
    LastsSpec,
    LeftSpec,
    LowestSpec,
    MeasuredSpec,
    SourcedSpec,
    TrendSpec,
    WhileKnownSpec,
)
from codegen.model.vehicle import QuantityKind

__all__ = ("KINDS", "clock_component", "resolve_derivation")

KINDS: Mapping[type[DerivationSpec], Callable[[Any, Kept, Surroundings], Derivation | None]] = {
    MeasuredSpec: resolve_measured,
    TrendSpec: resolve_trend,
    EstimateSpec: resolve_estimate,
    FollowsSpec: resolve_follows,
    LowestSpec: resolve_extreme,
    HighestSpec: resolve_extreme,
    WhileKnownSpec: resolve_while_known,
    EnabledBySpec: resolve_enabled_by,
    CountsReturnsSpec: resolve_counts_returns,
    IntegralSpec: resolve_integral,
    LeftSpec: resolve_left,
    LastsSpec: resolve_lasts,
    SourcedSpec: resolve_sourced,
}
"""The function that resolves each kind, by the keys that it is written with."""


def resolve_derivation(kept: Kept, around: Surroundings) -> Derivation | None:
    """Return where the value of a quantity comes from; None after a finding."""
    written = around.spec.derivations
    if not written:
        return resolve_received(around) if around.received else SetByCode(around.spec.restarts_with)
    fitting = [each for each in written if each.is_named and _fits(each, kept, around)]
    if len(fitting) > 1:
        first, second, *_ = (each.KEY for each in fitting)
        around.bad(
            second,
            f"the value of {around.name} has one source, not both {first} and {second}",
            hint=f"leave out one of {first} and {second}",
        )
        return None
    resolved = [KINDS[type(each)](each, kept, around) for each in written if each in fitting or not each.is_named]
    return resolved[0] if len(resolved) == 1 else None


def _fits(written: DerivationSpec, kept: Kept, around: Surroundings) -> bool:
    """Return whether the quantity is one of those that a derivation gives a value."""
    key, name, kind = written.KEY, around.name, kept.kind
    if isinstance(written, SourcedSpec):
        return True  # it says itself what it cannot give
    if not written.GIVES_BOOLEAN:
        if kind is not QuantityKind.NUMBER:
            around.bad(
                key,
                f"{name} is a {kind.value} quantity and cannot have {key}",
                hint=f"leave {key} out, or make it a number: without {kind.value}",
            )
        return kind is QuantityKind.NUMBER
    fits = kind is QuantityKind.BOOLEAN and around.spec.initial is None
    if not fits:
        around.bad(
            key,
            f"{name} follows {getattr(written, key)}: it is a boolean without initial",
            hint="write boolean: true, and leave initial out",
        )
    return fits
