"""Cases of sums over time of what sensors give: a simulated minute with both signs, and a pause that is a gap."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from codegen.frozen import dataclass
from codegen.model.answers.scaling import rounded
from codegen.model.quantities.basis import Basis
from codegen.model.quantities.source_kind import Output
from codegen.model.spec.population import Rounding
from codegen.model.system import System
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Quantity, by_instance
from codegen.targets.naming import parameter_attribute
from codegen.targets.suite.amounts.case import SUM, AmountCase, name_of, nearest, owner_of

_MINUTE_MS = 60000
_MOST_TURNS = 3000
_LONGEST_MS = 500
"""Between two turns, so that a minute takes few."""
_ENOUGH = 3
"""Steps of a sum that show it."""


class _Given(NamedTuple):
    """A quantity that a sensor gives to an instance: its place among the numbers of the driver, and the factor."""

    quantity: Quantity
    sensor: str
    output: Output
    place: int
    factor: Fraction

    def kept(self, handed: int) -> int:
        """Return what the state keeps of a number that the driver hands over."""
        return rounded(handed * self.factor, Rounding.NEAREST)


@dataclass(frozen=True, slots=True)
class _Phase:
    """So many turns, ``every_ms``, in each of which the sensors hand over the same numbers, by sensor and place."""

    turns: int
    every_ms: int
    of: int
    times: int


def sum_cases(system: System) -> Iterator[AmountCase]:
    """A case for each instance of a sum of what a sensor gives, with the remainders that come of it."""
    for component in system.components.values():
        for basis in component.counted_on:
            for instance in range(component.instances):
                for quantity in basis.sums:
                    yield _case(quantity, basis, instance, system)


def _case(quantity: Quantity, basis: Basis, instance: int, system: System) -> AmountCase:
    component, found = basis.component, quantity.derivation.sums
    assert found is not None
    of = _given(basis.quantity, instance, system)
    times = None if found.times is None else _given(component.quantities[found.times], instance, system)
    phases = _phases(quantity, of, times)
    settings, sizes = _stores(quantity, basis, instance, phases, (of, times), system)
    told: list[dict[str, object]] = []
    total = Fraction(0)
    for number, phase in enumerate(phases):
        if number and phase.every_ms <= _gap_ms(of):
            total += _added(phase, quantity, of, times)
        steps = nearest(total)
        kept = [[quantity.attribute, steps]]
        kept += [[each.attribute, _left(each, steps, size)] for each, size in sizes]
        hands = [[given.sensor, given.place, handed] for given, handed in _handed(phase, of, times)]
        told.append({"turns": phase.turns, "every_ms": phase.every_ms, "hands": hands, "kept": kept})
    facts = {**owner_of(quantity, instance), "parameters": settings, "masks": _masks(of, times, system), "phases": told}
    return AmountCase(
        f"{name_of(quantity, component, instance)}-is_summed_up", str(quantity.citation or ""), SUM, facts
    )


def _given(quantity: Quantity, instance: int, system: System) -> _Given:
    sensor, output, factor = quantity.derivation.gives[instance]
    outputs = system.sources[sensor].outputs
    before = outputs[: outputs.index(output)]
    return _Given(quantity, sensor, output, sum(each.storage.words for each in before), factor)


def _masks(of: _Given, times: _Given | None, system: System) -> dict[str, list[int]]:
    """By sensors that tell what is new: the place of that among their numbers, and the bits with which all is."""
    found = {}
    for given in (each for each in (of, times) if each is not None):
        source = system.sources[given.sensor]
        if source.tells_new:
            place = sum(output.storage.words for output in source.outputs) + (4 if source.sets_clock else 0)
            found[given.sensor] = [place, (1 << len(source.outputs)) - 1]
    return found


def _handed(phase: _Phase, of: _Given, times: _Given | None) -> list[tuple[_Given, int]]:
    """What is handed over, what is multiplied first: products are of the newest values."""
    return [*([] if times is None else [(times, phase.times)]), (of, phase.of)]


def _gap_ms(given: _Given) -> int:
    return given.quantity.trust.stale_after_ms or 0


def _added(phase: _Phase, quantity: Quantity, of: _Given, times: _Given | None) -> Fraction:
    """What the turns of a phase add, in steps of the sum: amounts and seconds, in base units."""
    seconds = Fraction(phase.turns * phase.every_ms, 1000)
    amount = of.kept(phase.of) * of.quantity.stored.scale * seconds
    if times is not None:
        amount *= times.kept(phase.times) * times.quantity.stored.scale
    return amount / quantity.stored.scale


def _phases(quantity: Quantity, of: _Given, times: _Given | None) -> list[_Phase]:
    """One turn that begins, a minute in which the sign changes, a gap, and a little more.

    What is handed over is large, and less only where the sum would pass its limits; where a minute of it is less than
    some steps of the sum, it takes longer.
    """
    every_ms = min(_LONGEST_MS, *(_gap_ms(each) or _LONGEST_MS for each in (of, times) if each is not None))
    third, most = max(1, _MINUTE_MS // every_ms // 3), _MOST_TURNS // 3
    for less in range(24):
        sizes = _sizes(of, times, less)
        for turns in [each for each in (third, 4 * third, 16 * third) if each == third or each <= most]:
            phases = _minute(quantity, of, turns, every_ms, sizes)
            totals = _totals(phases, quantity, of, times)
            if min(totals) < quantity.minimum or max(totals) > quantity.maximum:
                break
            if totals[1] >= _ENOUGH or 4 * turns > most:
                after = [_Phase(1, _gap_ms(of) + 1, sizes[0], sizes[2]), _Phase(3, every_ms, sizes[0], sizes[2])]
                return [*phases, *after]
    return phases


def _sizes(of: _Given, times: _Given | None, less: int) -> tuple[int, int, int]:
    """Most of what can be handed over above and below zero, and of what that is multiplied by; less by halves."""
    above, below = (max(1, end * 5 // (7 << less)) for end in (of.output.high, max(0, -of.output.low)))
    return above, below, 0 if times is None else max(1, times.output.high * 4 // (7 << min(less // 2, 4)))


def _minute(quantity: Quantity, of: _Given, turns: int, every_ms: int, sizes: tuple[int, int, int]) -> list[_Phase]:
    above, below, times = sizes
    sooner_ms, fewer = every_ms - every_ms // 5, times - times // 4
    phases = [_Phase(1, every_ms, above, times), _Phase(turns, every_ms, above, times)]
    if of.output.low >= 0:
        return [*phases, _Phase(turns, sooner_ms, max(1, above // 3), fewer)]
    phases.append(_Phase(turns, sooner_ms, -max(1, below * 3 // 5), fewer))
    return [*phases, _Phase(turns, every_ms, -below, times)] if quantity.minimum < 0 else phases


def _totals(phases: list[_Phase], quantity: Quantity, of: _Given, times: _Given | None) -> list[Fraction]:
    found = [Fraction(0)]
    for phase in phases[1:]:
        found.append(found[-1] + _added(phase, quantity, of, times))
    return found


def _stores(
    quantity: Quantity,
    basis: Basis,
    instance: int,
    phases: list[_Phase],
    given: tuple[_Given, _Given | None],
    system: System,
) -> tuple[dict[str, int], list[tuple[Quantity, Fraction]]]:
    """Parameters of full stores of which some is left, and each remainder with its store in steps of the sum."""
    settings, sizes = {}, []
    drawn = max(map(abs, _totals(phases, quantity, *given)))
    for each in basis.given:
        rest = each.derivation.remains
        if rest is None or rest.after != quantity.name:
            continue
        own = by_instance(rest.full, system.parameters, basis.component.instances)[instance]
        step = own.step * own.unit.scale / quantity.stored.scale
        steps = max(own.minimum, 1, min(own.maximum, int(drawn * 3 / step)))
        if own.choices:
            steps = min(own.choices, key=lambda choice: abs(choice - steps))
        settings[parameter_attribute(own.name)] = steps
        sizes.append((each, steps * step))
    return settings, sizes


def _left(quantity: Quantity, after: int, size: Fraction) -> int | None:
    """What is left of a store, in its own steps or as a share."""
    left = min(max(size - after, Fraction(0)), size)
    rest = quantity.derivation.remains
    assert rest is not None
    if not size:
        return None
    if rest.share is not None:
        left = left / size * unit_named("%").scale * 100 / quantity.stored.scale
    return min(nearest(left), int(quantity.maximum))
