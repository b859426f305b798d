"""Groups jobs that are done in the same slot of control: the grid of each begins with the first pass."""

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from heapq import heapreplace
from itertools import count, islice

from codegen.loop.jobs import Job
from codegen.loop.pass_share import jobs_of_a_pass
from codegen.model.program import Program
from codegen.model.system import System

_MOST_PASSES = 4000
"""So many passes are looked at for what falls together; what is due less often is taken to be due so often."""


def slots(jobs: tuple[Job, ...], system: System, program: Program) -> Iterator[tuple[Job, ...]]:
    """Yield what is done in each slot, from the first one on, for ever. In that every job is due.

    A slot has so many jobs at most, in their order; others that are due have their turn in the next one, unless they
    are due again in that.
    """
    for done in _turns(tuple(job.period_us for job in jobs), program.control_us, jobs_of_a_pass(system, program)):
        yield tuple(jobs[index] for index in done)


def _turns(periods_us: tuple[int, ...], control_us: int, most: int) -> Iterator[tuple[int, ...]]:
    """Yield the indexes of what is done in each slot: thousands of these are looked at, and in most nothing is due."""
    due = [(0, index) for index in range(len(periods_us))]  # in which slot each is due next: a heap
    waiting: set[int] = set()
    again = [0] * len(periods_us)  # in which slot each that waits is due once more
    for number in count():
        while due[0][0] == number:
            index = due[0][1]
            period_us = periods_us[index]
            times = number * control_us // period_us
            again[index] = -(-(times + 1) * period_us // control_us)
            heapreplace(due, (again[index], index))
            waiting.add(index)
        done: tuple[int, ...] = ()
        if waiting:
            ordered = enumerate(sorted(waiting))
            done = tuple(index for place, index in ordered if place < most or again[index] <= number + 1)
        waiting.difference_update(done)
        yield done


@lru_cache(maxsize=16)
def _together(
    periods_us: tuple[int, ...], control_us: int, most: int, passes: int
) -> tuple[tuple[tuple[int, ...], int], ...]:
    """Return what is done together in so many slots, and in how many of them: revisions mostly have equal periods."""
    return tuple(Counter(islice(_turns(periods_us, control_us, most), passes)).items())


def slot_kinds(jobs: tuple[Job, ...], system: System, program: Program) -> Iterator[tuple[tuple[Job, ...], Fraction]]:
    """Return what is done together, and how often in a second."""
    passes = min(_MOST_PASSES, -(-max(job.period_us for job in jobs) // program.control_us))
    periods_us = tuple(job.period_us for job in jobs)
    kinds: dict[tuple[str, ...], tuple[Job, ...]] = {}
    found = Counter[tuple[str, ...]]()
    for done, times in _together(periods_us, program.control_us, jobs_of_a_pass(system, program), passes):
        due = tuple(jobs[index] for index in done)
        names = tuple(job.name for job in due)
        kinds[names] = due
        found[names] += times
    for names, times in found.items():
        yield kinds[names], Fraction(times * 1000000, passes * program.control_us)
