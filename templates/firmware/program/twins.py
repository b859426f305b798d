"""Notices others that use the ids of this board, and tells people, who have to give one of the two another id."""

import time
from binascii import hexlify

import machine
import messages
from micropython import const

_ECHO = const(64)  # frames that a link may send before the first of them comes back to it
_STRANGE = const(2)  # HEARTBEATs in a row that are none of its own
_AGAIN_MS = const(30000)  # from one text to the next


class TwinWatch:
    """Looks at what comes from the own system of a connection.

    A HEARTBEAT with its own ids may be its own, sent back by somebody: one whose sequence number it has not sent of
    late is somebody else's. `kinds` are messages that tell the chip of their sender: id, where the payload has the
    chip and in how many bytes, and where the number of the instance. One with its own ids and another chip, or of
    another component with one of its `numbers`, is somebody else's, too.

    `component` and `number` are the names of the parameters that give the ids; `number` may be None.
    """

    def __init__(self, connection, log, component, kinds, number=None, numbers=()):
        self._connection = connection
        self._log = log
        self._names = (component, number)
        self._kinds = kinds
        self._numbers = numbers
        self._chip = hexlify(machine.unique_id())
        self._strange = 0
        self._told_ms = [None, None]

    def look_at(self, message, component):
        """Look at a message that a component with the own system id has sent."""
        is_own = component == self._connection.component_id
        if is_own and message.ID == messages.Heartbeat.ID:
            self._strange = 0 if self._is_echo(message.source_sequence) else self._strange + 1
            if self._strange >= _STRANGE:
                self._tell(0, self._connection.component_id, None)
        for kind in self._kinds:
            if kind[0] == message.ID:
                if is_own:
                    if self._is_of_another_chip(message.wire, kind[1], kind[2]):
                        self._tell(0, self._connection.component_id, None)
                elif kind[3] is not None and message.wire[kind[3]] in self._numbers:
                    self._tell(1, message.wire[kind[3]], component)

    def _is_echo(self, sequence):
        connection = self._connection
        for station in connection.stations:
            following = connection.link.sequence if station is connection.station else station.sequence
            if (following - 1 - sequence) & 0xFF < _ECHO:
                return True
        return False

    def _is_of_another_chip(self, wire, start, count):
        chip = self._chip
        for place in range(count):  # noqa: SIM110  any() would make an object
            if wire[start + place] != (chip[place] if place < len(chip) else 0):
                return True
        return False

    def _tell(self, which, value, component):
        now_ms = time.ticks_ms()
        told_ms = self._told_ms[which]
        if told_ms is None or time.ticks_diff(now_ms, told_ms) >= _AGAIN_MS:
            self._told_ms[which] = now_ms
            who = "another" if component is None else f"component {component}"
            self._log("warning:", self._names[which], value, f"is in use by {who}: change one")


def watch_twins(connection, *arguments):
    """Let a connection tell of others that use its ids."""
    connection.twins = TwinWatch(connection, *arguments)
