"""The time that the main loop leaves to the user's code in each slot of control, and its load of a board."""

from fractions import Fraction
from typing import NamedTuple

from codegen.frozen import dataclass
from codegen.loop.costs import Costs, measured_costs
from codegen.loop.frames import busiest_works, due_work, heard_work
from codegen.loop.grid import slot_kinds
from codegen.loop.jobs import LINKS, Job, loop_jobs
from codegen.loop.parts import Part, Work
from codegen.loop.rates import Rates, added, base_rates, frame_rates
from codegen.model.board_model import Timing
from codegen.model.system import System
from codegen.once import once


@dataclass(frozen=True, slots=True)
class Took:
    """The duration of some work: instructions counted on x86-64, and microseconds on the board, likely and at most.

    These are None where nobody knows how fast the board is.
    """

    instructions: int
    likely_us: Fraction | None
    most_us: Fraction | None


@dataclass(frozen=True, slots=True)
class Slot:
    """One kind of slot of control: the jobs that are ``due`` in it, and how often it comes in a second.

    ``quiet`` is what it takes while no message is due, ``busy`` with all messages due that streams send by default, as
    far as a pass sends them, and ``most`` with everything switched on, and messages that arrive where they take longer.
    Where links are not served all are the same, but for what is switched on.
    """

    due: tuple[Job, ...]
    rate: Fraction
    quiet: Took
    busy: Took
    most: Took
    work: Work

    @property
    def words(self) -> str:
        """The names of what is done in it."""
        return " + ".join(job.name for job in self.due) or "control alone"

    @property
    def serves(self) -> bool:
        """Return whether links are served."""
        return any(job.name == LINKS for job in self.due)


@dataclass(frozen=True, slots=True)
class LoopBudget:
    """The budget of a program: ``slots``, the shortest first, and the load of the board without the user's code.

    ``station`` is what each further station takes where its link has something to do, ``heard`` what a message
    takes that arrives. ``base`` is the load in instructions a second without frames, ``load`` that with the frames that
    streams send by default.
    """

    control_us: int
    timing: Timing | None
    jobs: tuple[Job, ...]
    slots: tuple[Slot, ...]
    station: Took
    heard: Took
    base: Took
    load: Took
    costs: Costs

    @property
    def longest(self) -> Slot:
        """The slot that takes longest with what is there by default."""
        return max(self.slots, key=lambda slot: slot.busy.instructions)

    def took(self, work: Work) -> Took:
        """Return how long some work takes."""
        return _took(work, self.costs, self.timing)

    def left_us(self, took: Took) -> tuple[Fraction, Fraction] | None:
        """Return what is left of a slot, likely and at least: below 0 where it takes longer. None: nobody knows."""
        if took.likely_us is None or took.most_us is None:
            return None
        return self.control_us - took.likely_us, self.control_us - took.most_us


def why_not_predicted(system: System) -> str:
    """Return why no time is predicted, or an empty text."""
    if system.program is None:
        return "there is no program: vehicle.yaml is missing"
    if not system.spec.project.machine_code:
        return "it was measured with machine code only, and machine_code is false"
    if system.board is None:
        return "no board is named"
    if system.board.timing is None:
        return f"nobody has measured how many cycles the {system.board.spec.mcu} takes for what the firmware does"
    return ""


@once
def loop_budget(system: System) -> LoopBudget | None:
    """Return the budget; None without a program, and where it is plain Python, which was not measured."""
    program = system.program
    if program is None or not system.spec.project.machine_code:
        return None
    costs = measured_costs()
    timing = system.board.timing if system.board else None
    jobs = loop_jobs(system, program)
    most = max(busiest_works(system, program), key=costs.instructions)
    around = _Around(jobs, due_work(system, program), most, costs, timing)
    slots = [_slot(due, rate, around) for due, rate in slot_kinds(jobs, system, program)]
    base = base_rates(jobs, system, program)
    return LoopBudget(
        program.control_us,
        timing,
        jobs,
        tuple(sorted(slots, key=lambda slot: slot.busy.instructions)),
        around.took(Work({Part.STATION: 1})),
        around.took(heard_work(program)),
        _a_second(base, costs, timing),
        _a_second(added(base, frame_rates(system, program)), costs, timing),
        costs,
    )


class _Around(NamedTuple):
    """The common data of slots: all jobs, the work of a link with all messages due and at most, costs, the board."""

    jobs: tuple[Job, ...]
    due: Work
    most: Work
    costs: Costs
    timing: Timing | None

    def took(self, work: Work) -> Took:
        return _took(work, self.costs, self.timing)


def _slot(due: tuple[Job, ...], rate: Fraction, around: _Around) -> Slot:
    looked = Work({Part.JOBS: 1, Part.JOB: len(around.jobs), Part.CALL: len(due)}) if due else Work()
    work = most = looked + Work({Part.PASS: 1})
    for job in due:
        work = work + (job.work or Work())
        most = most + (job.most or Work())
    busy = work + _times(around.due, work[Part.LINK])
    most = most + _times(around.most, most[Part.LINK])
    return Slot(due, rate, around.took(work), around.took(busy), around.took(most), busy)


def _times(work: Work, count: int) -> Work:
    return Work({part: amount * count for part, amount in work.items()})


def _took(work: Work, costs: Costs, timing: Timing | None) -> Took:
    instructions = costs.instructions(work)
    if timing is None:
        return Took(instructions, None, None)
    conversions_us = work[Part.CONVERSION] * timing.conversion_us
    likely, most = (instructions * cycles / timing.megahertz for cycles in (timing.cycles, timing.most_cycles))
    return Took(instructions, likely + conversions_us, most + conversions_us)


def _a_second(rates: Rates, costs: Costs, timing: Timing | None) -> Took:
    """Return how long so many parts take that there are in a second."""
    rounded = Work({part: round(rate * 1000) for part, rate in rates.items()})
    whole = _took(rounded, costs, timing)
    if whole.likely_us is None or whole.most_us is None:
        return Took(whole.instructions // 1000, None, None)
    return Took(whole.instructions // 1000, whole.likely_us / 1000, whole.most_us / 1000)
