"""Collects the uses of each quantity by the tables, before it is decided how the quantity is kept."""

from collections.abc import Iterator, Mapping
from typing import TypeVar

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import Dialect, WireField
from codegen.model.program import VEHICLE_QUANTITIES
from codegen.model.spec.failsafe import FailsafeSpec
from codegen.model.spec.receive import ReceiveSpec
from codegen.model.spec.spec import Spec
from codegen.resolve.population.elements import answered_ranges

_Each = TypeVar("_Each")


@dataclass(frozen=True, slots=True)
class Carriers:
    """The ``fields`` that carry each quantity's value, by path, and the paths of those that are ``compared``.

    ``received`` are the tables that set each quantity from a message, with the keys of its fields. What is compared,
    counted or spread over elements is done so in whole numbers of one word.
    """

    fields: Mapping[str, tuple[WireField, ...]]
    compared: frozenset[str]
    received: Mapping[str, tuple[tuple[ReceiveSpec, str], ...]]


def find_carriers(spec: Spec, dialect: Dialect) -> Carriers:
    """Return the carriers in all tables; names that cannot be found are reported where the tables are resolved."""
    fields: dict[str, list[WireField]] = {}
    compared = set(_compared(spec))
    for population in spec.populations:
        compared |= {path for path in (population.on_change, population.pages) if path}
        compared |= {f"{name}.{one.lowest}" for name, one in population.represents.items() if one.lowest}
        message = dialect.messages.get(population.message)
        for key, answer in population.fields.items():
            if answer.each is not None:
                compared.add(answer.each)
            if answer.state is None or message is None:
                continue
            if answer.split:
                compared.add(answer.state)
            fields.setdefault(answer.state, []).extend(field for field, _, _ in answered_ranges(key, message))
    received: dict[str, list[tuple[ReceiveSpec, str]]] = {}
    for table in spec.receives:
        message = dialect.messages.get(table.receive)
        for key, taken in table.fields.items():
            received.setdefault(taken.state, []).append((table, key))
            if message is not None:
                fields.setdefault(taken.state, []).extend(field for field, _, _ in answered_ranges(key, message))
    return Carriers(_fixed(fields), frozenset(compared), _fixed(received))


def _fixed(lists: Mapping[str, list[_Each]]) -> dict[str, tuple[_Each, ...]]:
    return {path: tuple(found) for path, found in lists.items()}


def _compared(spec: Spec) -> Iterator[str]:
    """The paths that other quantities and the program look at."""
    for component, written in spec.state.components.items():
        for quantity in written.quantities.values():
            for derivation in quantity.derivations:
                name = getattr(derivation, derivation.KEY)
                if isinstance(name, str) and derivation.LOOKS_AT_QUANTITY:
                    yield f"{component}.{name}"
    if spec.vehicle is None:
        return
    yield from (f"vehicle.{name}" for name in VEHICLE_QUANTITIES)
    for failsafe in spec.vehicle.failsafes.values():
        yield from _of_failsafe(failsafe)


def _of_failsafe(failsafe: FailsafeSpec) -> Iterator[str]:
    """The paths of what a failsafe compares, and of what it sets."""
    component = (failsafe.watches or "").partition(".")[0]
    conditions = [*failsafe.to_arm, *(each for level in failsafe.levels.values() for each in level.either)]
    for path in (failsafe.watches, *(each.watches for each in conditions)):
        if path is not None:
            yield path
    for name in (failsafe.health, failsafe.level):
        if name is not None:
            yield name if "." in name else f"{component}.{name}"
