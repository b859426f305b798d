"""Which jobs are done in the same slot of control: the grid of each begins with the first pass."""

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from itertools import islice

from codegen.loop.jobs import Job
from codegen.loop.pass_share import jobs_of_a_pass
from codegen.model.program import Program
from codegen.model.system import System

_MOST_PASSES = 4000
"""So many passes are looked at for what falls together; what is due less often is taken to be due so often."""


def slots(jobs: tuple[Job, ...], system: System, program: Program) -> Iterator[tuple[Job, ...]]:
    """Yield what is done in each slot, from the first one on, for ever. In that every job is due.

    A slot has so many jobs at most, in their order; others that are due have their turn in the next one.
    """
    most = jobs_of_a_pass(system, program)
    waiting: set[int] = set()
    number = 0
    while True:
        now_us = number * program.control_us
        waiting |= {
            index
            for index, job in enumerate(jobs)
            if number == 0 or now_us // job.period_us > (now_us - program.control_us) // job.period_us
        }
        done = sorted(waiting)[:most]
        waiting -= set(done)
        number += 1
        yield tuple(jobs[index] for index in done)


def slot_kinds(jobs: tuple[Job, ...], system: System, program: Program) -> Iterator[tuple[tuple[Job, ...], Fraction]]:
    """Return what is done together, and how often in a second."""
    passes = min(_MOST_PASSES, -(-max(job.period_us for job in jobs) // program.control_us))
    kinds: dict[tuple[str, ...], tuple[Job, ...]] = {}
    found = Counter[tuple[str, ...]]()
    for due in islice(slots(jobs, system, program), passes):
        names = tuple(job.name for job in due)
        kinds[names] = due
        found[names] += 1
    for names, count in found.items():
        yield kinds[names], Fraction(count * 1000000, passes * program.control_us)
