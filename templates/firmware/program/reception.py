"""A message that sets quantities of the state, on one link: who may send it, and what is counted of it."""

from array import array
from time import ticks_diff, ticks_ms

from heard import is_heard
from micropython import const

ANY = const(0)
GROUND_STATION = const(1)  # a system of which a ground station's HEARTBEAT is heard on this link
OWN_SYSTEM = const(2)  # another component of this vehicle

_QUIET_MS = const(10000)  # between two texts about implausible numbers
_FIELDS = const(5)  # where the counts of fields begin


def add(services, kind, taker):
    """Call taker(message) with each message of a class, after those who take it already; it looks at the target."""
    if kind.ID in services._of_target:
        services.take(kind, taker)
    else:
        found = services._of_all.get(kind.ID)
        services._of_all[kind.ID] = taker if found is None else _both(found, taker)


def _both(first, second):
    def take(message):
        first(message)
        second(message)

    return take


class Reception:
    """A table of specs/receives.

    `counts` is what the functions of receiving write, and read: [0] the number of the last field that was implausible,
    from 1, or 0, and -1 for a message that is not for this table, or not for this vehicle; [1] how many messages were
    taken; [2] whether this one came by MAVLink 1, which has no extensions; [3] and [4] system and component of this
    vehicle; then for each field how many of its numbers were implausible. They start anew after 2 ** 30.
    """

    def __init__(self, name, fields, take, is_extended, sender, called, connection, vehicle):
        self._name = name
        self._fields = fields
        self._take = take
        self._state = connection.link._state if is_extended else None  # frames_plain says what it holds
        self._sender = sender
        self._called = called
        self._system_id = connection.system_id
        self._listeners = connection.services.listeners
        self._names = self._listeners.names
        self._words = vehicle.state.words
        self._log = vehicle.texts
        self._told_ms = None
        self.counts = array("i", [0] * (_FIELDS + len(fields)))
        self.counts[3] = connection.system_id
        self.counts[4] = connection.component_id

    @property
    def taken(self):
        """How many messages were taken."""
        return self.counts[1]

    @property
    def refused(self):
        """How many numbers of each field were implausible, by the names of those of which any was."""
        found = {}
        for at in range(len(self._fields)):
            if self.counts[_FIELDS + at]:
                found[self._fields[at]] = self.counts[_FIELDS + at]
        return found

    def take(self, message):
        """Set the quantities, if the sender may."""
        of = self._sender
        if of == GROUND_STATION:
            # Mostly there is one, in the first place.
            if self._names[0] >> 8 != message._image[7] and not is_heard(self._listeners, message._image[7]):
                return
        elif of == OWN_SYSTEM and message._image[7] != self._system_id:
            return
        counts = self.counts
        of = self._state
        if of is not None:
            counts[2] = 1 if of[4] - of[3] == 6 else 0  # the bytes of a header
        self._take(message.wire, self._words, counts, ticks_ms())
        of = counts[0]
        if of > 0:
            self._tell(message)
        if of >= 0 and self._called is not None:
            self._called()

    def _tell(self, message):
        now_ms = ticks_ms()
        if self._told_ms is None or ticks_diff(now_ms, self._told_ms) >= _QUIET_MS:
            self._told_ms = now_ms
            name, _, element = self._fields[self.counts[0] - 1].partition("[")
            value = message.raw(name)
            if element:
                value = value[int(element[:-1])]
            self._log(f"warning: {self._name}.{self._fields[self.counts[0] - 1]} not plausible:", value)
