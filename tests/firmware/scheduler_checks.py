"""Rates are exact, late slots are counted, failures are survived, and nothing is allocated, on the virtual clock."""

import mock_time

mock_time.install()

import mock_asyncio  # noqa: E402  the clock comes first

mock_asyncio.install()

import asyncio  # noqa: E402

import machine  # noqa: E402
from checks import allocated, run  # noqa: E402
from scheduler import LONGEST_PERIOD_US, Scheduler  # noqa: E402

SECOND = 1000000
WRAP = 1 << 30


class Count:
    """Counts calls, may take time, and may fail."""

    def __init__(self, takes_us=0):
        self.calls = 0
        self.takes_us = takes_us
        self.error = None

    def __call__(self):
        return self.count()

    def count(self):
        self.calls += 1
        if self.takes_us:
            mock_time.advance_us(self.takes_us)
        if self.error is not None:
            raise self.error


class Log:
    """Keeps what was logged."""

    def __init__(self):
        self.lines = []

    def __call__(self, *words):
        self.lines.append(" ".join([str(word) for word in words]))


def fresh(start_us=0, control_us=0, job_us=0):
    """Return a scheduler of 400 Hz with a job of 10 Hz, both calls, and the log."""
    mock_time.set_ticks_us(start_us)
    control, job, log = Count(control_us), Count(job_us), Log()
    scheduler = Scheduler(2500, control.count, log)
    scheduler.every(100000, job.count)
    return scheduler, control, job, log


def run_until(scheduler, end_us):
    """Run passes, each when the one before said, up to a time that does not belong to it any more."""
    while mock_time.elapsed_us() < end_us:
        mock_time.advance_us(scheduler.run_pass())


def rates_are_exact():
    scheduler, control, job, _ = fresh()
    run_until(scheduler, 90 * SECOND)
    assert (control.calls, job.calls, scheduler.overruns) == (90 * 400, 90 * 10, 0), (control.calls, job.calls)


def work_does_not_slow_the_rates():
    for control_us, job_us in ((1, 1), (999, 1400), (2400, 0), (2499, 1)):
        scheduler, control, job, _ = fresh(0, control_us, job_us)
        run_until(scheduler, 20 * SECOND)
        counted = (control.calls, job.calls, scheduler.overruns)
        assert counted == (20 * 400, 20 * 10, 0), counted


def wrap_of_the_ticks_is_nothing_special():
    for before in (0, 1, 1250, 2499, 2500, 99999, 5 * SECOND):
        start = WRAP - before
        scheduler, control, job, _ = fresh(start, 100)
        run_until(scheduler, start + 10 * SECOND)
        assert (control.calls, job.calls, scheduler.overruns) == (4000, 100, 0), (before, control.calls)


