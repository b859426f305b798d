"""The turns of sensors: each look for due ones is a job of the main loop."""

from fractions import Fraction
from typing import NamedTuple

from codegen.model.system import System

WATCH_US = 1000000
"""The time from one look for silent sensors, of those that speak by themselves, to the next."""


class Turns(NamedTuple):
    """The turns of sensors: ``every_us`` it looks for due ones, and ``most`` of them have their turn then."""

    every_us: int
    most: int


def turns_of(system: System, pass_us: int) -> Turns:
    """The longest time between two looks, in whole passes of the main loop, in which no sensor is kept waiting.

    One sensor has its turn at a time, so that no pass takes two; but for more turns than there are passes.
    """
    rate = sum(Fraction(1000000, source.polling.period_us) for source in system.polled)
    shortest = min(source.polling.period_us for source in system.polled)
    passes = int(min(Fraction(3, 4) * 1000000 / rate, Fraction(shortest, 2)) / pass_us)
    if passes:
        return Turns(passes * pass_us, 1)
    return Turns(pass_us, int(rate * pass_us * 4 / 3000000) + 1)
