# Generated from templates/mocks/sim_pace.py: do not edit.
# Inputs: 8b103140e3a5a11f
"""The pace of a simulation: its time follows the host's clock, and runs not ahead of other programs."""

import time as host_time  # the host's clock: this is imported before mock_time takes its place for the firmware

import mock_time

LATE_US = 2000000  # the host was asleep: go on from here instead of catching up


class Pace:
    """Lets virtual time pass no faster than real time times `speed`; 0 for as fast as it can."""

    def __init__(self, speed):
        self._speed = speed
        self._start_us = host_us()
        self._virtual_us = mock_time.elapsed_us()

    def wait_until(self, virtual_us):
        """Return when virtual time may reach `virtual_us`."""
        if not self._speed:
            return
        due_us = self._start_us + int((virtual_us - self._virtual_us) / self._speed)
        ahead_us = due_us - host_us()
        if ahead_us > 0:
            host_time.sleep(ahead_us / 1000000)
        elif ahead_us < -LATE_US:
            self._start_us = host_us()
            self._virtual_us = virtual_us


class Turns:
    """Lets time pass only as far as all programs of a scenario have come, to the end of a turn.

    `path` is a file whose lines are the times in ms, of the scenario, that may be reached; each is asked for by a
    record `turn`. None for a program that is alone. `until_ms` is the end of the turn, None for no end.
    """

    def __init__(self, path, until_ms, records):
        self._file = None if path is None else open(path)  # noqa: SIM115 - it stays open
        self.until_ms = until_ms
        self._records = records

    def wait_until(self, at_ms):
        """Return True when time may reach `at_ms`, False when there will be no more turns."""
        if self._file is None:
            return True
        while at_ms > self.until_ms:
            self._records.put("turn")
            line = self._file.readline()
            if not line:
                return False
            self.until_ms = int(line)
        return True


def host_us():
    """Return microseconds of the host's clock, which only goes forward."""
    if hasattr(host_time, "monotonic_ns"):
        return host_time.monotonic_ns() // 1000
    return host_time.ticks_us()
