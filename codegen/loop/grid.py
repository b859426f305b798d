"""Which jobs are due in the same slot of control: the grid of each begins with the first pass."""

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

from codegen.loop.jobs import Job
from codegen.model.program import Program

_MOST_PASSES = 4000
"""So many passes are looked at for what falls together; what is due less often is taken to be due so often."""


def slot_kinds(jobs: tuple[Job, ...], program: Program) -> Iterator[tuple[tuple[Job, ...], Fraction]]:
    """Return what falls together, and how often in a second. Every job is due in the first pass."""
    passes = min(_MOST_PASSES, -(-max(job.period_us for job in jobs) // program.control_us))
    due: dict[int, int] = {}
    for index, job in enumerate(jobs):
        for now_us in range(0, passes * program.control_us, job.period_us):
            number = -(-now_us // program.control_us)
            due[number] = due.get(number, 0) | 1 << index
    found = Counter(together for number, together in due.items() if number < passes)
    found[0] = passes - found.total()
    for together, count in found.items():
        if count:
            yield (
                tuple(job for index, job in enumerate(jobs) if together >> index & 1),
                Fraction(count * 1000000, passes * program.control_us),
            )
