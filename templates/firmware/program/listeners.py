"""Who listens at the other end of a link: the ground stations whose HEARTBEAT arrives."""

import time
from array import array

from micropython import const

_STATIONS = const(4)  # that are told apart; of more, the one that has been silent for longest is forgotten


class Listeners:
    """Ground stations of one link; one that is silent for `silence_ms` is gone.

    `names` has system << 8 | component of each, and 0 for nobody.
    """

    def __init__(self, silence_ms):
        self._silence_ms = silence_ms
        self.names = array("H", [0] * _STATIONS)
        self._heard_ms = [0] * _STATIONS

    def hear(self, system, component, now_ms):
        """Note a HEARTBEAT; return whether it is the first of this ground station, or the first after a silence."""
        self.forget_silent(now_ms)
        name = system << 8 | component
        oldest = 0
        for place in range(_STATIONS):
            if self.names[place] == name:
                self._heard_ms[place] = now_ms
                return False
            if self._age_ms(place, now_ms) > self._age_ms(oldest, now_ms):
                oldest = place
        self.names[oldest] = name
        self._heard_ms[oldest] = now_ms
        return True

    def forget_silent(self, now_ms):
        """Forget who is gone; call it at least once in a few days, since clocks of boards start again after 12."""
        for place in range(_STATIONS):
            if self.names[place] and self._age_ms(place, now_ms) >= self._silence_ms:
                self.names[place] = 0

    def _age_ms(self, place, now_ms):
        return time.ticks_diff(now_ms, self._heard_ms[place]) if self.names[place] else 0x3FFFFFFF
