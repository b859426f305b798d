"""A message that sets quantities of the state, on one link: who may send it, and what is counted of it."""

from array import array
from time import ticks_diff, ticks_ms

from heard import is_heard
from micropython import const

ANY = const(0)
GROUND_STATION = const(1)  # a system of which a ground station's HEARTBEAT is heard on this link
OWN_SYSTEM = const(2)  # another component of this vehicle

_QUIET_MS = const(10000)  # between two texts about implausible numbers
_FIELDS = const(16)  # where the counts of fields begin


class Reception:
    """A table of specs/receives.

    take(now_ms), at time.ticks_ms(), sets the quantities by what its link has received last, which is in `message`, if
    the sender may. It returns 0 where nothing more is to be done, and 1 or more where a number was implausible: tell()
    then tells it. Where it returns anything but 0, `called` is called, unless it is None; `vehicle.reception` is this
    object then, so that code knows `message` with its sender, and `connection`, which sends to that. receiving.py sets
    take().

    `counts` is what the functions of receiving write, and read: [0] the number of the last field that was implausible,
    from 1, or 0, and -1 for a message that is not for this table, or not for this vehicle; [1] how many messages were
    taken; [2] not 0 if this one came by MAVLink 1, which has no extensions; [3] and [4] system and component of this
    vehicle; [5] how many bytes the names of listeners take; in machine code [6], [8] and [10] the addresses of the
    words, of these names and of the state of the link, 64 bits each, and from [12] on what wholes_viper is given; then
    for each field how many of its numbers were implausible. They start anew after 2 ** 30.
    """

    def __init__(self, name, fields, sender, called, connection, vehicle):
        self._name = name
        self._fields = fields
        self.called = called
        self.vehicle = vehicle
        self.connection = connection
        self._log = vehicle.texts
        self._told_ms = None
        self.sender = sender
        self.message = None
        self.listeners = connection.services.listeners
        self.link = connection.link._state  # frames_plain says what it holds
        self.words = vehicle.state.words
        self.counts = array("i", [0] * (_FIELDS + len(fields)))
        self.counts[3] = connection.system_id
        self.counts[4] = connection.component_id
        self.counts[5] = 2 * len(self.listeners.names)

    @property
    def taken(self):
        """Return the number of messages taken."""
        return self.counts[1]

    @property
    def refused(self):
        """Return the numbers of implausible values, by the names of the fields that had any."""
        found = {}
        for at in range(len(self._fields)):
            if self.counts[_FIELDS + at]:
                found[self._fields[at]] = self.counts[_FIELDS + at]
        return found

    def tell(self):
        """Tell that a number was not plausible, now and then."""
        now_ms = ticks_ms()
        if self._told_ms is None or ticks_diff(now_ms, self._told_ms) >= _QUIET_MS:
            self._told_ms = now_ms
            name, _, element = self._fields[self.counts[0] - 1].partition("[")
            value = self.message.raw(name)
            if element:
                value = value[int(element[:-1])]
            self._log(f"warning: {self._name}.{self._fields[self.counts[0] - 1]} not plausible:", value)


class Several:
    """Receptions of the same message, one after another."""

    called = None

    def __init__(self, first, second):
        self._first = first
        self._second = second

    def take(self, now_ms):
        """Let each take it; all that is to be done then is done. A loop would need the heap for its variables."""
        table = self._first
        found = table.take(now_ms)
        if found:
            _tell(table, found)
        table = self._second
        found = table.take(now_ms)
        if found:
            _tell(table, found)
        return 0


def _tell(table, found):  # apart, since the variables of a larger function lie on the heap
    if found > 0:
        table.tell()
    if table.called is not None:
        table.vehicle.reception = table
        table.called()


def rarely(table):
    """Return what lets a Reception take messages that the services hand on: those that are made anew each time."""

    def take(message):
        table.message = message
        found = table.take(ticks_ms())
        if found:
            _tell(table, found)
        table.message = None

    return take


def is_from(reception, system):
    """Return whether a system may send what a Reception takes."""
    if reception.sender == GROUND_STATION:
        return is_heard(reception.listeners, system)
    return reception.sender == ANY or system == reception.counts[3]
