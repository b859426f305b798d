"""The time since 1970 by SYSTEM_TIME from a ground station, while nothing else has said what it is.

The first one counts: what has set the clock, be it code or a ground station, is not changed by what arrives later. Code
that wants to be told again sets `state.clock.unix_us` to None.
"""

from struct import unpack_from

import dialect
import messages
from heard import is_heard
from micropython import const  # noqa: F401  numbers of the dialect are constants

_EARLIEST_US = 1577836800000000  # 2020: before that, who sends it does not know the time either
_LATEST_US = 4102444800000000  # 2100


def follow_time(connection, clock):
    """Let the ground stations of a connection, whose link receives SYSTEM_TIME, set a clock."""
    listeners = connection.services.listeners

    def take(message):
        """Set the clock by a time that can be, of a system of which a ground station is heard here."""
        if clock.unix_us is None and is_heard(listeners, message.source_system):
            time_us = unpack_from("<Q", message.wire, dialect.SYSTEM_TIME_TIME_UNIX_USEC_AT)[0]
            if _EARLIEST_US < time_us < _LATEST_US:
                clock.unix_us = time_us

    connection.services.take(messages.SystemTime, take)
