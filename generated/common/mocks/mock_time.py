# Generated from templates/mocks/mock_time.py: do not edit.
# Inputs: 1b9c5f9c9669058d
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

# The clock: microseconds and milliseconds as ticks, microseconds since the last whole millisecond, turns of the
# microseconds, each of PERIOD, all milliseconds where there is machine code, and the microseconds until _ring().
words = array("i", [0, 0, 0, 0, 0, _HALF])
_followers = []
_ring = None
_ring_later_us = 0  # beyond what its word says


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


def set_alarm(left_us, ring):
    """Call `ring` with the microseconds that were left, where more than these are about to pass; None for nobody."""
    global _ring, _ring_later_us  # noqa: PLW0603 - there is one
    _ring = ring
    words[5] = _HALF if ring is None else min(left_us, _HALF)
    _ring_later_us = 0 if ring is None else left_us - words[5]


def alarm_left_us():
    """Return the microseconds until the alarm rings, 0 where there is none."""
    return 0 if _ring is None else words[5] + _ring_later_us


def set_ticks_us(now):
    """Set the clock to `now` microseconds since the start, not wrapped: milliseconds wrap at 2**30 * 1000."""
    if now < 0:
        raise ValueError("the clock starts at 0")
    words[0] = now % PERIOD
    words[1] = now // 1000 % PERIOD
    words[2] = now % 1000
    words[3] = now // PERIOD
    words[4] = now // 1000 & 0x7FFFFFFF


def advance_us(duration):
    """Let `duration` microseconds pass."""
    if _followers or not 0 <= duration < words[5]:
        _advance_slowly(duration)
        return
    move(duration)


def move(duration):
    """Let microseconds pass, fewer than those until the alarm."""
    before_us = words[0]
    words[0] = now_us = _later(before_us, duration)
    if now_us < before_us:
        words[3] += 1
    rest_us = words[2] + duration
    words[1] = _later(words[1], rest_us // 1000)
    words[2] = rest_us % 1000
    words[5] -= duration


def _advance_slowly(duration):
    """Let microseconds pass that somebody has to be told of."""
    if duration < 0:
        raise ValueError("time does not run backwards")
    for follower in _followers:
        follower(duration)
    left_us = alarm_left_us()
    ring = _ring
    if ring is not None and duration > left_us:
        set_alarm(0, None)
        ring(left_us)
    if duration > _HALF:
        set_ticks_us(elapsed_us() + duration)
    else:
        words[5] = _HALF
        move(duration)
    set_alarm(max(0, left_us - duration), _ring)


def elapsed_us():
    """Return the microseconds since the start, not wrapped."""
    return words[3] * PERIOD + words[0]


def ticks_us():
    """Return microseconds, 0 to 2**30 - 1."""
    return words[0]


def ticks_ms():
    """Return milliseconds, 0 to 2**30 - 1."""
    return words[1]


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
    if delta >= 0:
        return _later(ticks, delta)
    moved = ticks + delta
    return moved if moved >= 0 else moved + _MOST + 1


def _later(ticks, delta):
    moved = ticks - _MOST + delta - 1  # a period less, so that the sum stays small
    return moved if moved >= 0 else moved + _MOST + 1


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


machine_code = None  # the module that has the clock in machine code, where there is one
if sys.implementation.name == "micropython":
    try:
        import mock_ticks_viper as machine_code
    except Exception:  # this port, or this computer, has none
        machine_code = None
if machine_code is not None:
    machine_code.words = words
    machine_code.followers = _followers
    machine_code.slowly = _advance_slowly
    ticks_us, ticks_ms = machine_code.ticks_us, machine_code.ticks_ms
    ticks_diff, ticks_add = machine_code.ticks_diff, machine_code.ticks_add
    advance_us, move, elapsed_us = machine_code.advance_us, machine_code.move, machine_code.elapsed_us
