"""Cases of sums over time of what sensors give, with what they leave of a full store and how long that lasts."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from codegen.model.quantities.basis import Basis
from codegen.model.system import System
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Quantity, by_instance
from codegen.targets.naming import parameter_attribute
from codegen.targets.suite.amounts.case import SUM, AmountCase, criterion_of, name_of, nearest, owner_of
from codegen.targets.suite.amounts.minute import Given, Phase, added, given_to, most_of, phases_of


class _Store(NamedTuple):
    """A remainder ``left`` of a full store of so many steps of the sum; ``lasting`` are times that it lasts."""

    left: Quantity
    size: Fraction
    lasting: tuple[Quantity, ...]


def sum_cases(system: System) -> Iterator[AmountCase]:
    """A case for each instance of a sum of what a sensor gives, with the remainders that come of it."""
    for component in system.components.values():
        for basis in component.counted_on:
            for instance in range(component.instances):
                for quantity in basis.sums:
                    yield from _cases(quantity, basis, instance, system)


def _cases(quantity: Quantity, basis: Basis, instance: int, system: System) -> Iterator[AmountCase]:
    """The case, but of a sum whose limits leave nothing to sum up."""
    component, found = basis.component, quantity.derivation.sums
    assert found is not None
    of = given_to(basis.quantity, instance, system)
    times = None if found.times is None else given_to(component.quantities[found.times], instance, system)
    phases = phases_of(quantity, of, times)
    if not phases:
        return
    settings, stores = _stores(quantity, basis, instance, most_of(phases, quantity, of, times), system)
    if any(each.lasting for each in stores):  # one reading of less, which the mean hardly follows
        phases = (*phases[:2], phases[1]._replace(turns=1, of=max(1, phases[1].of // 3)), *phases[2:])
    told: list[dict[str, object]] = []
    total = Fraction(0)
    for number, phase in enumerate(phases):
        total += added(phase, quantity, of, times)
        kept: list[list[object]] = [[quantity.attribute, nearest(total)]]
        kept += [[each.left.attribute, _left(each, nearest(total))] for each in stores]
        about: list[list[object]] = []
        if number < 2:  # the mean is what is drawn, as long as that is always the same
            kept += [line for each in stores for line in _lasting(each, nearest(total), of.amount(phase.of), quantity)]
        elif number == 2:
            drawn = of.amount(phases[1].of), of.amount(phase.of)
            about = [line for each in stores for line in _lasting_about(each, nearest(total), drawn, quantity, of)]
        hands = _handed(phase, of, times)
        told.append({"turns": phase.turns, "every_ms": phase.every_ms, "hands": hands, "kept": kept, "about": about})
    aging = [each.attribute for store in stores for each in (store.left, *store.lasting)]
    old = {"after_ms": of.gap_ms, "attributes": aging}
    facts = {"parameters": settings, "masks": _masks(of, times, system), "phases": told, "old": old}
    name, owner = f"{name_of(quantity, component, instance)}-is_summed_up", owner_of(quantity, instance)
    yield AmountCase(name, criterion_of(quantity, component), SUM, {**owner, **facts})


def _handed(phase: Phase, of: Given, times: Given | None) -> list[list[object]]:
    """Sensors, places and numbers, that which is multiplied by first: products are of the newest values."""
    first = [] if times is None else [(times, phase.times)]
    return [[given.sensor, given.place, handed] for given, handed in (*first, (of, phase.of))]


def _masks(of: Given, times: Given | None, system: System) -> dict[str, list[int]]:
    """By sensors that tell what is new: the place of that among their numbers, and the bits with which all is."""
    found = {}
    for given in (each for each in (of, times) if each is not None):
        source = system.sources[given.sensor]
        if source.tells_new:
            place = sum(output.storage.words for output in source.outputs) + (4 if source.sets_clock else 0)
            found[given.sensor] = [place, (1 << len(source.outputs)) - 1]
    return found


def _stores(
    quantity: Quantity, basis: Basis, instance: int, drawn: Fraction, system: System
) -> tuple[dict[str, int], list[_Store]]:
    """Parameters of full stores of which something is left, and these."""
    settings: dict[str, int] = {}
    stores = []
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
        lasting = [one for one in basis.given if one.derivation.lasts and one.derivation.lasts.left == each.name]
        stores.append(_Store(each, steps * step, tuple(lasting)))
    return settings, stores


def _left(store: _Store, after: int) -> int | None:
    """Return what is left of a store, in its own steps or as a share."""
    rest = store.left.derivation.remains
    assert rest is not None
    if not store.size:
        return None
    left = min(max(store.size - after, Fraction(0)), store.size)
    if rest.share is not None:
        left = left / store.size * 100 * unit_named("%").scale / store.left.stored.scale
    return min(nearest(left), int(store.left.maximum))


def _lasting(store: _Store, after: int, drawn: Fraction, quantity: Quantity) -> Iterator[list[object]]:
    """Yield how long what is left lasts at what is drawn, in whole steps; that is in base units."""
    left = min(max(store.size - after, Fraction(0)), store.size) * quantity.stored.scale
    for each in store.lasting:
        lasts = min(int(left / drawn / each.stored.scale), int(each.maximum)) if drawn > 0 and store.size else None
        yield [each.attribute, lasts]


def _lasting_about(
    store: _Store, after: int, drawn: tuple[Fraction, Fraction], quantity: Quantity, of: Given
) -> Iterator[list[object]]:
    """Yield the least and the most that it lasts after one reading of less: the mean goes one part of so many to it."""
    left = min(max(store.size - after, Fraction(0)), store.size) * quantity.stored.scale
    for each in store.lasting:
        lasting = each.derivation.lasts
        assert lasting is not None
        mean = drawn[0] + (drawn[1] - drawn[0]) / lasting.readings
        step = of.quantity.stored.scale
        if mean > 2 * step and store.size:
            ends = (int(left / most / each.stored.scale) for most in (mean + step, mean - 2 * step))
            least, most = (min(end, int(each.maximum)) for end in ends)
            yield [each.attribute, least - 1, most + 1]
