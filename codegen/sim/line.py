"""The quantities that a simulation draws and compares, and those that it watches."""

from collections.abc import Iterator, Sequence

from codegen.frozen import dataclass
from codegen.model.scenario import Expectation, Scenario
from codegen.model.system import System
from codegen.model.vehicle import QuantityKind
from codegen.sim.guards import Level, levels_of
from codegen.sim.told import told_paths

_STATE = ("armed", "status", "mode")
"""Quantities of the vehicle that are watched where there are any."""
_EVENTS = tuple(f"vehicle.{name}" for name in _STATE)
"""The same: their changes are events."""


@dataclass(frozen=True, slots=True)
class Line:
    """A quantity of one instance: ``label`` as courses name it, ``path`` without the instance, its unit and doc.

    ``levels`` are those of the failsafe that watches it; ``is_told``: messages carry it, and
    ``is_whole``: it only counts.
    """

    label: str
    path: str
    instance: int
    unit: str
    doc: str = ""
    levels: tuple[Level, ...] = ()
    is_told: bool = True
    is_whole: bool = False


@dataclass(frozen=True, slots=True)
class Watched:
    """A quantity that the simulation looks at in the state, by its label; ``ages``: time alone may make it unknown."""

    label: str
    component: str
    instance: int
    name: str
    ages: bool = False


def lines_of(system: System, scenario: Scenario, key: str | None) -> tuple[Line, ...]:
    """The numbers that have a course or are told, those with a course first; ``key`` is that of the program."""
    stretches = scenario.stretches(key)
    courses = dict.fromkeys(course.label for stretch in stretches for course in stretch.courses)
    found = {line.label: line for path in _paths(system, list(courses)) for line in _lines(system, path)}
    return tuple(sorted(found.values(), key=lambda line: line.label not in courses))


def watched(system: System, expected: Sequence[Expectation]) -> tuple[Watched, ...]:
    """The quantities of the state that are recorded: what the vehicle does, and what is expected of the state."""
    vehicle = system.components.get("vehicle")
    known = vehicle.quantities if vehicle else {}
    found = [Watched(f"vehicle.{name}", "vehicle", 0, name) for name in _STATE if name in known]
    labels = [expectation.label for expectation in expected if expectation.label and not expectation.told]
    for label in labels:
        component, instance, name = split_label(label)
        quantity = system.quantity(f"{component}.{name}")
        ages = quantity is not None and (quantity.ages or quantity.ages_by_readings)
        found.append(Watched(label, component, instance, name, ages))
    return tuple(dict.fromkeys(found))


def split_label(label: str) -> tuple[str, int, str]:
    """``battery[1].voltage`` as component, instance and name."""
    owner, _, name = label.partition(".")
    component, _, number = owner.partition("[")
    return component, int(number.rstrip("]") or 0), name


def _paths(system: System, labels: Sequence[str]) -> Iterator[str]:
    for label in labels:
        component, _, name = split_label(label)
        yield f"{component}.{name}"
    yield from (path for path in told_paths(system) if path not in _EVENTS)


def _lines(system: System, path: str) -> Iterator[Line]:
    quantity = system.quantity(path)
    if quantity is None or quantity.kind is not QuantityKind.NUMBER or quantity.elements is not None:
        return
    count, is_told = system.components[quantity.component].instances, path in told_paths(system)
    for instance in range(count):
        number = f"[{instance}]" if instance else ""
        label = f"{quantity.component}{number}.{quantity.name}"
        levels = tuple(levels_of(system, quantity, instance))
        is_whole = not quantity.unit.name and not quantity.storage.is_float and quantity.steps == 1
        yield Line(label, path, instance, quantity.unit.name, quantity.spec.doc, levels, is_told, is_whole)
