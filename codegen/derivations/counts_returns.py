"""The derivation that counts returns of a thing that was gone, such as an exchanged pack."""

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.derivations.follows import amounts
from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.spec.derivation import (
    CountsReturnsSpec,
    EstimateSpec,
    FollowsSpec,
    IntegralSpec,
    LastsSpec,
    LeftSpec,
    MeasuredSpec,
)
from codegen.model.units.unit import NUMBER
from codegen.model.vehicle import Quantity, QuantityKind

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_RETURN = Rule(
    "bad-return",
    "One quantity of a component counts returns: a number without a unit and with an initial value. It names a boolean "
    "that follows a limit of what an ADC measures in the same component. What restarts with the count is a sum or "
    "what can be unknown or has an initial value, but not what is followed, nor what others decide at each moment.",
    remedy="write counts_returns_of: and the name of a boolean that follows a limit of what an ADC measures",
)

_BEGINNING = (MeasuredSpec, EstimateSpec, IntegralSpec, LeftSpec, LastsSpec)
"""Derivations that can begin anew, beside quantities that only code sets."""


@dataclass(frozen=True, slots=True)
class CountsReturns(Derivation):
    """Counts up when ``gone``, a boolean of the component, was true at a good reading and is not at a later one.

    ``least`` are stored units, of which ``steps`` make one ``unit``, of what that boolean follows.
    """

    gone: str
    least: tuple[int, ...] = ()
    stale_ms: int | None = None
    steps: Fraction = Fraction(1)
    unit: str = ""

    @property
    def counts(self) -> str | None:
        return self.gone

    @property
    def back_from(self) -> tuple[int, ...]:
        return self.least

    @property
    def set_stale_ms(self) -> int | None:
        return self.stale_ms

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        yield DerivationFact("counts returns of", self.gone, "counts_returns_of")
        if self.least:
            yield DerivationFact("back from", amounts(self.least, self.steps, self.unit), "back_from")
        if self.stale_ms is not None:
            yield DerivationFact("what code sets counts for", f"{self.stale_ms} ms", "restarting_stale_after")

    def words(self, quantity: Quantity) -> str:
        return f"counts when {quantity.component}.{self.gone} ends"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"counts up when {self.gone} was true and a reading shows that it is no longer"
        if self.stale_ms is not None:
            yield "set by code", f"what restarts with it counts for {self.stale_ms} ms after code has set any of that"


def resolve_counts_returns(written: CountsReturnsSpec, kept: Kept, around: Surroundings) -> CountsReturns:
    """The boolean whose end counts."""
    name, gone, others = around.name, written.counts_returns_of, around.others
    first = next(_counting(around))
    if first != name:
        related = [(others[first].at("counts_returns_of"), f"{first} counts them, too")]
        message = "a component has one quantity that counts returns"
        around.bad("counts_returns_of", message, BAD_RETURN, related=related, hint=f"leave it out here, or at {first}")
    if gone not in others:
        around.no_quantity("counts_returns_of", gone, BAD_RETURN)
    elif not _follows_a_reading(gone, around):
        message = f"{gone} is no boolean that follows a limit of what an ADC measures"
        hint = f"{gone}: {{boolean: true, follows: ..., below: ..., doc: ...}}"
        around.bad("counts_returns_of", message, BAD_RETURN, hint)
    if kept.unit is not NUMBER:
        message = f"{name} is no pure number that only code sets, so it cannot count"
        around.bad("counts_returns_of", message, BAD_RETURN, "count in a number without unit that has initial: 0")
    elif kept.initial is None:
        message = f"{name} starts unknown, and nothing can be added to that"
        around.bad("counts_returns_of", message, BAD_RETURN, "initial: 0")
    stale_ms = None
    if written.restarting_stale_after is not None:
        stale_ms = around.time_ms("restarting_stale_after", written.restarting_stale_after)
    if around.failed or written.back_from is None:
        return CountsReturns(gone, stale_ms=stale_ms)
    follows = others[gone].written(FollowsSpec)
    followed = (follows.follows if follows else None) or ""
    steps = around.steps_of(followed) if followed in others else None
    unit = others[followed].unit if followed in others else None
    return CountsReturns(gone, _back_from(written, around), stale_ms, steps or Fraction(1), unit or "")


