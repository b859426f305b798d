"""The view of one instance, from all messages that report it."""

from consumption import Consumption
from contest import Owners, Series
from readings import elapsed

_TOGETHER_MS = 1000  # pages that belong together follow each other as fast
_COUNTED_AH = 0.01  # with less a count that begins anew is not told from noise
_LONG_AGO_MS = 1 << 28  # three days: later the clock would have started again


class View:
    """One instance, as a system reports it by its number.

    Quantities are None while unknown: because the wire says so, because no message came that carries them, or because
    the last one is too old. Where several messages carry a quantity, the preferred one of those that are not too old
    decides. Times are those that the receiver was given, or its clock's.
    """

    MESSAGES = ()  # names, by kind
    STALE_MS = ()  # age by kind from which on a message counts no more
    SILENT_MS = 0  # time without any message after which nothing is known
    WINDOW_MS = 0  # time over which the current is averaged
    CARRIERS = {}  # kinds of message that carry a quantity, the preferred one first
    FLAGS = ()  # names of the bitmasks
    IS_COUNTED_ANEW = False  # whether what was drawn counts from 0 with another one
    ROLES = {}  # what plays a role for the time that remains: names, the first known one counts, and factors to A or Ah

    def __init__(self, receiver, system, number):
        self.system = system
        self.number = number
        self._receiver = receiver
        self._said = [None] * len(self.MESSAGES)
        self._heard_ms = [None] * len(self.MESSAGES)
        self._last_ms = None
        self._sources = {}
        self._owners = Owners(len(self.MESSAGES), max(self.STALE_MS))
        self._series = [Series() for _ in self.MESSAGES]
        self._clash_ms = None  # when two series of sequence numbers took turns
        self._consumption = Consumption(self.WINDOW_MS, self.SILENT_MS)

    def __repr__(self):
        state = ", stale" if self.is_stale() else ", contested" if self.is_contested else ""
        return f"{type(self).__name__}(system={self.system}, number={self.number}{state})"

    @property
    def components(self):
        """The component ids that reported it, as a tuple in rising order."""
        return tuple(sorted(self._sources))

    @property
    def flags(self):
        """The names of the flags that are set in any of the bitmasks, as a tuple; None while all are unknown."""
        known = [names for names in [self._quantity(name) for name in self.FLAGS] if names is not None]
        return tuple([name for names in known for name in names]) if known else None

    @property
    def swaps(self):
        """Return how often another one took the place of what was reported before."""
        return self._owners.swaps

    @property
    def is_contested(self):
        """Return whether two report the same number now, so that their reports get mixed up: see contest."""
        return self.contest is not None

    @property
    def contest(self):
        """Return the senders that report the same number now, as a text for people; None where it is not contested."""
        now_ms = self._receiver.now_ms()
        sources = [source for source, heard in self._sources.items() if elapsed(now_ms, heard) <= self.SILENT_MS]
        if len(sources) > 1:
            return "reported by components " + ", ".join([str(source) for source in sorted(sources)])
        if not self._is_clash(now_ms):
            return None
        serials = self._owners.serials(now_ms)
        text = "reported by several" + "".join([f" as component {source}" for source in sources])
        return text + ": serial numbers " + ", ".join(serials) if len(serials) > 1 else text

    def _is_clash(self, now_ms):
        """Tell whether two with the same ids take turns."""
        clash_ms = self._clash_ms
        return self._owners.is_clash(now_ms) or (clash_ms is not None and elapsed(now_ms, clash_ms) <= self.SILENT_MS)

    @property
    def messages(self):
        """The names of the messages that count now, as a tuple."""
        return tuple([name for kind, name in enumerate(self.MESSAGES) if self._counts(kind)])

    def age_ms(self, now_ms=None, of=None):
        """Return the milliseconds since the last message; None after three days.

        `of` is the name of a quantity: since the message that says it came, None while it is unknown.
        """
        heard_ms = self._last_ms if of is None else self._heard_of(of)
        if heard_ms is None:
            return None
        return elapsed(self._receiver.now_ms() if now_ms is None else now_ms, heard_ms)

    def _heard_of(self, name):
        for kind in self.CARRIERS[name]:
            if self._counts(kind):
                return None if self._said[kind][name] is None else self._heard_ms[kind]
        return None

    def is_stale(self, now_ms=None):
        """Tell whether so long nothing came that nothing is known any more."""
        age_ms = self.age_ms(now_ms)
        return age_ms is None or age_ms > self.SILENT_MS

    @property
    def is_charging(self):
        """Return whether it is charging, by its own report or by its mean current; None while unknown."""
        charging = self._known("charging")
        mean_a = self.mean_current_a
        return charging if charging or mean_a is None else mean_a < 0

    @property
    def mean_current_a(self):
        """The mean current of the last while, in A; from the charge consumed where no current is known."""
        return None if self.is_stale() else self._consumption.mean_a()

    @property
    def charge_left_ah(self):
        """The charge that is left, in Ah: the first of these that is known.

        The charge left, as it is reported; the full charge times the percentage left; what was consumed, p % being
        left: consumed * p / (100 - p); the full charge less what was consumed. The last two take it that the count
        began when it was full.
        """
        left = self._known("left")
        if left is not None:
            return left
        percent, full, consumed = self._known("percent"), self._known("full"), self._known("consumed")
        if percent is not None and full is not None:
            return full * percent / 100
        if percent is not None and consumed is not None and 0 <= percent < 100 and consumed > 0:
            return consumed * percent / (100 - percent)
        if full is not None and consumed is not None:
            return max(full - consumed, 0)
        return None

    def time_left_s(self, now_ms=None):
        """Return the seconds that the charge left lasts at the mean current; None while charging, idle or unknown.

        A time that is given is told to the receiver, as by feed().
        """
        if now_ms is not None:
            self._receiver.tell(now_ms)
        if self._known("charging"):
            return None
        return seconds(self.charge_left_ah, self.mean_current_a)

    def take(self, kind, said, source, sequence, now_ms):
        """Take in what a message of a kind said, from a component with a sequence number."""
        series = self._series[kind]
        if series.note(sequence, said, self.swaps):
            self._clash_ms = now_ms
            self._owners.swaps = min(self.swaps, series.swaps)  # what looked like swaps were none
        if self._is_another(kind, said, now_ms) or self._begins_anew(kind, said, now_ms):
            self._said = [None] * len(self.MESSAGES)
            self._heard_ms = [None] * len(self.MESSAGES)
            self._consumption.forget()
        self._keep_pages(kind, said, now_ms)
        self._said[kind] = said
        self._heard_ms[kind] = self._last_ms = now_ms
        self._sources[source] = now_ms
        self._consumption.note(now_ms, self._known("current"), self._known("consumed"))

    def _keep_pages(self, kind, said, now_ms):
        """Add the pages that came just before, unless one of them is about the same values: it begins anew then."""
        before, heard_ms = self._said[kind], self._heard_ms[kind]
        if before is None or heard_ms is None or elapsed(now_ms, heard_ms) > _TOGETHER_MS:
            return
        for name, value in said.items():
            if isinstance(value, dict):
                pages = before[name]
                told = [(first, first + len(values)) for first, values in value.items()]
                if not [other for other in pages for at, end in told if at - len(pages[other]) < other < end]:
                    value.update(pages)

    def keep_time(self, now_ms):
        """Give up what is so old that the clock would soon have started again."""
        for kind, heard in enumerate(self._heard_ms):
            if heard is not None and elapsed(now_ms, heard) > _LONG_AGO_MS:
                self._heard_ms[kind] = None
        if self._last_ms is not None and elapsed(now_ms, self._last_ms) > _LONG_AGO_MS:
            self._last_ms = None
        if self._clash_ms is not None and elapsed(now_ms, self._clash_ms) > _LONG_AGO_MS:
            self._clash_ms = None
        self._owners.keep_time(now_ms, _LONG_AGO_MS)
        for source in [source for source, heard in self._sources.items() if elapsed(now_ms, heard) > _LONG_AGO_MS]:
            del self._sources[source]

    def _is_another(self, kind, said, now_ms):
        """Tell whether it was swapped, by its serial number or, without one, its cycles.

        Messages cut serial numbers to different lengths: so each is compared with the last one of its kind.
        """
        serial = self._said_as("serial", said)
        cycles = self._said_as("cycles", said)
        if serial is None and cycles is None:
            return False
        return self._owners.note(kind, serial, cycles, now_ms)

    def _begins_anew(self, kind, said, now_ms):
        """Tell whether what was drawn counts from 0 again: less than a tenth of what the same message said before.

        One with a serial number is told by that alone, and of two that take turns neither begins anew.
        """
        before = self._said[kind]
        if not self.IS_COUNTED_ANEW or before is None or self._owners.has_serial() or self._is_clash(now_ms):
            return False
        for name, factor in self.ROLES.get("consumed", ()):
            if said.get(name) is not None and before[name] is not None:
                if before[name] * factor >= _COUNTED_AH and said[name] * 10 < before[name]:
                    self._owners.swaps += 1
                    return True
                return False
        return False

    def _said_as(self, role, said):
        for name, _ in self.ROLES.get(role, ()):
            if said.get(name) is not None:
                return said[name]
        return None

    def _known(self, role):
        """Return what plays a role, in A, Ah or %; None without such, or while it is unknown."""
        for name, factor in self.ROLES.get(role, ()):
            value = self._fact(name) if name.startswith("info.") else self._quantity(name)
            if value is not None:
                return value if factor == 1 else value * factor
        return None

    def _counts(self, kind):
        heard = self._heard_ms[kind]
        if heard is None or self.is_stale():
            return False
        return elapsed(self._receiver.now_ms(), heard) <= self.STALE_MS[kind]

    def _quantity(self, name):
        for kind in self.CARRIERS[name]:
            if self._counts(kind):
                return self._said[kind][name]
        return None

    def _elements(self, name):
        """Return one value for each element, None for those that are unknown, or None as a whole.

        A message that has room for all of them decides as long as it has them: as many as are known to be, or without
        that knowledge more than one, for a single value is more likely that of the whole. Otherwise the pages do that
        have come.
        """
        count = self._known("count")
        pages = None
        for kind in self.CARRIERS[name]:
            said = self._said[kind][name] if self._counts(kind) else None
            if isinstance(said, dict):
                pages = said
            elif said is not None and (len(said) == count if count else len(said) > 1):
                return said
        return None if pages is None else joined_pages(pages, count)

    def _fact(self, name):
        """Return what does not change as long as it is the same one, however long ago it was said."""
        for kind in self.CARRIERS[name]:
            said = self._said[kind]
            if said is not None and said[name] is not None:
                return said[name]
        return None


class Info:
    """The values that do not change as long as it is the same one."""

    def __init__(self, view):
        self._fact = view._fact


def joined_pages(pages, count):
    """Return the values of all pages, `count` of them or up to the last one that is known; None if none is."""
    found = []
    for first in sorted(pages):
        found = found[:first] + [None] * (first - len(found)) + list(pages[first])
    if count:
        found = (found + [None] * count)[:count]
    while found and found[-1] is None and not count:
        found.pop()
    return tuple(found) if any(value is not None for value in found) else None


def seconds(charge_ah, current_a):
    """Return the seconds that a charge lasts at a current; None where one is unknown or nothing is drawn."""
    if charge_ah is None or current_a is None or current_a <= 0:
        return None
    return max(charge_ah, 0) * 3600 / current_a
