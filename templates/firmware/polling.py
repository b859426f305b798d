"""Sensors that are asked in the main loop: what they give is kept, what fails is told and set up again.

A driver has `values`, an array of the whole numbers that it gives; begin(), which sets its hardware up; and
poll(now_ms), which returns whether something new stands in `values`. Both raise where they fail: Fault has the reason
in the operator's words. Nothing here allocates while nothing fails.
"""

import time

from guard import Guard
from micropython import const

UNKNOWN = -1073741824  # in `values`: what the sensor does not know
_DOWN_AFTER = const(3)  # failures in a row, after which it is set up again
_PAUSE_MS = const(10000)  # between two texts about the same
_MOST = const(0x3FFFFFFF)
_LONG = const(0xFFFFFFF)


class Fault(Exception):  # noqa: N818  it is a fault of the sensor
    """A fault of a sensor, in words that a text can show."""


class Seldom:
    """Texts about one thing: the first at once, then at most one in ten seconds, with the number of times."""

    def __init__(self, log):
        self._log = log
        self._count = 0
        self._told_ms = None

    def __call__(self, now_ms, text, detail):
        """Log a text, if the last one is long enough ago; return whether it was logged."""
        self._count += 1
        if self._told_ms is not None and 0 <= time.ticks_diff(now_ms, self._told_ms) < _PAUSE_MS:
            return False
        self._log(text, detail if self._count == 1 else f"{detail} ({self._count} times)")
        self._count = 0
        self._told_ms = now_ms
        return True


class Poller:
    """A sensor: `keep(words, values, now_ms)` puts what it gives into the state, `lose(words, failures)` forgets it.

    `limit_us` is the longest time for one turn, or None; `retry_ms` lies between two attempts to set it up; `cause` is
    what to say of an OSError. `failures` counts turns without a reading in a row, `overruns` those above the limit;
    `longest_us` is the longest of them, `mean_us` the mean of all, of late ones above all. It is down until it is set
    up, in its first turn. It has no property: with one, each store into an attribute takes ten times as long.
    """

    def __init__(self, name, driver, functions, limit_us, retry_ms, cause, log):
        self.name = name
        self.driver = driver
        self.is_down = True
        self.failures = 0
        self.overruns = 0
        self.longest_us = 0
        self.mean_us = 0
        self._words, self._keep, self._lose = functions
        self._limit_us = _MOST if limit_us is None else limit_us
        self._retry_ms = retry_ms
        self._cause = cause
        self._log = log
        self._guard = Guard()
        self._is_new = False
        self._is_told = False  # that it fails
        self._due_ms = None  # when it is set up again
        self._total_us = 0
        self._turns = 0
        self._tell_failure = Seldom(log)
        self._tell_overrun = Seldom(log)

    def turn(self):
        """Ask the sensor, or set it up where it is down and that is due. It never raises."""
        now_ms = time.ticks_ms()
        if self.is_down and not self._is_set_up(now_ms):
            return
        self._ask(now_ms)
        if self._guard.error is not None:
            self.fail(self._guard.error, now_ms)
        elif self._is_new:
            self._works()

    def fail(self, error, now_ms):
        """Count a failure, and tell it if it is time."""
        self._count_failure()
        if self._tell_failure(now_ms, f"error: {self.name}:", _reason(error, self._cause)):
            self._is_told = True
        if self.is_down or self.failures >= _DOWN_AFTER:
            self._go_down(now_ms)

    def _ask(self, now_ms):
        started_us = time.ticks_us()
        self._try(now_ms)
        self._time(time.ticks_diff(time.ticks_us(), started_us), now_ms)

    def _try(self, now_ms):  # with few variables: those of a larger function lie on the heap
        self._is_new = False
        with self._guard:
            self._take(now_ms)

    def _take(self, now_ms):
        if self.driver.poll(now_ms):
            self._keep(self._words, self.driver.values, now_ms)
            self._is_new = True

    def _time(self, took_us, now_ms):
        self._total_us += took_us
        self._turns += 1
        if self._total_us > _LONG:
            self._total_us //= 2
            self._turns = (self._turns + 1) // 2
        self.mean_us = self._total_us // self._turns
        if took_us > self.longest_us:  # noqa: PLR1730  max() takes longer than the rest
            self.longest_us = took_us
        if took_us > self._limit_us:
            self.overruns = (self.overruns + 1) & _MOST
            self._tell_overrun(now_ms, f"warning: {self.name} took too long, in us:", took_us)

    def _works(self):
        self.failures = 0
        if self._is_told:
            self._is_told = False
            self._log(f"notice: {self.name} works again")

    def _is_set_up(self, now_ms):
        """Set the sensor up, if that is due; return whether it is set up."""
        if self._due_ms is not None and 0 < time.ticks_diff(self._due_ms, now_ms) <= self._retry_ms:
            self._count_failure()
            return False
        with self._guard:
            self.driver.begin()
        if self._guard.error is not None:
            self.fail(self._guard.error, now_ms)
            return False
        self.is_down = False
        return True

    def _go_down(self, now_ms):
        self.is_down = True
        self._due_ms = time.ticks_add(now_ms, self._retry_ms)

    def _count_failure(self):
        if self.failures < _MOST:
            self.failures += 1
        self._lose(self._words, self.failures)


def _reason(error, cause):
    """Return what is wrong in the operator's words."""
    if isinstance(error, Fault):
        return str(error)
    if isinstance(error, OSError) and cause:
        return cause
    if isinstance(error, MemoryError):
        return "memory is full"
    text = str(error)
    return f"{type(error).__name__}: {text}" if text else type(error).__name__
