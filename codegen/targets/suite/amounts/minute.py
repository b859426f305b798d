"""The simulated minute of a sum: what sensors hand over when, and what that makes, by units and the tables alone."""

import math
from fractions import Fraction
from typing import NamedTuple

from codegen.model.answers.scaling import rounded
from codegen.model.quantities.source_kind import Output
from codegen.model.spec.population import Rounding
from codegen.model.system import System
from codegen.model.vehicle import Quantity

_MINUTE_MS = 60000
_MOST_TURNS = 1000
"""In one phase: what is told less often takes no longer."""
_MOST_TO_ROUND = 40
_LONGEST_MS = 500
"""Between two turns, so that a minute takes few."""
_ENOUGH = 3
"""Steps of a sum that show it."""


class Given(NamedTuple):
    """A quantity that a sensor gives to an instance: its place among the numbers of the driver, and the factor."""

    quantity: Quantity
    sensor: str
    output: Output
    place: int
    factor: Fraction

    @property
    def gap_ms(self) -> int:
        """The longest time between two values that is no gap."""
        return self.quantity.trust.stale_after_ms or 0

    def amount(self, handed: int) -> Fraction:
        """Return what the state keeps of a number that the driver hands over, in base units."""
        return rounded(handed * self.factor, Rounding.NEAREST) * self.quantity.stored.scale


class Phase(NamedTuple):
    """So many turns, ``every_ms``, in each of which the driver hands over ``of``, and of what that is multiplied by
    ``times``; ``counts``: each stands for the time since the one before.
    """

    turns: int
    every_ms: int
    of: int
    times: int
    counts: bool = True


def given_to(quantity: Quantity, instance: int, system: System) -> Given:
    """Return what gives a quantity to an instance."""
    sensor, output, factor = quantity.derivation.gives[instance]
    outputs = system.sources[sensor].outputs
    before = outputs[: outputs.index(output)]
    return Given(quantity, sensor, output, sum(each.storage.words for each in before), factor)


def added(phase: Phase, quantity: Quantity, of: Given, times: Given | None) -> Fraction:
    """Return what the turns of a phase add, in steps of the sum: amounts and seconds."""
    if not phase.counts:
        return Fraction(0)
    amount = of.amount(phase.of) * Fraction(phase.turns * phase.every_ms, 1000)
    if times is not None:
        amount *= times.amount(phase.times)
    return amount / quantity.stored.scale


def phases_of(quantity: Quantity, of: Given, times: Given | None) -> tuple[Phase, ...]:
    """One turn that begins, a minute in which the sign changes, a gap, and a little more.

    What is handed over is large, and less only where the sum would pass its limits; where a minute of it is less than
    some steps of the sum, it takes longer.
    """
    every_ms = min(_LONGEST_MS, *(each.gap_ms or _LONGEST_MS for each in (of, times) if each is not None))
    third = max(1, _MINUTE_MS // every_ms // 3)
    found: tuple[Phase, ...] = ()
    for less in range(24):
        sizes = _sizes(of, times, less)
        for turns in [third, *(each for each in (4 * third, 16 * third) if each <= _MOST_TURNS)]:
            tried = _minute(quantity, of, turns, every_ms, sizes)
            totals = _totals(tried, quantity, of, times)
            if min(totals) < quantity.minimum or max(totals) > quantity.maximum:
                break
            found = tried
            if totals[1] >= _ENOUGH:
                return _rounded_up(found, quantity, of, times)
        if found:
            return _rounded_up(found, quantity, of, times)
    return found


def _rounded_up(phases: tuple[Phase, ...], quantity: Quantity, of: Given, times: Given | None) -> tuple[Phase, ...]:
    """The phases with one more turn or some, until half a step or more is left, which a sum rounds up."""
    last = phases[-1]
    total = _totals(phases, quantity, of, times)[-1]
    for turns in range(1, _MOST_TO_ROUND):
        more = Phase(turns, last.every_ms, max(1, last.of // 2), last.times)
        after = total + added(more, quantity, of, times)
        if Fraction(1, 2) <= after - math.floor(after) and after <= quantity.maximum:
            return (*phases, more)
    return phases


def most_of(phases: tuple[Phase, ...], quantity: Quantity, of: Given, times: Given | None) -> Fraction:
    """Return the most that is summed up at the end of a phase, or below zero."""
    return max(map(abs, _totals(phases, quantity, of, times)))


def _sizes(of: Given, times: Given | None, less: int) -> tuple[int, int, int]:
    """Most of what can be handed over above and below zero, and of what that is multiplied by; less by halves."""
    above, below = (max(1, end * 5 // (7 << less)) for end in (of.output.high, max(0, -of.output.low)))
    return above, below, 0 if times is None else max(1, times.output.high * 4 // (7 << min(less // 2, 4)))


def _minute(quantity: Quantity, of: Given, turns: int, every_ms: int, sizes: tuple[int, int, int]) -> tuple[Phase, ...]:
    above, below, times = sizes
    sooner_ms, fewer = every_ms - every_ms // 5, times - times // 4
    phases = [Phase(1, every_ms, above, times, counts=False), Phase(turns, every_ms, above, times)]
    if of.output.low >= 0:
        phases.append(Phase(turns, sooner_ms, max(1, above // 3), fewer))
    else:
        phases.append(Phase(turns, sooner_ms, -max(1, below * 3 // 5), fewer))
    if of.output.low < 0 and quantity.minimum < 0:
        phases.append(Phase(turns, every_ms, -below, times))
    gap = Phase(1, of.gap_ms + 1, above, times, counts=False)
    return (*phases, gap, Phase(3, every_ms, above, times))


def _totals(phases: tuple[Phase, ...], quantity: Quantity, of: Given, times: Given | None) -> list[Fraction]:
    found = [Fraction(0)]
    for phase in phases:
        found.append(found[-1] + added(phase, quantity, of, times))
    return found[1:]
