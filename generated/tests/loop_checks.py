# Generated from templates/tests/program/loop_checks.py: do not edit.
# Inputs: 1e62a585338511fb
"""The main loop: its grid, its order, and what is missed."""

from program_bench import (
    SECOND_US,
    TURN_MS_US,
    TURN_US,
    main,
    mock_time,
    needs,
    new_rover,
    ready_rover,
    run,
)
from program_facts import CONTROL_US, FAILSAFES, FORCE_ARM, LINKS_US, MEASURED, REPORT_MS


def _timed(rover):
    """Let control() note when it runs."""
    times = []
    rover.scheduler._control.call = lambda: times.append(mock_time.elapsed_us())
    return times


def control_keeps_its_grid():
    """Exact multiples of the period, without drift, also where either counter of ticks starts again."""
    for start_us in (0, TURN_US - SECOND_US, TURN_MS_US - SECOND_US):
        rover = new_rover(at_us=start_us)
        times = _timed(rover)
        run(rover, 2 * SECOND_US)
        slots = -(-2 * SECOND_US // CONTROL_US)
        assert times == [start_us + slot * CONTROL_US for slot in range(slots)], (start_us, len(times), slots)
        assert rover.scheduler.overruns == 0


def jitter_is_no_drift():
    """Passes that wake up late, each by another time below a period, stay on the grid."""
    rover = new_rover()
    times = _timed(rover)
    for late in range(2000):
        mock_time.advance_us(rover.run_pass() + late * 7 % CONTROL_US)
    assert rover.scheduler.overruns == 0
    for slot, at_us in enumerate(times):
        assert 0 <= at_us - slot * CONTROL_US < CONTROL_US, (slot, at_us)


def order_within_a_pass():
    """Control, then reading, failsafe, arming checks in the same pass, then the links; readings in their period."""
    needs(MEASURED, "something that is measured")
    rover = ready_rover()
    order = []

    def noted(name, call, owner, attribute):
        def instead(*arguments):
            order.append((mock_time.elapsed_us(), name))
            return call(*arguments)

        setattr(owner, attribute, instead)

    noted("control", rover.control, rover.scheduler._control, "call")
    for measured in MEASURED:
        name = measured["component"]
        noted(name, getattr(rover.state, "update_" + name), rover.state, "update_" + name)
    for facts in FAILSAFES:
        failsafe = getattr(rover, facts["list"])[0]
        noted("failsafe", failsafe.update, failsafe, "update")
    if FORCE_ARM is not None:
        noted("arming", rover.check_arming, rover, "check_arming")
    noted("links", rover.connections[0].run, rover.connections[0], "run")
    run(rover, SECOND_US)
    first = [name for at_us, name in order if at_us == 0]
    assert (first[0], first[-1]) == ("control", "links"), first
    assert FORCE_ARM is None or first[-2] == "arming", first
    for facts in FAILSAFES:
        assert first.index(facts["component"]) < first.index("failsafe") < first.index("arming"), first
    for measured in MEASURED:
        times = [at_us for at_us, name in order if name == measured["component"]]
        period = measured["period_us"]
        due = [slot * period for slot in range(-(-SECOND_US // period))]
        assert times == [-(-at_us // CONTROL_US) * CONTROL_US for at_us in due], times
    arming = [at_us for at_us, name in order if name == "arming"]
    readings = [at_us for at_us, name in order if name == MEASURED[-1]["component"]]
    assert arming == (readings if FORCE_ARM is not None else [])
    assert len([name for _, name in order if name == "control"]) == -(-SECOND_US // CONTROL_US)
    served_us = -(-LINKS_US // CONTROL_US) * CONTROL_US
    assert [name for at_us, name in order if at_us == served_us] == ["control", "links"]


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
        rover = new_rover()
        times = []
        durations = [duration]

        def control(times=times, durations=durations):
            times.append(mock_time.elapsed_us())
            mock_time.advance_us(durations.pop() if durations else 0)

        rover.scheduler._control.call = control
        for _ in range(3):
            mock_time.advance_us(rover.run_pass())
        assert times == [0, next_us, after * CONTROL_US], (duration, times)
        assert rover.scheduler.overruns == missed, (duration, rover.scheduler.overruns)


def missed_slots_are_reported():
    """Always late: one report in each interval, with the number; in time: none."""
    rover = new_rover()
    run(rover, 3 * REPORT_MS * 1000)
    assert rover.said("missed") == []
    rover = new_rover()
    run(rover, 6 * REPORT_MS * 1000 + 4 * CONTROL_US, 3 * CONTROL_US)
    texts = [text for _, text in rover.said("missed")]
    assert 6 <= len(texts) <= 7, texts
    counted = sum(int(text.split(" ")[-1]) for text in texts)
    assert 0 <= rover.scheduler.overruns - counted <= 2 * REPORT_MS * 1000 // CONTROL_US
    assert counted > 3 * REPORT_MS * 1000 // CONTROL_US


def load_is_the_share_of_time():
    """Passes that take a fifth of their period are a load of 20 %."""
    rover = new_rover()
    needs(hasattr(getattr(rover.state, "vehicle", None), "load_dpct"), "the load in the state")
    rover.scheduler._control.call = lambda: mock_time.advance_us(CONTROL_US // 5)
    run(rover, 5 * SECOND_US)
    assert abs(rover.state.vehicle.load_dpct - 200) <= 1, rover.state.vehicle.load_dpct


def faults_do_not_stop_the_loop():
    """An exception in control() is logged once until it works again; everything behind it goes on."""
    rover = new_rover()

    def fail():
        raise ValueError("broken")

    control = rover.scheduler._control.call
    for _ in range(2):
        rover.scheduler._control.call = fail
        polls = rover.port.polls
        run(rover, SECOND_US)
        assert abs(rover.port.polls - polls - SECOND_US // LINKS_US) <= 1
        rover.scheduler._control.call = control
        run(rover, SECOND_US)
    assert len(rover.said("control failed")) == 2, rover.said()
    if FORCE_ARM is None:
        return  # nothing is armed, so nothing is checked
    rover.check_arming = fail
    run(rover, SECOND_US)
    assert not rover.state.vehicle.ready, "a check that fails is no reason to be ready"


CHECKS = (
    (control_keeps_its_grid, "control.grid"),
    (jitter_is_no_drift, "control.grid"),
    (order_within_a_pass, "control.order", "component.order"),
    (missed_slots, "control.missed"),
    (missed_slots_are_reported, "control.missed"),
    (load_is_the_share_of_time, "control.missed"),
    (faults_do_not_stop_the_loop, "control.grid"),
)

if __name__ == "__main__":
    main(CHECKS)
