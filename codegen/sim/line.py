"""The quantities that a simulation draws and compares, and the failsafes that it tells of."""

from collections.abc import Iterator, Sequence

from codegen.frozen import dataclass
from codegen.model.program import Failsafe
from codegen.model.scenario import Expectation, Scenario
from codegen.model.system import System
from codegen.model.vehicle import Parameter, Quantity, QuantityKind, by_instance
from codegen.sim.told import told_paths

SEVERE, MILD = "critical", "low"
"""Classes of the lines of levels in a chart: that of the highest level, and that of all others."""
_STATE = ("armed", "status", "mode")
"""Quantities of the vehicle that are watched where there are any."""
_EVENTS = tuple(f"vehicle.{name}" for name in _STATE)
"""The same: their changes are events."""


@dataclass(frozen=True, slots=True)
class Level:
    """A level of a failsafe: what it is called, the parameter with its threshold, and the class of its line."""

    word: str
    parameter: str
    style: str


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
    """A quantity that the simulation looks at in the state, by its label."""

    label: str
    component: str
    instance: int
    name: str


@dataclass(frozen=True, slots=True)
class Guard:
    """A failsafe by the attribute of the vehicle that has it: the words for its levels, from 1, and what it watches."""

    attribute: str
    words: tuple[str, ...]
    path: str


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
        found.append(Watched(label, component, instance, name))
    return tuple(dict.fromkeys(found))


def split_label(label: str) -> tuple[str, int, str]:
    """``battery[1].voltage`` as component, instance and name."""
    owner, _, name = label.partition(".")
    component, _, number = owner.partition("[")
    return component, int(number.rstrip("]") or 0), name


def guards(system: System) -> tuple[Guard, ...]:
    """The failsafes of a program."""
    failsafes = system.program.failsafes if system.program else ()
    return tuple(
        Guard(f"{failsafe.component.name}_failsafes", tuple(word for word, _ in _levels(failsafe)), _watches(failsafe))
        for failsafe in failsafes
    )


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
        levels = tuple(_drawn(system, quantity, instance))
        is_whole = not quantity.unit.name and not quantity.storage.is_float and quantity.steps == 1
        yield Line(label, path, instance, quantity.unit.name, quantity.spec.doc, levels, is_told, is_whole)


def _drawn(system: System, quantity: Quantity, instance: int) -> Iterator[Level]:
    """The levels of the failsafes that watch a quantity, with the parameters of an instance."""
    count = system.components[quantity.component].instances
    for failsafe in system.program.failsafes if system.program else ():
        if _watches(failsafe) == quantity.path:
            levels = list(_levels(failsafe))
            for number, (word, threshold) in enumerate(levels, 1):
                parameter = by_instance(threshold, system.parameters, count)[instance]
                yield Level(word, parameter.name, SEVERE if number == len(levels) else MILD)


def _watches(failsafe: Failsafe) -> str:
    return failsafe.quantity.path


def _levels(failsafe: Failsafe) -> Iterator[tuple[str, Parameter]]:
    """The levels in the order of their numbers, each with the parameter that has its threshold."""
    yield "low", failsafe.low.below
    yield "critical", failsafe.critical.below