def _back_from(written: CountsReturnsSpec, around: Surroundings) -> tuple[int, ...]:
    """Return the values from which on a reading is a return, by instance; none without them, or after a finding."""
    follows = around.others[written.counts_returns_of].written(FollowsSpec)
    followed = (follows.follows if follows else None) or ""
    if written.back_from is None or follows is None or followed not in around.others:
        return ()
    if follows.below is None or not isinstance(follows.below, Fraction) or written.back_from <= follows.below:
        message = f"{written.counts_returns_of} is not below a smaller number, so nothing lies between both"
        around.bad("back_from", message, BAD_RETURN, "make it more than the number at below, or leave it out")
        return ()
    steps, per = around.steps_of(followed), around.others[written.counts_returns_of].per
    counts = (1,) * len(around.parts) if per is None else around.counted(per, "back_from", BAD_RETURN)
    if steps is None or counts is None:
        return ()  # that was reported
    return tuple(around.in_steps("back_from", written.back_from, steps * count) for count in counts)


def _counting(around: Surroundings) -> Iterator[str]:
    """Yield the quantities of the component that count returns."""
    return (name for name, other in around.others.items() if other.written(CountsReturnsSpec) is not None)


def _follows_a_reading(name: str, around: Surroundings) -> bool:
    """Return whether it follows a reading, as written: names that cannot be resolved are reported elsewhere."""
    follows = around.others[name].written(FollowsSpec)
    if follows is None or follows.follows is None:
        return False
    followed = around.others.get(follows.follows)
    return followed is None or followed.written(MeasuredSpec) is not None


def check_restart(kept: Kept, around: Surroundings) -> None:
    """Report what keeps a quantity from beginning anew with a count."""
    name, spec, others = around.name, around.spec, around.others
    count, is_sound = spec.restarts_with, not around.failed
    if count is None:
        return
    counting = list(_counting(around))
    if count not in others:
        around.no_quantity("restarts_with", count, BAD_RETURN, counting)
    elif count not in counting:
        hint = "counts_returns_of: names what returns"
        around.bad("restarts_with", f"{count} does not count returns", BAD_RETURN, hint)
    if not is_sound:
        return  # what it is instead of a quantity that code sets has a fault of its own
    derived = [each for each in spec.derivations if not isinstance(each, _BEGINNING)]
    if derived or kept.kind is QuantityKind.ENUM:
        message = (
            f"{name} is not what code sets, a reading, an estimate, a sum, what is left of one, or how long that lasts"
        )
        around.bad("restarts_with", message, BAD_RETURN, "leave it out here")
    elif spec.written(MeasuredSpec) is not None and _is_followed(around):
        around.bad(
            "restarts_with",
            f"{name} tells whether it came back, so it cannot begin anew then",
            BAD_RETURN,
            "leave it out here",
        )
    elif spec.written(IntegralSpec) is not None and not kept.minimum <= 0 <= kept.maximum:
        around.bad(
            "restarts_with",
            f"{name} cannot be 0, from which it would start again",
            BAD_RETURN,
            "let min and max include 0",
        )


def _is_followed(around: Surroundings) -> bool:
    """Return whether what counts looks at this very quantity."""
    count = around.others.get(around.spec.restarts_with or "")
    counts = count.written(CountsReturnsSpec) if count is not None else None
    gone = around.others.get(counts.counts_returns_of) if counts is not None else None
    follows = gone.written(FollowsSpec) if gone is not None else None
    return follows is not None and follows.follows == around.name
