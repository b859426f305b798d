"""The share of a pass of the main loop, small enough to leave room for the user's code: by design, not by a clock."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.model.program import Program
from codegen.model.sensor_turns import WATCH_US, turns_of
from codegen.model.system import System

REMINDER_US = 1000000
"""The time from one look for texts that are to be said again to the next."""
_SHORT_US = 2500
"""In a slot so short a pass takes in or sends one message, and two more for each further one of these that it lasts."""
_MOST_MESSAGES = 8


def messages_of_a_pass(program: Program) -> int:
    """Return how many messages a link takes in or sends in a pass."""
    return min(max(2 * program.control_us // _SHORT_US - 1, 1), _MOST_MESSAGES)


def jobs_of_a_pass(system: System, program: Program) -> int:
    """Return how many jobs a pass runs: as few as leave half of the turns free, so that none has to wait for long."""
    rate = sum(Fraction(program.control_us, period_us) for period_us in _periods(system, program))
    return -(-2 * rate // 1)


def parts_links(system: System, program: Program) -> bool:
    """Return whether links have their turns one by one."""
    return len(system.links) > 1 and jobs_of_a_pass(system, program) == 1


def _periods(system: System, program: Program) -> Iterator[int]:
    """Yield the period of each turn that there is in the main loop, in us."""
    if program.measure_us:
        yield program.measure_us
    if system.polled:
        yield turns_of(system, program.control_us).every_us
        yield WATCH_US
    measured = [component for component in system.components.values() if component.readings]
    yield from (component.read_every_ms * 1000 for component in measured)
    yield program.checks_us
    yield from [program.links_us] * max(len(system.links), 1)
    yield from (program.report_ms * 1000, REMINDER_US)
