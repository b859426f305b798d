"""A boolean that is true while another quantity has reached a limit, is below one, or lies between two."""

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.model.answers.known import Known, Stored
from codegen.model.code.payload_code import UNKNOWN
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.spec.derivation import FollowsSpec
from codegen.model.spec.state import QuantitySpec
from codegen.model.units.unit import Unit, decimal, read_measure
from codegen.model.vehicle import Quantity

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_FOLLOWING = Rule(
    "bad-following",
    "A boolean that follows names a number of the same component and a limit for it, at_least or below, in its unit, "
    "or a fact that is an amount; or both, at_least the smaller one. With per the limit, or warn_above, is multiplied "
    "with a fact that counts something. "
    "board.yaml states facts for every instance.",
    remedy="write follows: and the name of a number of this component, with at_least or below",
)


@dataclass(frozen=True, slots=True)
class Follows(Derivation):
    """True while ``quantity`` of the same component is known and at least a limit, or below it.

    ``limits`` has one for each instance, in stored units of that quantity, of which ``steps`` make one ``unit``. With
    ``floors`` it is below the limit and at least the floor.
    """

    quantity: str
    limits: tuple[int, ...]
    is_below: bool
    spec: FollowsSpec
    floors: tuple[int, ...] = ()
    steps: Fraction = Fraction(1)
    unit: str = ""

    @property
    def follows(self) -> str | None:
        return self.quantity

    @property
    def differs_by_instance(self) -> bool:
        return len(set(self.limits)) > 1 or len(set(self.floors)) > 1

    @property
    def own_limits(self) -> tuple[int, ...]:
        return self.limits

    @property
    def is_true_below(self) -> bool:
        return self.is_below

    @property
    def own_floors(self) -> tuple[int, ...]:
        return self.floors

    def holds(self, limit: str, floor: str) -> str:
        # Unknown is less than every limit.
        if floor:
            return f"value < {limit} and value >= {floor}"
        return f"value < {limit} and value != {UNKNOWN}" if self.is_below else f"value >= {limit}"

    def attribute(self, place: str, own: str, own_floor: str) -> str:
        compare = "below" if self.is_below else "at_least"
        arguments = [place, str(self.limits[0]), *([own] if len(set(self.limits)) > 1 else ())]
        arguments += [f"floor={self.floors[0]}"] if self.floors else []
        arguments += [f"own_floor={own_floor}"] if len(set(self.floors)) > 1 else []
        return f"{compare}({', '.join(arguments)})"

    def value(self, quantity: Quantity, known: Known, instance: int) -> Stored:
        """False while the quantity is unknown. A component of a single instance has only that, whatever the message."""
        stored = known[quantity.decided_by]
        assert not isinstance(stored, tuple | str)
        limit = self.limits[instance if instance < len(self.limits) else 0]
        if stored is None or stored < self._floor(instance, stored):
            return 0
        return int(stored < limit if self.is_below else stored >= limit)

    def _floor(self, instance: int, without: "Fraction | float") -> "Fraction | float":
        return self.floors[instance if instance < len(self.floors) else 0] if self.floors else without

    def deciding(self, instance: int, plain: "Stored") -> Mapping[str, "Stored"]:
        limit = self.limits[instance if instance < len(self.limits) else 0]
        at, below = ("clear", "set") if self.is_below else ("set", "clear")
        found = {at: limit, below: limit - 1, "unknown": None}
        if self.floors:
            floor = int(self._floor(instance, limit))
            found |= {"set-least": floor, "too-little": floor - 1}
        return found

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.quantity,)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        limits = amounts(self.limits, self.steps, self.unit)
        limits += f" and at least {amounts(self.floors, self.steps, self.unit)}" if self.floors else ""
        yield DerivationFact("true while", f"{self.quantity} is {self._word} {limits}", "follows")

    def words(self, quantity: Quantity) -> str:
        return f"while {quantity.decided_by} is {self._limit(quantity)}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"true while {self.quantity} is {self._limit(quantity)}"

    @property
    def _word(self) -> str:
        return "below" if self.is_below else "at least"

    def _limit(self, quantity: Quantity) -> str:
        """Return the limit as written: ``at least 4.25 times cells``."""
        times = f" times {quantity.spec.per}" if quantity.spec.per else ""
        limit = self.spec.below if self.is_below else self.spec.at_least
        assert limit is not None
        words = f"{self._word} {limit if isinstance(limit, str) else decimal(limit)}{times}"
        floor = self.spec.at_least
        if not self.floors or floor is None:
            return words
        return f"{words} and at least {floor if isinstance(floor, str) else decimal(floor)}{times}"


