"""The failsafes of a program, as a simulation tells of them: words for their levels, and the thresholds of these."""

from collections.abc import Iterator

from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.model.vehicle import Quantity, by_instance

SEVERE, MILD = "critical", "low"
"""Classes of the lines of levels in a chart: that of the highest level, and that of all others."""


@dataclass(frozen=True, slots=True)
class Level:
    """A level of a failsafe: what it is called, the parameter with its threshold, and the class of its line."""

    word: str
    parameter: str
    style: str


@dataclass(frozen=True, slots=True)
class Guard:
    """A failsafe by the attribute of the vehicle that has it: the words for its levels, from 1, and what it watches."""

    attribute: str
    words: tuple[str, ...]
    path: str


def guards(system: System) -> tuple[Guard, ...]:
    """The failsafes of a program."""
    failsafes = system.program.failsafes if system.program else ()
    return tuple(
        Guard(
            f"{failsafe.name}_failsafes",
            tuple(level.name for level in failsafe.levels),
            failsafe.quantity.path if failsafe.quantity else "",
        )
        for failsafe in failsafes
    )


def levels_of(system: System, quantity: Quantity, instance: int) -> Iterator[Level]:
    """The levels of the failsafes that compare a quantity with parameters, with those of an instance."""
    count = system.components[quantity.component].instances
    for failsafe in system.program.failsafes if system.program else ():
        for level in failsafe.levels:
            for condition in level.conditions:
                threshold = condition.limit.parameter if condition.limit else None
                if condition.quantity is quantity and threshold is not None:
                    parameter = by_instance(threshold, system.parameters, count)[instance]
                    yield Level(level.name, parameter.name, SEVERE if level is failsafe.levels[-1] else MILD)
