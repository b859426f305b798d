"""Runs functions that assert, on the interpreter that reads this file, and prints as JSON what went wrong in each.

Scripts for both interpreters import it: they keep to what both have.
"""

import io
import json
import sys

try:
    from micropython import heap_lock, heap_unlock, mem_total
except ImportError:  # CPython has no heap to lock or to measure

    def heap_lock():
        """Lock nothing."""

    def heap_unlock():
        """Unlock nothing."""

    def mem_total():
        """Return a number that stays."""
        return 0


def run(*functions):
    """Call each function; print a list of its name and None, or what it raised."""
    sys.stdout.write(json.dumps([[function.__name__, outcome(function)] for function in functions]))


def outcome(function):
    """Return None for a function that returns, else what it raised."""
    try:
        function()
    except Exception as error:
        return shown(error)
    return None


def shown(error):
    """Return an exception with the places that it went through."""
    if sys.implementation.name == "micropython":
        trace = io.StringIO()
        sys.print_exception(error, trace)
        return trace.getvalue()
    import traceback  # noqa: PLC0415 - MicroPython has none

    return "".join(traceback.format_exception(error))


def allocated(function, times=500):
    """Return how many bytes so many calls put on the heap, for as short as it may be, after a first one.

    The heap is locked in between, where some of it would raise MemoryError.
    """
    _repeat(function, 1)
    heap_lock()
    try:
        _repeat(function, times)
    finally:
        heap_unlock()
    start = mem_total()
    _repeat(function, 0)
    middle = mem_total()
    _repeat(function, times)
    return (mem_total() - middle) - (middle - start)


def taken(function, times=500):
    """Return the same for calls that need the heap."""
    _repeat(function, 1)
    start = mem_total()
    _repeat(function, 0)
    middle = mem_total()
    _repeat(function, times)
    return (mem_total() - middle) - (middle - start)


def _repeat(function, times):
    for _ in range(times):
        function()
