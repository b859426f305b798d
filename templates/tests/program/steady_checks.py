"""The steady cycle of a whole vehicle leaves the heap alone; only MicroPython can tell."""

from micropython import heap_lock, heap_unlock, mem_total
from program_bench import SECOND_US, Sink, analog, main, mock_time, new_rover, run
from program_facts import CONTROL_US, FAILSAFES, FORCE_ARM, MEASURED, STREAMS


def _fast(rover):
    for stream in STREAMS:
        if stream["parameter"]:
            setattr(rover.parameters, stream["parameter"], stream["maximum"])


def steady_cycle_allocates_nothing():
    """Whole passes with all streams at their highest rates, under a locked heap, and nothing is ever allocated."""
    for version in ("disarmed",) if FORCE_ARM is None else ("disarmed", "armed", "watching"):
        sink = Sink()
        rover = new_rover(ports=[sink])
        _fast(rover)
        if version != "disarmed":
            rover.arm(force=True)
        run(rover, 5 * SECOND_US)
        if version == "watching":
            for measured in MEASURED:
                analog(measured).source = 1
            for facts in FAILSAFES:
                rover.parameters.set(facts["after"].upper(), 120)
            run(rover, 15 * SECOND_US)
        count = sink.count
        allocated = _allocated(rover)
        assert allocated == 0, f"{version}: {allocated} bytes in 2 s"
        assert sink.count > count
        errors = [text for text in rover.said() if "failed:" in text[1] or "fault" in text[1]]
        assert errors == [], errors


def _allocated(rover):
    """Return how many bytes 800 passes allocate; MemoryError: something is allocated while the heap is locked."""
    waits = 0
    heap_lock()
    try:
        for _ in range(800):
            waits += rover.run_pass()
            mock_time.advance_us(CONTROL_US)
    finally:
        heap_unlock()
    before = mem_total()
    for _ in range(800):
        rover.run_pass()
        mock_time.advance_us(CONTROL_US)
    return mem_total() - before


CHECKS = ((steady_cycle_allocates_nothing, "control.memory", "component.steady", "component.allocation"),)

if __name__ == "__main__":
    main(CHECKS)
