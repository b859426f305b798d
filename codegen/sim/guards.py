"""The failsafes of a program, as a simulation tells of them: words for their levels, and the thresholds of these."""

from collections.abc import Iterator

from codegen.frozen import dataclass
from codegen.model.program import Failsafe
from codegen.model.system import System
from codegen.model.vehicle import Parameter, Quantity, by_instance

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
        Guard(f"{failsafe.component.name}_failsafes", tuple(word for word, _ in _levels(failsafe)), _watches(failsafe))
        for failsafe in failsafes
    )


def levels_of(system: System, quantity: Quantity, instance: int) -> Iterator[Level]:
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
