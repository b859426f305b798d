"""The main loop: a control function at a fixed rate, slower jobs after it, and what is left for other tasks.

Everything is due on a grid: the time of a slot follows from the slot before, not from when that one ran, so that no
rate drifts. Nothing here allocates while nothing fails.
"""

import asyncio
from time import sleep_us, ticks_add, ticks_diff, ticks_us

from guard import Guard
from micropython import const

AGAIN = ("again",)  # what a job returns that has more to do
LONGEST_PERIOD_US = (1 << 29) - 1  # ticks_diff() is right for less than half the range of ticks_us()
_WINDOW_US = const(1000000)
_ALL = const(1000)  # jobs
_SPARE = const(16)  # turns that a late pass makes up for, at most


class _Slot:
    """A call that is due every `period_us` microseconds."""

    def __init__(self, period_us, call, name):
        if not 0 < period_us <= LONGEST_PERIOD_US:
            raise ValueError(f"a period is 1 to {LONGEST_PERIOD_US} us")
        self.period_us = period_us
        self.call = call
        self.name = name
        self.due_us = 0
        self.is_failing = False

    def take(self, now_us):
        """Go on to the next time on the grid; return how many slots were missed, -1 while the call is not due."""
        late_us = ticks_diff(now_us, self.due_us)
        if late_us < 0:
            if late_us >= -self.period_us:
                return -1
            # Further ahead than it can be: nobody asked for so long that the ticks went half round.
            self.due_us = ticks_add(now_us, self.period_us)
            return 1
        self.due_us = ticks_add(now_us, self.period_us - late_us % self.period_us)
        return late_us // self.period_us

    def is_stalled(self, late_us, forgiven):
        """Return whether it has had no turn for so long after its time, or fails, unless its name is `forgiven`.

        One whose turns are seldom may have failed only once.
        """
        if ticks_diff(ticks_us(), self.due_us) > late_us:
            return True
        return self.is_failing and self.period_us <= late_us // 2 and self.name not in forgiven


