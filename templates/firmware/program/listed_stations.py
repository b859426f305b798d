"""Links on which only what listed systems say they have sent counts: that keeps mistakes away, not attackers."""


class ListedStations:
    """Stands before the inbox of a connection, and passes over what comes from other systems: `refused` counts it."""

    def __init__(self, inbox, systems):
        self.refused = 0
        self._inbox = inbox
        self._systems = systems

    def next(self, now_ms):
        """Return the next message of a system that is listed, or None."""
        while True:  # the inbox ends it with the share of a pass
            message = self._inbox.next(now_ms)
            if message is None or message._image[7] in self._systems:  # frames_plain says what it holds
                return message
            self.refused += 1


def admit_only(connection, systems):
    """Let only listed systems be heard over a connection."""
    connection.inbox = ListedStations(connection.inbox, systems)
