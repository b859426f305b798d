"""A clock that stands still until it is told to go on, in place of the board's module `time`.

Tests call install() before they import the firmware, which then sees this clock when it imports `time`. Ticks wrap as
they do on boards, after 2**30 units: microseconds after 18 minutes, milliseconds after 12 days. The clock goes on, and
is read, without a number beyond 2**30, which 32-bit ports would have to put on the heap; elapsed_us() may be one.
"""

import sys
from array import array

PERIOD = 1 << 30
_MOST = 0x3FFFFFFF  # the last tick before they start again
_HALF = 1 << 29

_NAMES = ("ticks_ms", "ticks_us", "ticks_add", "ticks_diff", "sleep_ms", "sleep_us")

host_time = None  # under MicroPython, after install(): the true module, as for the queue of asyncio in C

_word = array("i", [0])
_turns = 0  # of the microseconds, each of PERIOD
_us = 0
_ms = 0
_rest_us = 0  # since the last whole millisecond
_followers = []


def install():
    """Let `import time` give this clock.

    On MicroPython it takes the place of the whole module. On CPython, where pytest and others need the true time, the
    names of MicroPython are added to it; sleep() and time() remain those of the host.
    """
    import time  # noqa: PLC0415 - the module to replace, or to add to

    global host_time  # noqa: PLW0603 - there is one
    if sys.implementation.name == "micropython":
        mock = sys.modules[__name__]
        if time is not mock:
            host_time = time
        for module in list(sys.modules.values()):
            if module is not mock and getattr(module, "time", None) is time:
                module.time = mock  # it imported the true time before
        for name in _NAMES:
            _replace(name, getattr(time, name), globals()[name])
        sys.modules["time"] = mock
        return
    for name in _NAMES:
        existing = getattr(time, name, None)
        # An earlier import of this module may have been here, with a clock of its own.
        if existing is None or existing.__module__ == __name__:
            setattr(time, name, globals()[name])
            _replace(name, existing, globals()[name])


def _replace(name, old, new):
    """Give the new function to every module that has imported the old one by its name."""
    for module in list(sys.modules.values()):
        if old is not None and old is not new and getattr(module, name, None) is old:
            setattr(module, name, new)


def follow(follower):
    """Call `follower` with the microseconds each time that some are about to pass: timers and watchdogs run on that."""
    if follower not in _followers:
        _followers.append(follower)


def follow_nobody():
    """Let nobody be called any more, as after a reset."""
    _followers.clear()


def set_ticks_us(now):
    """Set the clock to `now` microseconds since the start, not wrapped: milliseconds wrap at 2**30 * 1000."""
    global _turns, _us, _ms, _rest_us  # noqa: PLW0603 - there is one clock
    if now < 0:
        raise ValueError("the clock starts at 0")
    _turns, _us = now // PERIOD, _tick(now % PERIOD)
    _ms = _tick(now // 1000 % PERIOD)
    _rest_us = _tick(now % 1000)


def _tick(number):
    """Return the number as boards have it: what 32-bit ports divide by a large one stays on the heap, and so does all
    that is computed with it."""
    _word[0] = number
    return _word[0]


def advance_us(duration):
    """Let `duration` microseconds pass."""
    global _turns, _us, _ms, _rest_us  # noqa: PLW0603 - there is one clock
    if duration < 0:
        raise ValueError("time does not run backwards")
    for follower in _followers:
        follower(duration)
    if duration > _HALF:
        set_ticks_us(elapsed_us() + duration)
        return
    # A period less, as in ticks_add(), so that sums stay small; without a call, since suites spend their time here.
    moved = _us - _MOST + duration - 1
    if moved >= 0:
        _us = moved
        _turns += 1
    else:
        _us = moved + _MOST + 1
    rest_us = _rest_us + duration
    if rest_us >= 1000:
        moved = _ms - _MOST + rest_us // 1000 - 1
        _ms = moved if moved >= 0 else moved + _MOST + 1
        rest_us %= 1000
    _rest_us = rest_us


def elapsed_us():
    """Return the microseconds since the start, not wrapped."""
    return _turns * PERIOD + _us


def ticks_us():
    """Return microseconds, 0 to 2**30 - 1."""
    return _us


def ticks_ms():
    """Return milliseconds, 0 to 2**30 - 1."""
    return _ms


def ticks_diff(end, start):
    """Return the signed time from `start` to `end`, right as long as it is under half a period."""
    passed = end - start
    if passed >= _HALF:
        return passed - _MOST - 1
    return passed + _MOST + 1 if passed < -_HALF else passed


def ticks_add(ticks, delta):
    """Return `ticks` moved by `delta`; OverflowError from half a period on, as on boards."""
    if not -_HALF <= delta < _HALF:
        raise OverflowError("ticks interval overflow")
    moved = ticks + delta if delta < 0 else ticks - _MOST + delta - 1  # a period less, so that the sum stays small
    if moved >= 0:
        return moved
    return moved + _MOST + 1


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
    return elapsed_us() // 1000000