def amounts(stored: Iterable[int], steps: Fraction, unit: str) -> str:
    """Return stored numbers in the unit of which they are steps: the same words for the same amounts, however kept."""
    return ", ".join(f"{decimal(number / steps)} {unit}".rstrip() for number in stored)


def resolve_follows(written: FollowsSpec, kept: Kept, around: Surroundings) -> Follows | None:
    """The limit that a boolean follows, by instance; None after a finding."""
    limits = {
        key: limit for key, limit in (("at_least", written.at_least), ("below", written.below)) if limit is not None
    }
    if written.follows is None:
        for key in limits:
            around.bad(
                key,
                f"{key} says nothing without follows",
                BAD_FOLLOWING,
                hint=f"name the number that has the limit: follows: NAME, or leave out {key}",
            )
        return None
    followed = _followed(written.follows, around)
    if followed is None:
        return None
    if not limits:
        hint = "write at_least: 2, or below: 2"
        around.bad("follows", f"no limit given for {written.follows}", BAD_FOLLOWING, hint)
        return None
    found = _in_steps(limits, written.follows, around)
    if found is None:
        return None
    floors = found["at_least"] if len(found) == 2 else ()
    if any(low >= high for low, high in zip(floors, found.get("below", ()), strict=False)):
        message = f"nothing is at least this and below the other limit of {written.follows}"
        around.bad("at_least", message, BAD_FOLLOWING, hint="make at_least the smaller one, or leave out one of both")
    is_below = "below" in found
    steps = around.steps_of(written.follows) or Fraction(1)
    chosen = found["below" if is_below else "at_least"]
    return Follows(written.follows, chosen, is_below, written, floors, steps, followed.unit or "")


def _followed(name: str, around: Surroundings) -> QuantitySpec | None:
    """The number that is followed; None after a finding."""
    followed = around.others.get(name)
    if followed is None:
        around.no_quantity("follows", name, BAD_FOLLOWING)
        return None
    if followed.boolean or followed.text is not None or followed.enum is not None or followed.elements is not None:
        around.bad(
            "follows",
            f"{name} is not a single number",
            BAD_FOLLOWING,
            hint="follow a quantity that is one number, without boolean, enum, text and elements",
        )
        return None
    return followed


def _in_steps(
    limits: Mapping[str, Fraction | str], name: str, around: Surroundings
) -> dict[str, tuple[int, ...]] | None:
    """The limits in stored units, by instance; None after a finding."""
    followed, steps = around.others[name], around.steps_of(name)
    counts: tuple[int, ...] | None = (1,) * len(around.parts)
    if around.spec.per is not None and steps is not None:
        counts = around.counted(around.spec.per, "per", BAD_FOLLOWING)
    if steps is None or counts is None:
        return None  # the units of the followed quantity have been reported, or the fact
    found = {}
    for key, limit in limits.items():
        values = _amounts(key, limit, followed.unit or "", around)
        scaled = [value * steps * count for value, count in zip(values or (), counts, strict=False)]
        if any(each.denominator != 1 or abs(each) > SMALL_INT_MAX for each in scaled):
            message = f"{key} is not a whole number of the units that its quantity is kept in, or too large"
            around.bad(key, message, BAD_FOLLOWING, hint="round it, or keep what is followed more finely: stored")
        found[key] = tuple(int(each) for each in scaled)
    return None if around.failed else found


def _amounts(key: str, limit: Fraction | str, unit: str, around: Surroundings) -> tuple[Fraction, ...] | None:
    """The limit of each instance in the unit of what is followed: a number, or a fact; None after a finding."""
    if isinstance(limit, Fraction):
        return (limit,) * len(around.parts)
    found, spelt = [], Unit.parse(unit)
    for part in around.parts:
        written = part.facts.get(limit)
        measure = read_measure(str(written))
        amount = None if measure is None or spelt is None else measure.in_unit(spelt)
        if amount is None:
            what = "does not state the fact" if written is None else f"has {written}, which is no amount in {unit}, for"
            hint = did_you_mean(limit, part.facts) or f"facts: {{{around.component}: {{{limit}: 20 {unit or 1}}}}}"
            around.bad(key, f"board.yaml {what} {limit}", BAD_FOLLOWING, hint)
            return None
        found.append(amount)
    return tuple(found)
