# Generated from templates/firmware/program/listeners.py: do not edit.
# Inputs: 22b4c90c0e8a7608
"""The listeners at the other end of a link: ground stations and other components, known by their HEARTBEAT."""

from array import array
from time import ticks_diff

from micropython import const

_PLACES = const(4)  # ground stations that are told apart; of more, the one silent for longest is forgotten


class Listeners:
    """Ground stations or other components of one link; one that is silent for `silence_ms` is gone.

    `names` has system << 8 | component of each, and 0 for nobody. There are as many places as ground stations need.
    `last` is the name of the one that was heard last, or 0 if it is gone, and `heard_ms` when that was, None before
    anybody was. Most often the same one is heard again: who finds that it was not silent has only to set `heard_ms`.
    """

    def __init__(self, silence_ms, places=_PLACES):
        self.silence_ms = silence_ms
        self.names = array("H", [0] * places)
        self.last = 0
        self.heard_ms = None
        self._heard_ms = [0] * places  # that of the last one counts when another one is heard
        self._place = 0

    def hear(self, name, now_ms):
        """Note a HEARTBEAT; return whether it is the first of its sender, or the first after a silence.

        Who takes the place of another is not called new: of more senders than places each would be, again and again.
        """
        self._keep()
        place = self._find(name)
        if place >= 0:
            is_new = self._age_ms(place, now_ms) >= self.silence_ms
        else:
            place = self._oldest(now_ms)
            is_new = self.names[place] == 0
            self.names[place] = name
        self._place = place
        self._heard_ms[place] = self.heard_ms = now_ms
        self.last = name
        return is_new

    def forget_silent(self, now_ms):
        """Forget those who are gone; now and then, for clocks of boards start again after 12 days."""
        self._keep()
        for place in range(len(self.names)):
            if self.names[place] and self._age_ms(place, now_ms) >= self.silence_ms:
                self.names[place] = 0
                if place == self._place:
                    self.last = 0

    def _keep(self):
        if self.last:
            self._heard_ms[self._place] = self.heard_ms

    def _oldest(self, now_ms):
        """Return the place of nobody, or else of who is silent for longest."""
        self.forget_silent(now_ms)
        oldest = 0
        for place in range(len(self.names)):
            if self._age_ms(place, now_ms) > self._age_ms(oldest, now_ms):
                oldest = place
        return oldest

    def _find(self, name):
        """Return where somebody is, -1 for nowhere."""
        place = 0
        for known in self.names:
            if known == name:
                return place
            place += 1  # noqa: SIM113  enumerate() takes heap
        return -1

    def _age_ms(self, place, now_ms):
        return ticks_diff(now_ms, self._heard_ms[place]) if self.names[place] else 0x3FFFFFFF
