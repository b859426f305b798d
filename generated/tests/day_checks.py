# Generated from templates/tests/program/day_checks.py: do not edit.
# Inputs: 4ef1db3f9a2c9473
"""A simulated day across the turn of ticks_ms(): no drift, no gap, and everything works after it.

The hour around the turn has more passes than those before and after, in which ticks_us() turns as often.
CPython, whose integers have no end that a sum could reach in a day, goes through an hour of it.
"""

from program_bench import (
    IS_MICROPYTHON,
    SECOND_US,
    TURN_MS_US,
    Sink,
    main,
    mock_time,
    ready_craft,
    run,
)
from program_facts import CONTROL_US, FORCE_ARM, MEASURED, STREAMS

STEP_US = 6400000  # between two passes
NEAR_STEP_US = 800000  # around the turn
DAY_S = 86400 if IS_MICROPYTHON else 3600
DAY_US = DAY_S * SECOND_US
PASSES = DAY_US * 23 // 48 // STEP_US  # before the turn, and after it
NEAR_US = DAY_US - 2 * PASSES * STEP_US


def _streamed(count):
    """Return how many frames of streams with a second's period so many turns of theirs bring at least."""
    fixed = [stream for stream in STREAMS if stream["parameter"] is None]
    fast = [stream for stream in fixed if stream["period_numerator"] <= 1000 * stream["period_denominator"]]
    return sum(len(stream["messages"]) for stream in fast) * (count * 25 // 27)


def day_across_the_wrap():
    """A day that begins half a day before ticks_ms() starts again: readings, streams, grid, all as at its start."""
    sink = Sink()
    start_us = TURN_MS_US - DAY_US // 2
    craft = ready_craft(ports=[sink], at_us=start_us)
    times = []
    craft.scheduler._control.call = lambda: times.append(mock_time.elapsed_us()) if not times else None
    for duration_us, step_us in ((PASSES * STEP_US, STEP_US), (NEAR_US, NEAR_STEP_US), (PASSES * STEP_US, STEP_US)):
        before = sink.count
        run(craft, duration_us, step_us)
        turns = duration_us // max(step_us, SECOND_US)
        assert sink.count - before >= _streamed(turns), (sink.count - before, turns)
    late_us = mock_time.ticks_diff(craft.scheduler._control.due_us, mock_time.ticks_us())
    assert -STEP_US <= late_us <= CONTROL_US
    assert (mock_time.elapsed_us() + late_us - start_us) % CONTROL_US == 0, "the grid has moved"
    slots = DAY_US // CONTROL_US
    passes = 2 * PASSES + NEAR_US // NEAR_STEP_US
    assert abs(craft.scheduler.overruns - (slots - passes)) <= STEP_US // CONTROL_US, craft.scheduler.overruns
    for measured in MEASURED:
        component = getattr(craft.state, measured["component"])
        component = component[0] if measured["first"] != measured["component"] else component
        assert getattr(component, measured["attribute"]) is not None
    assert FORCE_ARM is None or craft.arm() is None
    before = sink.count
    run(craft, 10 * SECOND_US)
    assert sink.count > before


CHECKS = ((day_across_the_wrap, "control.grid"),)
LONG = (day_across_the_wrap,)

if __name__ == "__main__":
    main(CHECKS)