class Scheduler:
    """Runs `control`, a callable without arguments, every `period_us` microseconds, and then the jobs that are due.

    A pass runs `most` jobs, and one more for each slot that was left out: others that are due have their turn in the
    next one, unless they are due again by then, and would lose a turn. So has a job that returns AGAIN, after those
    that wait for their first.

    The first pass starts the grid. Slots that came too late are left out, the phase stays. An exception in control or
    in a job is logged once until that call works again, and everything goes on. One in control is also told to
    `on_fault`, a callable without arguments that never raises.

    `overruns` counts the slots of control that were left out. `load` is the share of the last second that passes
    took, in d%: 0 to 1000; it is found where jobs run. ValueError: a period is not positive, or longer than
    LONGEST_PERIOD_US, nine minutes.
    """

    def __init__(self, period_us, control, log=print, on_fault=None, most=_ALL):
        self.overruns = 0
        self.load = 0
        self._log = log
        self._on_fault = on_fault
        self._most = most
        self._guard = Guard()
        self._control = _Slot(period_us, control, "control")
        self._jobs = []
        self._next_us = 0  # when the first of them is due
        self._begin()

    def every(self, period_us, job, name=None):
        """Run a job too, after control and the jobs before it.

        `name` is what the job is called where it fails.
        """
        slot = _Slot(period_us, job, name or f"job {len(self._jobs) + 1}")
        slot.due_us = self._next_us = self._control.due_us
        self._jobs.append(slot)

    def run_pass(self):
        """Do what is due now, and return the microseconds until the next pass: 0 if that is late already."""
        return self._turn(None)

    def stalled(self, late_us, forgiven):
        """Return the name of a call that is_stalled(), None for none."""
        if self._control.is_stalled(late_us, forgiven):
            return self._control.name
        for index in range(len(self._jobs)):  # in few variables: those of a larger function lie on the heap
            if self._jobs[index].is_stalled(late_us, forgiven):
                return self._jobs[index].name
        return None

    async def run(self):
        """Run passes for ever; other tasks have their turn after each, and all the time that is left."""
        while True:
            wait_us = self._turn(None)
            await asyncio.sleep_ms(wait_us // 1000)
            wait_us = ticks_diff(self._control.due_us, ticks_us())
            if 0 < wait_us < 1000:  # else it woke up early, and the next pass finds nothing to do
                sleep_us(wait_us)

    def _begin(self):
        self._turn = self._passes().send

    def _passes(self):  # noqa: C901, PLR0912, PLR0915  calls are dear
        """Yield the microseconds until the next pass after each, for ever.

        What a generator keeps between passes are variables, which are found at once and need no heap; it catches an
        exception without the heap, too, where a function would put all of its variables there.
        """
        control = self._control
        period_us = control.period_us
        ticks, add, diff = ticks_us, ticks_add, ticks_diff
        jobs = self._jobs
        again = AGAIN
        is_failing = False
        busy_us = 0
        is_adrift = False  # whether jobs seem to lie ahead that are not, after half a round of the ticks
        window_us = self._start()  # when the second began that `load` is measured over
        try:
            while True:
                now_us = ticks()
                due_us = control.due_us
                if 0 <= diff(now_us, due_us) < period_us:
                    control.due_us = due_us = add(due_us, period_us)
                    spare = 0
                else:
                    missed = control.take(now_us)
                    due_us = control.due_us
                    if missed < 0:
                        yield diff(due_us, now_us)
                        continue
                    self.overruns += missed
                    spare = missed if missed < _SPARE else _SPARE
                    is_adrift = True
                    self._next_us = now_us  # perhaps it only seems to lie ahead, after half a round of the ticks
                try:
                    control.call()
                    if is_failing:
                        is_failing = control.is_failing = False
                except Exception as error:
                    is_failing = True
                    self._report(control, error)
                if diff(self._next_us, now_us) <= 0:
                    left = self._most + spare
                    while True:
                        least_us = LONGEST_PERIOD_US
                        last = None
                        for job in jobs:
                            ahead_us = diff(job.due_us, now_us)
                            if ahead_us <= 0 or (is_adrift and ahead_us > job.period_us):
                                if left <= 0 and ahead_us + job.period_us > period_us:
                                    least_us = 0
                                    continue
                                left -= 1
                                if -job.period_us < ahead_us <= 0:
                                    job.due_us = add(job.due_us, job.period_us)
                                else:
                                    job.take(now_us)
                                try:
                                    if job.call() is again:
                                        job.due_us = add(job.due_us, -job.period_us)  # and stays on its grid
                                        last = job
                                    if job.is_failing:
                                        job.is_failing = False
                                except Exception as error:
                                    self._report(job, error)
                                ahead_us = diff(job.due_us, now_us)
                            if ahead_us < least_us:  # noqa: PLR1730  min() takes longer
                                least_us = ahead_us
                        if last is None or not spare:
                            break
                        spare -= 1
                        left = 1
                    if least_us > 0:  # each had its turn
                        is_adrift = False
                    self._next_us = add(now_us, least_us)
                    if last is not None and jobs[-1] is not last:
                        jobs.remove(last)
                        jobs.append(last)
                    end_us = ticks()
                    if not 0 <= diff(end_us, window_us) < _WINDOW_US:
                        self._measure(diff(end_us, window_us), busy_us + diff(end_us, now_us))
                        window_us = end_us
                        busy_us = diff(now_us, end_us)  # the pass up to here is counted
                end_us = ticks()
                busy_us += diff(end_us, now_us)
                end_us = diff(due_us, end_us)
                yield end_us if end_us > 0 else 0
        except BaseException:  # an interrupt, or a restart: who goes on after it begins anew
            self._begin()
            raise

    def _start(self):
        now_us = self._control.due_us = self._next_us = ticks_us()
        for job in self._jobs:
            job.due_us = now_us
        return now_us

    def _report(self, slot, error):
        if not slot.is_failing:
            slot.is_failing = True
            with self._guard:
                self._log(f"error: {slot.name} failed:", type(error).__name__, error)
            if slot is self._control and self._on_fault is not None:
                self._on_fault()

    def _measure(self, window_us, busy_us):
        if window_us > 0:  # otherwise the ticks went half round, and nobody knows how long that was
            self.load = busy_us // (window_us // 1000)
