"""The time since 1970 by SYSTEM_TIME from a ground station, while nothing else has said what it is.

The first one counts: what has set the clock, be it code or a ground station, is not changed by what arrives later. Code
that wants to be told again sets `state.clock.unix_us` to None.
"""

import messages
import services

_EARLIEST_US = 1577836800000000  # 2020: before that, who sends it does not know the time either
_LATEST_US = 4102444800000000  # 2100


def receivable():
    """Return a new message of each kind that the services answer, and of SYSTEM_TIME."""
    return services.receivable() + (messages.SystemTime(unknown=False),)  # noqa: RUF005  MicroPython cannot


def follow_time(connection, clock):
    """Let the ground stations of a connection set a clock; return the connection."""
    connection.services.for_all[messages.SystemTime.ID] = _TimeService(connection.services, clock).take
    return connection


class _TimeService:
    """What takes SYSTEM_TIME on one connection."""

    def __init__(self, answering, clock):
        self._services = answering
        self._clock = clock

    def take(self, message):
        """Set the clock by a time that can be, of a system of which a ground station is heard here."""
        if self._clock.unix_us is None and self._is_heard(message.source_system):
            time_us = message.raw("time_unix_usec")
            if _EARLIEST_US < time_us < _LATEST_US:
                self._clock.unix_us = time_us

    def _is_heard(self, system):
        return any(name >> 8 == system for name in self._services.listeners.names)
