# ruff: noqa: T201  what is printed is the answer
"""Times a loop and counts what it allocates: for the scripts of this folder, under MicroPython and CPython."""

import json
import sys
import time

clock_ns = getattr(time, "perf_counter_ns", None) or time.time_ns


def fastest(run, count, passes, prepare=None):
    """Return the nanoseconds of one of `count` rounds in the fastest pass; the loop itself counts too."""
    lowest = None
    for _ in range(passes):
        if prepare is not None:
            prepare()
        start = clock_ns()
        run(1, count)
        took = clock_ns() - start
        if lowest is None or took < lowest:
            lowest = took
    return lowest / count


def allocated(run, count):
    """Return the bytes that one of `count` rounds allocates, those that are free again included.

    What no round at all allocates is taken off. None where nobody counts: under CPython.
    """
    if sys.implementation.name != "micropython":
        return None
    from micropython import mem_total  # noqa: PLC0415

    run(1, count)
    start = mem_total()
    run(1, 0)
    middle = mem_total()
    run(1, count)
    return ((mem_total() - middle) - (middle - start)) / count


def runs_locked(run, count):
    """Tell whether the rounds run while the heap is locked; None under CPython."""
    if sys.implementation.name != "micropython":
        return None
    from micropython import heap_lock, heap_unlock  # noqa: PLC0415

    is_run = True
    heap_lock()
    try:
        run(1, count)
    except MemoryError:
        is_run = False
    heap_unlock()
    return is_run


def answer(run, count, passes, shown, prepare=None):
    """Print what `shown` is, how long a round takes and what it allocates, for measure.py to read."""
    found = {"shown": shown, "ns": fastest(run, count, passes, prepare)}
    if prepare is not None:
        prepare()
    found["allocated"] = allocated(run, 50)
    found["runs_locked"] = runs_locked(run, 50)
    print(json.dumps(found))