def a_day_is_exact():
    """Slow periods, for they take the same arithmetic; 80 wraps."""
    mock_time.set_ticks_us(12345)
    control, job, other = Count(), Count(7), Count()
    scheduler = Scheduler(2 * SECOND, control)
    scheduler.every(30 * SECOND, job)
    scheduler.every(7 * SECOND, other)  # on no grid of control: it runs in the first pass after it is due
    run_until(scheduler, 12345 + 86400 * SECOND)
    counted = (control.calls, job.calls, other.calls, scheduler.overruns)
    assert counted == (43200, 2880, 86400 // 7 + 1, 0), counted


def a_day_of_late_passes_is_exact():
    """Of all the slots of a day at 400 Hz each is run or counted as missed."""
    scheduler, control, _, _ = fresh()
    delays = (0, 1, 2499, 2500, 2501, 70000, 99999, 400000, SECOND + 1, 17 * SECOND)
    passes = 0
    while mock_time.elapsed_us() < 86400 * SECOND:
        mock_time.advance_us(scheduler.run_pass() + delays[passes % len(delays)])
        passes += 1
    run_until(scheduler, mock_time.elapsed_us() + 1)  # to when the next one is due
    slots = mock_time.elapsed_us() // 2500  # the one at this very time has not been run
    assert control.calls + scheduler.overruns == slots, (control.calls, scheduler.overruns, slots)


def phase_is_kept():
    scheduler, control, _, _ = fresh(1000)
    assert scheduler.run_pass() == 2500
    mock_time.advance_us(2499)
    assert scheduler.run_pass() == 1
    assert control.calls == 1
    mock_time.advance_us(2501)  # exactly one slot is missed, and this one is due
    assert scheduler.run_pass() == 2500
    assert (control.calls, scheduler.overruns) == (2, 1)
    mock_time.advance_us(2500 + 7600)  # three more
    assert scheduler.run_pass() == 2400
    assert (control.calls, scheduler.overruns) == (3, 4)
    control.takes_us = 6000
    mock_time.advance_us(2400)
    assert scheduler.run_pass() == 0  # late already
    control.takes_us = 0
    assert scheduler.run_pass() == 1500
    assert (control.calls, scheduler.overruns) == (5, 5)


def late_job_sends_no_burst():
    scheduler, _, job, _ = fresh()
    scheduler.run_pass()
    mock_time.advance_us(350000)
    scheduler.run_pass()
    assert job.calls == 2
    run_until(scheduler, 400000)
    assert job.calls == 2
    run_until(scheduler, 400001)
    assert job.calls == 3


def order_is_control_and_then_the_jobs():
    order = []
    mock_time.set_ticks_us(77)
    scheduler = Scheduler(2500, lambda: order.append("control"))
    scheduler.every(5000, lambda: order.append("battery"))
    scheduler.every(5000, lambda: order.append("failsafe"))
    scheduler.every(10000, lambda: order.append("slow"))
    run_until(scheduler, 77 + 10000)
    expected = "control battery failsafe slow control control battery failsafe control"
    assert " ".join(order) == expected, order


def what_is_due_in_each_pass_loses_no_turn():
    """However many jobs before it are due together, and however few a pass has; others wait in their order."""
    for most in (1, 2, 3, 4):
        order = []
        add = order.append
        mock_time.set_ticks_us(77)
        scheduler = Scheduler(2500, lambda: None, most=most)
        for name in "abcd":
            scheduler.every(25000, lambda name=name, add=add: add(name))
        links = Count()
        scheduler.every(2500, links)
        scheduler.every(5000, lambda add=add: add("f"))
        run_until(scheduler, 77 + SECOND)
        assert links.calls == 400, (most, links.calls)
        assert [order.count(name) for name in "abcdf"] == [40, 40, 40, 40, 200], (most, order)
        assert "".join(name for name in order if name != "f") == "abcd" * 40, most


def job_can_come_later():
    scheduler, _, job, _ = fresh()
    run_until(scheduler, 60000)
    late = Count()
    scheduler.every(100000, late)
    run_until(scheduler, 950000)
    assert (job.calls, late.calls) == (10, 9)  # at 60000, 160000, ...


def pause_of_any_length_is_survived():
    """Up to half a wrap slots are counted. After more nobody knows how many there were, but it goes on at once."""
    for pause in (WRAP // 2 - 2501, WRAP // 2, WRAP // 2 + 5000, WRAP - 1, WRAP, 3 * WRAP + 17, 5 * WRAP // 2):
        scheduler, control, job, _ = fresh(3, 2000)
        run_until(scheduler, 3 + 2 * SECOND)
        assert scheduler.load == 800
        before, jobs = control.calls, job.calls
        mock_time.advance_us(pause)
        control.takes_us = 0
        now = mock_time.elapsed_us()
        scheduler.run_pass()
        if WRAP // 2 <= pause % WRAP < WRAP - 2500:
            assert control.calls == before + 1, pause
        assert 0 <= scheduler.load <= 1000, (pause, scheduler.load)
        run_until(scheduler, now + SECOND)
        assert scheduler.load <= 800, (pause, scheduler.load)
        run_until(scheduler, now + 2 * SECOND)
        assert 0 <= scheduler.load <= 1
        run_until(scheduler, now + 3 * SECOND)
        assert scheduler.load == 0
        assert 1199 <= control.calls - before <= 1201, (pause, control.calls - before)
        assert 29 <= job.calls - jobs <= 31, (pause, job.calls - jobs)
    scheduler, control, _, _ = fresh()
    scheduler.run_pass()
    mock_time.advance_us(500 * SECOND)
    scheduler.run_pass()
    assert scheduler.overruns == 500 * 400 - 1


def load_is_measured():
    for control_us, expected in ((0, 0), (250, 100), (1250, 500), (2499, 999)):
        scheduler, _, _, _ = fresh(WRAP - 3 * SECOND // 2, control_us)
        run_until(scheduler, WRAP)
        assert abs(scheduler.load - expected) <= 1, (control_us, scheduler.load)
    scheduler, control, _, _ = fresh(0, 60 * SECOND)
    scheduler.run_pass()
    assert scheduler.load == 1000
    control.takes_us = 0
    run_until(scheduler, 63 * SECOND)
    assert scheduler.load == 0


def failures_are_logged_once_and_survived():
    scheduler, control, job, log = fresh()
    other = Count()
    scheduler.every(2500, other, "the other one")
    scheduler.run_pass()
    assert log.lines == []
    control.error = ValueError("no lift")
    run_until(scheduler, SECOND)
    assert (control.calls, job.calls, other.calls) == (400, 10, 400)
    assert log.lines == ["error: control failed: ValueError no lift"], log.lines
    control.error = None
    job.error = OSError(5)
    run_until(scheduler, 2 * SECOND)
    control.error = ZeroDivisionError("again")
    other.error = KeyError("speed")
    run_until(scheduler, 3 * SECOND)
    assert len(log.lines) == 4, log.lines
    assert log.lines[1].startswith("error: job 1 failed: OSError"), log.lines
    assert log.lines[2] == "error: control failed: ZeroDivisionError again"
    assert log.lines[3].startswith("error: the other one failed: KeyError")
    assert (control.calls, job.calls, other.calls) == (1200, 30, 1200)


def faults_of_control_are_told():
    """Once until it works again, and nobody is told of those of jobs."""
    mock_time.set_ticks_us(0)
    told = Count()
    control, job = Count(), Count()
    scheduler = Scheduler(2500, control, Log(), told)
    scheduler.every(100000, job)
    job.error = OSError(5)
    for times in (1, 2):
        control.error = ValueError("no lift")
        run_until(scheduler, (2 * times - 1) * SECOND)
        assert told.calls == times, told.calls
        control.error = None
        run_until(scheduler, 2 * times * SECOND)
        assert told.calls == times, told.calls


def what_stands_still_is_found():
    """A job that is too late, or fails, is found; not one that may fail, nor one that is too rare to be sure."""
    scheduler, _, job, _ = fresh()
    scheduler.every(1500000, job.count, "seldom")
    scheduler.run_pass()
    assert scheduler.stalled(SECOND, ()) is None
    mock_time.advance_us(SECOND + 2500)
    assert scheduler.stalled(SECOND, ()) is None
    mock_time.advance_us(1)
    assert scheduler.stalled(SECOND, ()) == "control"
    scheduler._control.due_us = mock_time.ticks_us()
    mock_time.advance_us(100000)
    assert scheduler.stalled(SECOND, ()) == "job 1"
    scheduler.run_pass()
    assert scheduler.stalled(SECOND, ()) is None
    job.error = OSError(5)
    run_until(scheduler, 4 * SECOND)
    assert scheduler.stalled(SECOND, ()) == "job 1"
    assert scheduler.stalled(SECOND, ("job 1",)) is None
    assert scheduler.stalled(3 * SECOND, ("job 1",)) == "seldom"
    job.error = None
    assert allocated(lambda: scheduler.stalled(SECOND, ("job 1",))) == 0


def broken_log_is_survived():
    def broken(*_words):
        raise OSError(5)

    mock_time.set_ticks_us(0)
    control = Count()
    control.error = ValueError("no")
    scheduler = Scheduler(2500, control, broken)
    run_until(scheduler, SECOND)
    assert control.calls == 400


def reset_is_not_held_up():
    scheduler, _, _, log = fresh()
    scheduler.every(2500, machine.reset)
    try:
        scheduler.run_pass()
    except machine.Reset:
        assert log.lines == []
        return
    raise AssertionError("a reset is a reset")


def periods_have_limits():
    for period in (0, -1, LONGEST_PERIOD_US + 1):
        try:
            Scheduler(period, Count())
        except ValueError:
            continue
        raise AssertionError(period)
    mock_time.set_ticks_us(5)
    control, job = Count(), Count()
    scheduler = Scheduler(SECOND, control)
    scheduler.every(LONGEST_PERIOD_US, job)
    run_until(scheduler, 5 + 3 * LONGEST_PERIOD_US)
    assert (control.calls, job.calls) == (1611, 3), (control.calls, job.calls)


def nothing_is_allocated():
    scheduler, control, job, _ = fresh(WRAP - 200000)

    def passes():
        scheduler.run_pass()
        mock_time.advance_us(1000)

    assert allocated(passes) == 0
    assert control.calls > 400
    assert job.calls > 10

    def late_passes():
        scheduler.run_pass()
        mock_time.advance_us(12345678)

    assert allocated(late_passes) == 0
    assert scheduler.overruns > 400


def other_tasks_have_their_turn():
    """In run() control keeps its rate, on the virtual clock of asyncio, and a task beside it wakes up in time."""
    scheduler, control, job, _ = fresh(WRAP - SECOND + 123, 300)
    turns = []

    async def beside():
        for _ in range(200):
            await asyncio.sleep_ms(10)
            turns.append(mock_time.elapsed_us())

    async def main():
        task = asyncio.create_task(scheduler.run())
        await beside()
        task.cancel()

    asyncio.run(main())
    assert len(turns) == 200
    assert 800 <= control.calls <= 802 + 200, control.calls
    assert scheduler.overruns == 0, scheduler.overruns
    slots = (mock_time.elapsed_us() - (WRAP - SECOND + 123)) // 2500
    assert abs(control.calls - slots) <= 1, (control.calls, slots)
    assert abs(job.calls - slots // 40) <= 1
    late = [turns[number + 1] - turns[number] for number in range(199)]
    assert max(late) <= 10000 + 2500, max(late)


def busy_control_leaves_turns():
    """Passes that are late all the time still let others run."""
    scheduler, _, _, _ = fresh(0, 3000)
    turns = []

    async def main():
        task = asyncio.create_task(scheduler.run())
        for _ in range(50):
            await asyncio.sleep_ms(0)
            turns.append(scheduler.overruns)
        task.cancel()

    asyncio.run(main())
    assert turns[-1] > 5, turns


run(
    rates_are_exact,
    work_does_not_slow_the_rates,
    wrap_of_the_ticks_is_nothing_special,
    a_day_is_exact,
    a_day_of_late_passes_is_exact,
    phase_is_kept,
    late_job_sends_no_burst,
    order_is_control_and_then_the_jobs,
    what_is_due_in_each_pass_loses_no_turn,
    job_can_come_later,
    pause_of_any_length_is_survived,
    load_is_measured,
    failures_are_logged_once_and_survived,
    faults_of_control_are_told,
    what_stands_still_is_found,
    broken_log_is_survived,
    reset_is_not_held_up,
    periods_have_limits,
    nothing_is_allocated,
    other_tasks_have_their_turn,
    busy_control_leaves_turns,
)
