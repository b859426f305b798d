# Generated from templates/mocks/sim_source.py: do not edit.
# Inputs: 6fb6a6b6f3125a44
"""True values that a sensor gives: in a simulation something else than its driver gives them, in the same form."""

import errno
from array import array

import mock_time

UNKNOWN = -1073741824
LARGEST = 1073741823


def connect(courses, now_ms, start_ms):  # noqa: ARG001 - as other inputs, see sim_adc
    """Put a driver that follows the courses in the place of each driver whose sensor has any."""
    import polling  # noqa: PLC0415 - the firmware's own, before its sensors are made

    found = {}
    for course in courses:
        found.setdefault(course.settings["source"], []).append(course)
    plain = polling.Poller

    class SimulatedPoller(plain):
        """A sensor whose driver is another one where the scenario says what is true of it."""

        def __init__(self, name, driver, functions, limit_us, retry_ms, cause, log):
            if name in found:
                driver = Driver(found[name], now_ms)
                cause = cause or "no answer"  # of this driver that is what an OSError means
            plain.__init__(self, name, driver, functions, limit_us, retry_ms, cause, log)

    polling.Poller = SimulatedPoller


class Driver:
    """Gives what is true: whole steps, in one word or in halves of 16 bits, where the driver itself has them."""

    def __init__(self, courses, now_ms):
        self.values = array("i", [UNKNOWN] * courses[0].settings["size"])
        self._courses = courses
        self._now_ms = now_ms
        self._due_ms = 0

    def begin(self):
        """Set nothing up, unless the sensor is absent."""
        if self._fault("absent") is not None:
            raise OSError(errno.ENODEV)

    def waiting(self):
        """Return whether something waits: a sensor that speaks by itself does so at the rate of its course."""
        return self._now_ms() >= self._due_ms

    def poll(self, _now_ms):
        """Take one look at all that is true; OSError if that fails."""
        slow = self._fault("slow")
        if slow is not None:
            mock_time.advance_us(slow["delay_us"])
        elif self._fault("fail") is not None or self._fault("absent") is not None:
            raise OSError(errno.EIO)
        at_ms = self._now_ms()
        self._due_ms = at_ms + self._courses[0].every_ms
        for course in self._courses:
            self._put(course.settings, course.seen(at_ms))
        return True

    def _put(self, settings, value):
        place, words = settings["place"], settings["words"]
        if value is None:
            self.values[place] = UNKNOWN
            return
        steps = round(value * settings["steps"])
        if words == 1:
            self.values[place] = min(max(steps, -LARGEST), LARGEST)
            return
        for half in range(words):
            self.values[place + half] = steps >> 16 * half & 0xFFFF

    def _fault(self, kind):
        at_ms = self._now_ms()
        for course in self._courses:
            fault = course.fault(kind, at_ms)
            if fault is not None:
                return fault
        return None
