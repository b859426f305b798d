"""A failsafe, resolved: conditions on quantities or on silence, the levels that they lead to, and what is done then."""

from collections.abc import Mapping
from enum import Enum

from codegen.frozen import dataclass
from codegen.model.spec.failsafe import ConditionSpec, FailsafeLevelSpec, FailsafeSpec
from codegen.model.spec.program import ActionSpec
from codegen.model.units.unit import Unit, decimal
from codegen.model.vehicle import Citation, Component, Parameter, Quantity


class Sense(Enum):
    """The sense of a condition: the side of the limit, or the absence, at which it holds."""

    BELOW = "below"
    ABOVE = "above"
    UNKNOWN = "unknown"
    SILENT = "silent"


@dataclass(frozen=True, slots=True)
class Setting:
    """A threshold or a time, in whole ``unit``: so many for each step of a ``parameter``, or ``count`` of them.

    A parameter that starts at 0 or above switches what it belongs to off with 0 (``is_off_at_zero``).
    """

    parameter: Parameter | None
    count: int
    unit: Unit

    @property
    def is_off_at_zero(self) -> bool:
        """Return whether 0 switches it off."""
        return self.parameter is not None and self.parameter.minimum >= 0

    @property
    def ends(self) -> tuple[int, int]:
        """The least and the largest of its amounts, but for the 0 that switches it off."""
        parameter = self.parameter
        if parameter is None:
            return self.count, self.count
        least = max(parameter.minimum, 1) if self.is_off_at_zero else parameter.minimum
        return least * self.count, parameter.maximum * self.count

    @property
    def by_default(self) -> int | None:
        """The amount, or what the default of the parameter makes of it; None where that switches it off."""
        if self.parameter is None:
            return self.count
        return None if self.is_off_at_zero and not self.parameter.default else self.count * self.parameter.default

    @property
    def words(self) -> str:
        """The parameter, or the amount, for people."""
        if self.parameter is not None:
            return self.parameter.name
        return f"{self.count} {self.unit.name}".rstrip()

    @property
    def default_words(self) -> str:
        """The same with the parameter's default: ``BATT_LOW_VOLT, 10.5 V by default``."""
        if self.parameter is None:
            return self.words
        unit = f" {self.parameter.unit.name}" if self.parameter.unit.name else ""
        return f"{self.words}, {decimal(self.parameter.default * self.parameter.step)}{unit} by default"


@dataclass(frozen=True, slots=True)
class Condition:
    """A condition on a ``quantity``, or on the ground station where that is None.

    ``limit`` is what it is compared with, in stored units of the quantity; ``after`` how long it has to hold, in ms, at
    once where that is None; ``hysteresis`` how much better the quantity has to be, in its stored units. All conditions
    of a failsafe are on quantities of the same component.
    """

    sense: Sense
    quantity: Quantity | None
    limit: Setting | None
    after: Setting | None
    hysteresis: int
    spec: ConditionSpec | FailsafeLevelSpec

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Return the parameters that it reads."""
        return tuple(each.parameter for each in (self.limit, self.after) if each and each.parameter)

    @property
    def words(self) -> str:
        """The condition, for people: ``battery.voltage below BATT_LOW_VOLT``."""
        subject = self.quantity.path if self.quantity else "ground station"
        limit = f" {self.limit.words}" if self.limit else ""
        return f"{subject} {self.sense.value}{limit}"

    @property
    def edge(self) -> int | None:
        """The first stored step, with the defaults, at which it does not hold and is over; None where any is one."""
        at = self.limit.by_default if self.limit else None
        if at is None:
            return None
        return at + self.hysteresis + 1 if self.sense is Sense.BELOW else at - self.hysteresis - 1

    def rests_at(self, value: int) -> bool:
        """Return whether it does not hold at stored steps, nor just behind its hysteresis, with the defaults."""
        if self.edge is None:
            return True
        return value >= self.edge if self.sense is Sense.BELOW else value <= self.edge


@dataclass(frozen=True, slots=True)
class Shown:
    """A quantity in a text: with so many ``decimals``, or ``unknown`` in its place."""

    quantity: Quantity
    decimals: int
    unknown: str


@dataclass(frozen=True, slots=True)
class Clause:
    """A part of a text that is left out while a quantity in it is unknown."""

    parts: tuple[str | Shown, ...]

    @property
    def shown(self) -> tuple[Shown, ...]:
        """The quantities in it."""
        return tuple(part for part in self.parts if isinstance(part, Shown))


@dataclass(frozen=True, slots=True)
class FailsafeText:
    """A text in ``parts``: letters, ``{name}`` and ``{level}`` as they are, and quantities. ``written`` has all."""

    written: str
    parts: tuple[str | Shown | Clause, ...]


@dataclass(frozen=True, slots=True)
class FailsafeLevel:
    """A level: the conditions that lead to it, each by itself, and what is done once it is reached.

    ``action`` is the parameter that chooses, or the action itself, or None: then only a text is sent.
    """

    name: str
    number: int
    conditions: tuple[Condition, ...]
    action: Parameter | ActionSpec | None
    text: FailsafeText
    citation: Citation | None
    spec: FailsafeLevelSpec

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Return the parameters that it reads, once each: thresholds, times, the action."""
        read = [parameter for condition in self.conditions for parameter in condition.parameters]
        chosen = [self.action] if isinstance(self.action, Parameter) else []
        return tuple({parameter.name: parameter for parameter in (*read, *chosen)}.values())


@dataclass(frozen=True, slots=True)
class Failsafe:
    """A failsafe; ``component`` is the one that it watches, or that has its level; see FailsafeSpec.

    ``quantity`` is what it watches, or None: then it waits for ground stations. ``believed_above`` is in stored units.
    ``can_arm``: the vehicle can be armed, so that it may speak against that; one that cannot is watched at all times.
    """

    name: str
    component: Component | None
    quantity: Quantity | None
    levels: tuple[FailsafeLevel, ...]
    to_arm: tuple[Condition, ...]
    title: str
    over: FailsafeText | None
    believed_above: int | None
    enabled_by: Parameter | None
    health: Quantity | None
    health_every_ms: int
    level: Quantity | None
    can_arm: bool
    spec: FailsafeSpec
    citation: Citation
    aspects: Mapping[str, Citation]

    @property
    def instances(self) -> int:
        """Return how many things it watches, each for itself."""
        return self.component.instances if self.component else 1

    @property
    def watched(self) -> str:
        """Return what it watches, for people."""
        return self.quantity.path if self.quantity else "the ground station"

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """Return the conditions of all levels, the mildest first."""
        return tuple(condition for level in self.levels for condition in level.conditions)

    def floor(self, condition: Condition) -> int | None:
        """Return up to where what a condition of a level compares counts as unknown, in stored units; None: nowhere."""
        is_compared = condition.limit is not None and condition.quantity is self.quantity
        return self.believed_above if is_compared else None

    @property
    def recovers(self) -> bool:
        """Return whether the failsafe can end again: a latched one stays until the restart."""
        return not self.spec.latch
