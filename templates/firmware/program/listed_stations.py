"""Links on which only what listed systems say they have sent counts: that keeps mistakes away, not attackers."""

from micropython import const

_SENDER = const(23)  # where the state of a link has system << 8 | component: frames_plain says more


class ListedStations:
    """Stands before the inbox of a connection, and passes over what comes from other systems: `refused` counts it.

    Who watches for others with the ids of this vehicle sees it nevertheless.
    """

    def __init__(self, connection, systems):
        self.refused = 0
        self._connection = connection
        self._inbox = connection.inbox
        self._systems = systems

    def next(self, now_ms):
        """Return the next message of a system that is listed, or None."""
        connection = self._connection
        while True:  # the inbox ends it with the share of a pass
            message = self._inbox.next(now_ms)
            if message is None:
                return None
            system = connection.link._state[_SENDER] >> 8
            if system in self._systems:
                return message
            if system == connection.system_id:
                connection.is_other(message)
            self.refused += 1


def admit_only(connection, systems):
    """Let only listed systems be heard over a connection."""
    connection.inbox = ListedStations(connection, systems)
