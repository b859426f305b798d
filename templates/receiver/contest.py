"""Detects two senders with the same ids that report one number: their reports alternate, as never after a swap."""

from readings import elapsed

_OWNERS = 4  # that are told apart
_TURNS = 8  # back to another series of sequence numbers: that is no accident
_AHEAD = 64  # frames that a sender may send, or lose, between two messages of a kind
_APART = 200  # a difference is one from this share of a value on
_STEADY = 4  # and so many times as large as what changes from one message of a sender to its next


class _Owner:
    """One that reported: its identity by kind of message, when it was heard last, and the swaps up to it."""

    def __init__(self, kinds, swaps):
        self.identities = [None] * kinds
        self.swaps = swaps
        self.heard_ms = None

    def is_heard(self, now_ms, within_ms):
        return self.heard_ms is not None and elapsed(now_ms, self.heard_ms) <= within_ms

    def fits(self, serial):
        """Tell whether messages of other kinds told this serial number; None if they told none.

        Messages cut serial numbers to different lengths.
        """
        if serial is None:
            return None
        known = [identity[0] for identity in self.identities if identity is not None and identity[0] is not None]
        found = [other for other in known if type(other) is type(serial)]
        return any(other.startswith(serial) or serial.startswith(other) for other in found) if known else None


class Owners:
    """The senders that report a number, told apart by serial numbers or, without these, counts of cycles.

    The first one is the one that the view is about. Another one takes its place; if the one before is heard again
    within `within_ms`, both are there, and it was no swap.
    """

    def __init__(self, kinds, within_ms):
        self._kinds = kinds
        self._within_ms = within_ms
        self._owners = [_Owner(kinds, 0)]
        self._last = self._owners[0]
        self._clash_ms = None  # when one was heard again after another one
        self.swaps = 0

    def is_clash(self, now_ms):
        """Tell whether two take turns now."""
        return self._clash_ms is not None and elapsed(now_ms, self._clash_ms) <= self._within_ms

    def has_serial(self):
        """Tell whether a serial number is known."""
        known = [identity for identity in self._owners[0].identities if identity is not None]
        return any(serial is not None for serial, _ in known)

    def serials(self, now_ms):
        """Return the serial numbers of those that are heard, in order."""
        found = []
        for owner in self._owners:
            known = [identity[0] for identity in owner.identities if identity is not None and identity[0]]
            if known and owner.is_heard(now_ms, self._within_ms):
                found.append(known[0])
        return sorted(found)

    def note(self, kind, serial, cycles, now_ms):
        """Take in what a message says of its sender; return whether it is another one than before."""
        first = self._owners[0]
        before = first.identities[kind]
        if before is not None and serial is None:
            serial = before[0]  # it was known: that it is left out once says nothing
        identity = (serial, cycles)
        owner = first
        if before is None or _is_other(before, identity):
            is_first = before is None and first.fits(serial) is not False
            owner = first if is_first else self._heard(kind, identity, now_ms)
        is_another = owner is not first and not first.is_heard(now_ms, self._within_ms)
        if owner is None:
            is_another = not self.is_clash(now_ms)
            owner = _Owner(self._kinds, self.swaps)
            self._owners.append(owner)
        elif not is_another and owner is not self._last:
            self._clash_ms = now_ms
        if is_another or owner.swaps < first.swaps:
            self._owners.remove(owner)
            self._owners.insert(0, owner)
            self.swaps = owner.swaps = self.swaps + 1 if is_another else owner.swaps
        owner.identities[kind] = identity
        owner.heard_ms = now_ms
        self._last = owner
        self._forget(now_ms)
        return is_another

    def _heard(self, kind, identity, now_ms):
        for owner in self._owners[1:]:
            if owner.is_heard(now_ms, self._within_ms):
                known = owner.identities[kind]
                if _is_the_same(known, identity) if known is not None else owner.fits(identity[0]):
                    return owner
        return None

    def _forget(self, now_ms):
        heard = [owner for owner in self._owners[1:] if owner.is_heard(now_ms, self._within_ms)]
        self._owners = self._owners[:1] + heard[: _OWNERS - 1]

    def keep_time(self, now_ms, most_ms):
        """Give up times that are so old that the clock would soon have started again."""
        if self._clash_ms is not None and elapsed(now_ms, self._clash_ms) > most_ms:
            self._clash_ms = None
        for owner in self._owners:
            if owner.heard_ms is not None and elapsed(now_ms, owner.heard_ms) > most_ms:
                owner.heard_ms = None


class Series:
    """The sequence numbers of one kind of message.

    Two senders have a series each, and values of their own: with each turn from one series to the other the number
    goes back, and a value is again what it was. One sender, however many of its frames are lost, goes on with one
    series; another one after it, or a restart, begins a second one and never goes back to the first.
    """

    def __init__(self):
        self._head = None  # sequence number, what was said, and the swaps before
        self._other = None  # where the other series stands
        self._apart = ()  # what differed with each turn
        self.turns = 0  # back to the other series
        self.swaps = 0  # before the other series began

    def note(self, sequence, said, swaps):
        """Take in a message; return whether two senders take turns."""
        new = (sequence, said, swaps)
        if self._head is not None and self._head[:2] == new[:2]:
            return False  # it came over two links
        goes_on = _ahead(self._head, sequence)
        apart = self._differing(said) if _ahead(self._other, sequence) else None
        if apart or (apart is not None and not goes_on):
            if not goes_on:  # one sender never goes back
                self._apart = [name for name in apart if not self.turns or name in self._apart]
                self.turns = self.turns + 1 if self._apart else 0
            self._other = self._head
        elif not goes_on and self._head is not None:
            self._other, self.turns = self._head, 0
            self.swaps = self._head[2]
        self._head = new
        return self.turns >= _TURNS and not goes_on

    def _differing(self, said):
        """Return the names of the values that fit the other series, and not the last values of this one."""
        return [name for name in said if _is_apart(said[name], self._other[1][name], self._head[1][name])]


def _is_other(before, identity):
    """Tell whether the serial number has changed or, without one, the count of cycles by more than one more."""
    if identity[0] is not None and before[0] is not None:
        return identity[0] != before[0]
    if identity[1] is not None and before[1] is not None:
        return not before[1] <= identity[1] <= before[1] + 1
    return False


def _is_the_same(known, identity):
    """Tell whether it is the very same one: a count of cycles alone says so only where none was added."""
    if identity[0] is None and known[0] is None:
        return identity[1] == known[1]
    return identity[0] == known[0]


def _ahead(head, sequence):
    """Return by how many frames a sequence number lies ahead; 0 if it does not, or so far that it says nothing."""
    ahead = 0 if head is None else (sequence - head[0]) & 0xFF
    return ahead if ahead <= _AHEAD else 0


def _is_apart(value, before, between):
    """Tell whether a value is much nearer to the one before than to the one in between."""
    for known in (value, before, between):
        if type(known) not in (int, float):
            return False
    return abs(value - between) > max(_STEADY * abs(value - before), abs(value) / _APART)
