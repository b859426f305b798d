"""Who listens at the other end of a link: the ground stations, and all components, whose HEARTBEAT arrives."""

from array import array
from time import ticks_diff

from micropython import const

_PLACES = const(4)  # ground stations that are told apart; of more, the one silent for longest is forgotten


class Listeners:
    """Ground stations or components of one link; one that is silent for `silence_ms` is gone.

    `names` has system << 8 | component of each, and 0 for nobody. There are as many places as ground stations need.
    """

    def __init__(self, silence_ms, places=_PLACES):
        self._silence_ms = silence_ms
        self.names = array("H", [0] * places)
        self._heard_ms = [0] * places
        self._last = 0  # the place of who was heard last

    def hear(self, name, now_ms):
        """Note a HEARTBEAT; return whether it is the first of its sender, or the first after a silence.

        Who takes the place of another is not called new: of more senders than places each would be, again and again.
        """
        place = self._last
        if self.names[place] != name:
            place = self._place(name)
            if place < 0:
                return self._take_place(name, now_ms)
            self._last = place
        is_new = ticks_diff(now_ms, self._heard_ms[place]) >= self._silence_ms
        self._heard_ms[place] = now_ms
        return is_new

    def forget_silent(self, now_ms):
        """Forget those who are gone; now and then, for clocks of boards start again after 12 days."""
        for place in range(len(self.names)):
            if self.names[place]:
                self._forget_if_silent(place, now_ms)

    def _forget_if_silent(self, place, now_ms):
        if self._age_ms(place, now_ms) >= self._silence_ms:
            self.names[place] = 0

    def _take_place(self, name, now_ms):
        self.forget_silent(now_ms)
        oldest = 0
        for place in range(len(self.names)):
            if self._age_ms(place, now_ms) > self._age_ms(oldest, now_ms):
                oldest = place
        is_new = self.names[oldest] == 0
        self.names[oldest] = name
        self._heard_ms[oldest] = now_ms
        return is_new

    def _place(self, name):
        """Return where somebody is, -1 for nowhere."""
        place = 0
        for known in self.names:
            if known == name:
                return place
            place += 1  # noqa: SIM113  enumerate() takes heap
        return -1

    def _age_ms(self, place, now_ms):
        return ticks_diff(now_ms, self._heard_ms[place]) if self.names[place] else 0x3FFFFFFF
