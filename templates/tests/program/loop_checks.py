"""The main loop: its grid, its order, and what is missed."""

from program_bench import (
    SECOND_US,
    TURN_MS_US,
    TURN_US,
    main,
    mock_time,
    needs,
    new_craft,
    ready_craft,
    run,
)
from program_facts import (
    ARMING_US,
    CHECKS_US,
    CONTROL_US,
    FAILSAFES,
    FORCE_ARM,
    FORGETS,
    JOBS,
    JOBS_OF_A_PASS,
    LINKS_US,
    MEASURED,
    REPORT_MS,
)

from scheduler import Scheduler


def _timed(craft):
    """Let control() note when it runs."""
    times = []
    craft.scheduler._control.call = lambda: times.append(mock_time.elapsed_us())
    return times


def control_keeps_its_grid():
    """Exact multiples of the period, without drift, also where either counter of ticks starts again."""
    for start_us in (0, TURN_US - SECOND_US, TURN_MS_US - SECOND_US):
        craft = new_craft(at_us=start_us)
        times = _timed(craft)
        run(craft, 2 * SECOND_US)
        slots = -(-2 * SECOND_US // CONTROL_US)
        assert times == [start_us + slot * CONTROL_US for slot in range(slots)], (start_us, len(times), slots)
        assert craft.scheduler.overruns == 0


def jobs_are_due_as_stated():
    """Jobs of the main loop beside control() are due as often as the specification says, in its order."""
    craft = new_craft()
    jobs = craft.scheduler._jobs
    assert [(job.period_us, job.name) for job in jobs] == list(JOBS)
    assert craft.scheduler._most == JOBS_OF_A_PASS
    counts = [0] * len(jobs)
    for place, job in enumerate(list(jobs)):

        def counted(place=place, call=job.call):
            counts[place] += 1
            return call()

        job.call = counted
    run(craft, SECOND_US)
    for count, (period_us, name) in zip(counts, JOBS):  # noqa: B905  MicroPython cannot
        if name != "links":  # which go on where something is left
            assert abs(count - SECOND_US / period_us) <= 1, (name, count)


def jitter_is_no_drift():
    """Passes that wake up late, each by another time below a period, stay on the grid."""
    craft = new_craft()
    times = _timed(craft)
    for late in range(2000):
        mock_time.advance_us(craft.run_pass() + late * 7 % CONTROL_US)
    assert craft.scheduler.overruns == 0
    for slot, at_us in enumerate(times):
        assert 0 <= at_us - slot * CONTROL_US < CONTROL_US, (slot, at_us)


def order_within_a_pass():
    """Control, then reading, failsafe and arming checks in the same pass; the links soon; readings in their period."""
    needs(MEASURED, "something that is measured")
    craft = ready_craft()
    jobs = len(craft.scheduler._jobs)
    waiting = 0 if craft.scheduler._most >= jobs else jobs  # slots that one may have to wait for its turn
    order = []

    def noted(name, call, owner, attribute):
        def instead(*arguments):
            order.append((mock_time.elapsed_us(), name))
            return call(*arguments)

        setattr(owner, attribute, instead)

    noted("control", craft.control, craft.scheduler._control, "call")
    for measured in MEASURED:
        name = measured["component"]
        noted(name, getattr(craft.state, "update_" + name), craft.state, "update_" + name)
    for facts in FAILSAFES:
        failsafe = getattr(craft, facts["list"])[0]
        noted("failsafe", failsafe.update, failsafe, "update")
    if FORCE_ARM is not None:
        noted("arming", craft.check_arming, craft, "check_arming")
    noted("links", craft.connections[0].run, craft.connections[0], "run")
    run(craft, SECOND_US)
    often = [each["component"] for each in MEASURED if each["period_us"] <= CHECKS_US]
    for facts in [each for each in FAILSAFES if each["component"] in often]:
        at_us = next(at_us for at_us, name in order if name == facts["component"])
        found = [name for other_us, name in order if other_us == at_us]
        assert found[0] == "control", found
        assert found.index(facts["component"]) < found.index("failsafe") < found.index("arming"), found
    for measured in MEASURED:
        times = [at_us for at_us, name in order if name == measured["component"]]
        period = measured["period_us"]
        due = [-(-slot * period // CONTROL_US) * CONTROL_US for slot in range(-(-SECOND_US // period))]
        late = [(at_us - due_us) // CONTROL_US for at_us, due_us in zip(times, due)]  # noqa: B905  MicroPython cannot
        assert len(times) == len(due), times
        assert all([0 <= slots <= waiting for slots in late]), times  # noqa: C419  as above
    arming = [at_us for at_us, name in order if name == "arming"]
    assert len(arming) == (0 if FORCE_ARM is None else -(-SECOND_US // ARMING_US)), arming
    assert len([name for _, name in order if name == "control"]) == -(-SECOND_US // CONTROL_US)
    served = [at_us for at_us, name in order if name == "links"]
    assert served[0] <= waiting * CONTROL_US, served[0]
    assert len(served) >= SECOND_US // LINKS_US, len(served)


def missed_slots():
    """Passes of scripted durations: what is missed is counted, the next pass belongs to the newest slot, no burst."""
    tenths = CONTROL_US // 10
    for duration, next_us, missed, after in (
        (2 * tenths, CONTROL_US, 0, 2),
        (CONTROL_US, CONTROL_US, 0, 2),
        (CONTROL_US + tenths, CONTROL_US + tenths, 0, 2),
        (2 * CONTROL_US + tenths, 2 * CONTROL_US + tenths, 1, 3),
        (3 * CONTROL_US - tenths, 3 * CONTROL_US - tenths, 1, 3),
        (5 * CONTROL_US, 5 * CONTROL_US, 4, 6),
    ):
        craft = new_craft()
        times = []
        durations = [duration]

        def control(times=times, durations=durations):
            times.append(mock_time.elapsed_us())
            mock_time.advance_us(durations.pop() if durations else 0)

        craft.scheduler._control.call = control
        for _ in range(3):
            mock_time.advance_us(craft.run_pass())
        assert times == [0, next_us, after * CONTROL_US], (duration, times)
        assert craft.scheduler.overruns == missed, (duration, craft.scheduler.overruns)


def late_by_whole_periods():
    """A call that comes late by whole periods, or by nearly so many, has one turn, and the next one on its grid."""
    period_us = 2 * CONTROL_US
    for late_us in (0, 1, CONTROL_US, period_us - 1, period_us, period_us + 1, 3 * period_us - 1, 3 * period_us):
        turns = []
        loop = Scheduler(CONTROL_US, lambda: turns.append("control"))  # noqa: B023  it is asked in this turn alone
        loop.every(period_us, lambda: turns.append("job"))  # noqa: B023
        loop.run_pass()
        mock_time.advance_us(period_us + late_us)
        del turns[:]
        wait_us = loop.run_pass()
        assert turns == ["control", "job"], (late_us, turns)
        assert loop.overruns == late_us // CONTROL_US + 1, (late_us, loop.overruns)
        assert wait_us == CONTROL_US - late_us % CONTROL_US, (late_us, wait_us)
        mock_time.advance_us(wait_us - 1)
        assert loop.run_pass() == 1, late_us
        mock_time.advance_us(1)
        loop.run_pass()
        is_due = wait_us == period_us - late_us % period_us
        assert turns == ["control", "job", "control", "job"][: 4 if is_due else 3], (late_us, turns)


def turns_of_a_pass():
    """So many jobs have their turn in a pass, in their order, and one more for each slot that came too late.

    Each is due on a grid of its own, and what waited has its turn in the next pass. What would be due again by then has
    its turn at once: where there is room for fewer than are due, no turn is lost but those of slots that are over.
    """
    lot = 7
    for most in (1, 2, 3, 1000):
        turns = []
        loop = Scheduler(CONTROL_US, lambda: turns.append(-1), most=most)  # noqa: B023  it is asked in this turn alone
        periods = [CONTROL_US * several for several in (1, 3, 2, 1, 7, 2)]
        for number, period_us in enumerate(periods):
            loop.every(period_us, lambda number=number: turns.append(number))  # noqa: B023
        due = [mock_time.elapsed_us()] * len(periods)
        control_us, overruns = due[0], 0
        for _ in range(60):
            now_us = mock_time.elapsed_us()
            expected, missed = [], (now_us - control_us) // CONTROL_US
            if missed >= 0:
                control_us += (missed + 1) * CONTROL_US
                overruns += missed
                ready = [number for number, at_us in enumerate(due) if at_us <= now_us]
                over = ready[most + missed :]
                ready = ready[: most + missed]
                ready += [number for number in over if due[number] + periods[number] <= now_us + CONTROL_US]
                expected = [-1] + ready  # noqa: RUF005  MicroPython cannot
                for number in ready:
                    due[number] += ((now_us - due[number]) // periods[number] + 1) * periods[number]
            del turns[:]
            wait_us = loop.run_pass()
            assert turns == expected, (most, now_us, turns, expected)
            assert loop.overruns == overruns, (most, now_us)
            assert wait_us == control_us - now_us, (most, now_us, wait_us)
            lot = lot * 1103515245 + 12345 & 0x3FFFFFFF
            late = (0, 0, 0, -1, 1, CONTROL_US - 1, CONTROL_US, 2 * CONTROL_US + 1)[lot >> 20 & 7]
            mock_time.advance_us(wait_us + late)


def missed_slots_are_reported():
    """Always late: one report in each interval, with the number; in time: none."""
    craft = new_craft()
    run(craft, 3 * REPORT_MS * 1000)
    assert craft.said("missed") == []
    craft = new_craft()
    run(craft, 6 * REPORT_MS * 1000 + 4 * CONTROL_US, 3 * CONTROL_US)
    texts = [text for _, text in craft.said("missed")]
    assert 6 <= len(texts) <= 7, texts
    counted = sum(int(text.split(" ")[-1]) for text in texts)
    assert 0 <= craft.scheduler.overruns - counted <= 2 * REPORT_MS * 1000 // CONTROL_US
    assert counted > 3 * REPORT_MS * 1000 // CONTROL_US


def load_is_the_share_of_time():
    """Passes that take a fifth of their period are a load of 20 %."""
    craft = new_craft()
    needs(hasattr(getattr(craft.state, "vehicle", None), "load_dpct"), "the load in the state")
    craft.scheduler._control.call = lambda: mock_time.advance_us(CONTROL_US // 5)
    run(craft, 5 * SECOND_US)
    assert abs(craft.state.vehicle.load_dpct - 200) <= 1, craft.state.vehicle.load_dpct


def load_is_measured_over_whole_passes():
    """The time from the end of a pass to that of the first one a second later, and what passes took of it."""
    loop = Scheduler(100000, lambda: mock_time.advance_us(30000))
    loop.every(200000, lambda: mock_time.advance_us(20000))
    loads = []
    for _ in range(32):
        mock_time.advance_us(loop.run_pass())
        loads.append(loop.load)
    # From the start to the end of the eleventh pass it is 1050 ms, with six passes of 50 ms and five of 30 ms.
    assert loads == [0] * 10 + [450000 // 1050] * 10 + [400] * 12, loads


def calls_are_known_by_name():
    """One that has had no turn for too long is told by its name; what has no period, or too long a one, is refused."""
    loop = Scheduler(1000, lambda: None, log=lambda *_words: None)
    loop.every(2000, lambda: None)
    loop.every(5000, lambda: None, "own")
    loop.run_pass()
    assert loop.stalled(10000, ()) is None
    for passed_us, name in ((11000, None), (1, "control"), (1000, "control")):
        mock_time.advance_us(passed_us)
        assert loop.stalled(10000, ()) == name, (passed_us, loop.stalled(10000, ()))
    loop._control.due_us = loop._control.due_us + 5000
    assert loop.stalled(10000, ()) == "job 1"
    loop._jobs[0].due_us = loop._control.due_us
    mock_time.advance_us(3000 - 1)
    assert loop.stalled(10000, ()) is None
    mock_time.advance_us(2)
    assert loop.stalled(10000, ()) == "own"
    for wrong in (0, -1, 1 << 29):
        for make in (lambda wrong=wrong: Scheduler(wrong, None), lambda wrong=wrong: loop.every(wrong, None)):
            try:
                make()
            except ValueError as error:
                assert error.args[0] == "a period is 1 to 536870911 us", error  # noqa: PT017
                continue
            raise AssertionError(wrong)
    loop.every((1 << 29) - 1, None)
    Scheduler(1, None)


def faults_do_not_stop_the_loop():
    """An exception in control() is logged once until it works again; everything behind it goes on."""
    craft = new_craft()

    def fail():
        raise ValueError("broken")

    control = craft.scheduler._control.call
    for _ in range(2):
        craft.scheduler._control.call = fail
        looks = craft.port.looks
        run(craft, SECOND_US)
        assert craft.port.looks - looks >= SECOND_US // LINKS_US - 1
        craft.scheduler._control.call = control
        run(craft, SECOND_US)
    assert len(craft.said("control failed")) == 2, craft.said()
    if FORCE_ARM is None:
        return  # nothing is armed, so nothing is checked
    craft.check_arming = fail
    run(craft, SECOND_US)
    assert not craft.state.vehicle.ready, "a check that fails is no reason to be ready"


def an_interrupt_ends_one_pass():
    """Ctrl-C at the prompt comes through, and whoever goes on after it has a loop that runs."""
    craft = new_craft()

    def interrupt():
        raise KeyboardInterrupt

    control = craft.scheduler._control.call
    for _ in range(2):
        craft.scheduler._control.call = interrupt
        is_through = False
        try:
            run(craft, SECOND_US)
        except KeyboardInterrupt:
            is_through = True
        assert is_through
        craft.scheduler._control.call = control
        looks = craft.port.looks
        run(craft, SECOND_US)
        assert craft.port.looks - looks >= SECOND_US // LINKS_US - 1


def what_is_old_is_forgotten_unasked():
    """With each report one of what grows old has its turn, so that none is left until the ticks have come round."""
    needs(FORGETS, "something that is forgotten with time")
    craft = ready_craft()
    turns = []
    craft.state.forget_next = lambda: turns.append(mock_time.elapsed_us())
    run(craft, 5 * REPORT_MS * 1000)
    assert 4 <= len(turns) <= 6, turns


CHECKS = (
    (control_keeps_its_grid, "control.grid"),
    (jobs_are_due_as_stated, "control.grid"),
    (jitter_is_no_drift, "control.grid"),
    (order_within_a_pass, "control.order", "component.order"),
    (missed_slots, "control.missed"),
    (late_by_whole_periods, "control.missed"),
    (turns_of_a_pass, "control.missed"),
    (missed_slots_are_reported, "control.missed"),
    (load_is_the_share_of_time, "control.missed"),
    (load_is_measured_over_whole_passes, "control.missed"),
    (calls_are_known_by_name, "control.missed"),
    (faults_do_not_stop_the_loop, "control.grid"),
    (an_interrupt_ends_one_pass, "control.grid"),
    (what_is_old_is_forgotten_unasked, "quantity.stale_after"),
)
LONG = (control_keeps_its_grid, missed_slots_are_reported, load_is_the_share_of_time)

if __name__ == "__main__":
    main(CHECKS)
