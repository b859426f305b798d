# Generated from templates/mocks/mock_time.py: do not edit.
# Inputs: 75df49e198fbb081
"""A clock that stands still until it is told to go on, in place of the board's module `time`.

Tests call install() before they import the firmware, which then sees this clock when it imports `time`. Ticks wrap as
they do on boards, after 2**30 units: microseconds after 18 minutes, milliseconds after 12 days.
"""

import sys

PERIOD = 1 << 30
_HALF = PERIOD >> 1

_NAMES = ("ticks_ms", "ticks_us", "ticks_add", "ticks_diff", "sleep_ms", "sleep_us")

_now_us = 0


def install():
    """Let `import time` give this clock.

    On MicroPython it takes the place of the whole module. On CPython, where pytest and others need the true time, the
    names of MicroPython are added to it; sleep() and time() remain those of the host.
    """
    import time  # noqa: PLC0415 - the module to replace, or to add to

    if sys.implementation.name == "micropython":
        mock = sys.modules[__name__]
        for module in list(sys.modules.values()):
            if module is not mock and getattr(module, "time", None) is time:
                module.time = mock  # it imported the true time before
        sys.modules["time"] = mock
        return
    for name in _NAMES:
        existing = getattr(time, name, None)
        # An earlier import of this module may have been here, with a clock of its own.
        if existing is None or existing.__module__ == __name__:
            setattr(time, name, globals()[name])


def set_ticks_us(now):
    """Set the clock to `now` microseconds since the start, not wrapped: milliseconds wrap at 2**30 * 1000."""
    global _now_us  # noqa: PLW0603 - there is one clock
    if now < 0:
        raise ValueError("the clock starts at 0")
    _now_us = now


def advance_us(duration):
    """Let `duration` microseconds pass."""
    if duration < 0:
        raise ValueError("time does not run backwards")
    set_ticks_us(_now_us + duration)


def elapsed_us():
    """Return the microseconds since the start, not wrapped."""
    return _now_us


def ticks_us():
    """Return microseconds, 0 to 2**30 - 1."""
    return _now_us % PERIOD


def ticks_ms():
    """Return milliseconds, 0 to 2**30 - 1."""
    return _now_us // 1000 % PERIOD


def ticks_diff(end, start):
    """Return the signed time from `start` to `end`, right as long as it is under half a period."""
    return (end - start + _HALF) % PERIOD - _HALF


def ticks_add(ticks, delta):
    """Return `ticks` moved by `delta`; OverflowError from half a period on, as on boards."""
    if not -_HALF <= delta < _HALF:
        raise OverflowError("ticks interval overflow")
    return (ticks + delta) % PERIOD


def sleep_us(duration):
    """Let microseconds pass; a negative duration is none, as on boards."""
    advance_us(max(0, duration))


def sleep_ms(duration):
    """Let milliseconds pass."""
    sleep_us(duration * 1000)


def sleep(duration):
    """Let seconds pass, a fraction too."""
    sleep_us(int(duration * 1000000))


def time():
    """Return the seconds since the start, whole."""
    return _now_us // 1000000
