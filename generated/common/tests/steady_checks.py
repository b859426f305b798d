# Generated from templates/tests/program/steady_checks.py: do not edit.
# Inputs: 27d792ed39bf6128
"""The steady cycle of a whole vehicle leaves the heap alone; only MicroPython can tell."""

from micropython import heap_lock, heap_unlock, mem_total
from program_bench import SECOND_US, Sink, analog, main, mock_time, new_craft, run
from program_facts import CONTROL_US, FAILSAFES, FORCE_ARM, MEASURED, STREAMS

LATE_US = 1000000
FORGIVEN = ("control", "measure")


def _fast(craft):
    for stream in STREAMS:
        if stream["parameter"]:
            setattr(craft.parameters, stream["parameter"], stream["maximum"])


def steady_cycle_allocates_nothing():
    """Whole passes with all streams at their highest rates, under a locked heap, and nothing is ever allocated."""
    for version in ("disarmed",) if FORCE_ARM is None else ("disarmed", "armed", "watching"):
        sink = Sink()
        craft = new_craft(ports=[sink])
        _fast(craft)
        if version != "disarmed":
            craft.arm(force=True)
        run(craft, 5 * SECOND_US)
        if version == "watching":
            for measured in MEASURED:
                analog(measured).source = 1
            for facts in FAILSAFES:
                craft.parameters.set(facts["after"].upper(), 120)
            run(craft, 15 * SECOND_US)
        count = sink.count
        allocated = _allocated(craft)
        assert allocated == 0, f"{version}: {allocated} bytes in 2 s"
        assert sink.count > count
        errors = [text for text in craft.said() if "failed:" in text[1] or "fault" in text[1]]
        assert errors == [], errors


def _allocated(craft):
    """Return how many bytes 800 passes allocate; MemoryError: something is allocated while the heap is locked."""
    waits = 0
    heap_lock()
    try:
        for _ in range(800):
            waits += craft.run_pass()
            mock_time.advance_us(CONTROL_US)
    finally:
        heap_unlock()
    before = mem_total()
    for turn in range(800):
        craft.run_pass()
        mock_time.advance_us(CONTROL_US)
        if turn % 200 == 0:  # what a watchdog looks at
            craft.scheduler.stalled(LATE_US, FORGIVEN)
    return mem_total() - before


CHECKS = ((steady_cycle_allocates_nothing, "control.memory", "component.steady", "component.allocation"),)

if __name__ == "__main__":
    main(CHECKS)
