"""The amount of work in a second, of each part."""

from fractions import Fraction

from codegen.loop.frames import message_work, streamed
from codegen.loop.jobs import Job
from codegen.loop.parts import Part, Work
from codegen.loop.pass_share import jobs_of_a_pass, messages_of_a_pass
from codegen.model.price import default_rate
from codegen.model.program import Program
from codegen.model.system import System

LOOK_HZ = 10
"""The least rate at which streams look whether something is due."""

Rates = dict[Part, Fraction]
"""The number of each part in a second."""


def added(one: Rates, other: Rates) -> Rates:
    """Return the sum of both, part by part."""
    return {part: one.get(part, Fraction(0)) + other.get(part, Fraction(0)) for part in {**one, **other}}


def base_rates(jobs: tuple[Job, ...], system: System, program: Program) -> Rates:
    """Return what there is to do in a second without a message."""
    rates: Rates = {Part.PASS: Fraction(1000000, program.control_us)}
    turns = [Fraction(1000000, job.period_us) for job in jobs]
    looks = min(rates[Part.PASS], sum(turns, Fraction(0)) if jobs_of_a_pass(system, program) == 1 else max(turns))
    rates = added(rates, {Part.JOBS: looks, Part.JOB: looks * len(jobs)})
    for job in jobs:
        rate = Fraction(1000000, job.period_us)
        work = (job.work or Work()) + Work({Part.CALL: 1})
        rates = added(rates, {part: count * rate for part, count in work.items()})
    return rates


def looks_a_second(system: System, program: Program) -> Fraction:
    """Return how often it is looked what streams have to send, over all links: at least so often as one is due."""
    rates = [default_rate(message) for message in streamed(system)]
    return max([Fraction(LOOK_HZ), *rates, sum(rates, Fraction(0)) / messages_of_a_pass(program)]) * len(system.links)


def frame_rates(system: System, program: Program) -> Rates:
    """Return what the messages take that streams send by default, over all links."""
    looks = looks_a_second(system, program)
    rates: Rates = {Part.STREAMS: looks, Part.TABLE: looks * len(system.messages), Part.ENDING: looks}
    for message in streamed(system):
        rate = default_rate(message) * len(system.links)
        rates = added(rates, {part: count * rate for part, count in message_work(message, system).items()})
    return rates
