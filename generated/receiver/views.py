# Generated from templates/receiver/views.py: do not edit.
# Inputs: f0355a639ddbb24b
"""Turns bytes into views: one for each number of each system, whichever messages report it."""

from readings import finite
from receiver import Receiver
from view import seconds


class Views:
    """The views of everything that reports. A subclass says what it understands.

    `now` returns the time in milliseconds, such as time.ticks_ms; without it the time is the last one that feed() or
    handle() was told. There are at most `most` views, so that nobody fills the memory by making numbers up: one more
    takes the place of the one that is stale for longest, and is left out, and counted in `refused`, while none is.
    Signatures are not checked: parse frames with a codec's Link(signing=...) and give the messages
    to handle() where they have to be.
    """

    VIEW = None  # class of a view
    READERS = ()  # by kind of message: its class, the field with the number, and what reads its fields

    def __init__(self, now=None, most=32):
        self._clock = now
        self._most = most
        self.refused = 0
        self._told_ms = 0
        self._views = {}
        self._kinds = {cls.ID: kind for kind, (cls, _, _) in enumerate(self.READERS)}
        self.receiver = Receiver([cls(unknown=False) for cls, _, _ in self.READERS])

    def now_ms(self):
        """Return the time in milliseconds."""
        return self._told_ms if self._clock is None else self._clock()

    def tell(self, now_ms=None):
        """Take in the time, where nothing else came; at least once in three days."""
        if now_ms is not None:
            self._told_ms = now_ms
        now_ms = self.now_ms()
        for view in self._views.values():
            view.keep_time(now_ms)

    def feed(self, data, now_ms=None):
        """Take in bytes as they come, in pieces of any size; None is no data. Return how many messages they completed.

        Whatever is no frame of these messages is passed over; `receiver` counts it.
        """
        self.tell(now_ms)
        count = 0
        self.receiver.put(data)
        message = self.receiver.receive()
        while message is not None:
            count += self._take(message) is not None
            message = self.receiver.receive()
        return count

    def handle(self, message, now_ms=None):
        """Take in a message that was decoded already; return its view, or None if the message is of no concern.

        None, too, where there is no room for another view.
        """
        self.tell(now_ms)
        return self._take(message)

    def views(self):
        """Return the views in the order of system and number."""
        return [self._views[key] for key in sorted(self._views)]

    def view(self, system, number):
        """Return the view of a number of a system; None while nothing has come."""
        return self._views.get((system, number))

    def total_time_left_s(self, system, numbers=None, now_ms=None):
        """Return the seconds that what a system has lasts together: the sum of charges over the sum of currents.

        `numbers` are those that feed the same consumers; without it all of the system do that are not stale. None if
        nothing is drawn, if there is none of them, or if the charge or the current of one is unknown.
        """
        if now_ms is not None:
            self.tell(now_ms)
        charge_ah = current_a = 0
        if numbers is None:
            numbers = [view.number for view in self.views() if view.system == system and not view.is_stale()]
        for number in numbers:
            view = self.view(system, number)
            charge = None if view is None or view.is_stale() else view.charge_left_ah
            current = None if charge is None else view.mean_current_a
            if current is None:
                return None
            charge_ah += charge
            current_a += current
        return seconds(charge_ah, current_a)

    def _take(self, message):
        kind = self._kinds.get(message.ID)
        if kind is None:
            return None
        _, field, read = self.READERS[kind]
        key = (message.source_system, message.raw(field))
        view = self._views.get(key)
        if view is None:
            if not self._has_room():
                self.refused += 1
                return None
            view = self._views[key] = self.VIEW(self, *key)
        source, sequence = message.source_component, message.source_sequence
        view.take(kind, finite(read(message)), source, sequence, self.now_ms())
        return view

    def _has_room(self):
        """Tell whether there may be another view; the one that is stale for longest makes room."""
        if len(self._views) < self._most:
            return True
        oldest, oldest_ms = None, -1
        for key, view in self._views.items():
            age_ms = view.age_ms()
            if age_ms is None:  # for days
                oldest = key
                break
            if view.is_stale() and age_ms > oldest_ms:
                oldest, oldest_ms = key, age_ms
        if oldest is None:
            return False
        del self._views[oldest]
        return True
