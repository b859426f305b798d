"""Sensors that speak by themselves, such as one on a UART: they have a turn only while something waits.

Their drivers have `waiting`, a function that tells how much waits, from begin() on. One that has been silent for
`silence_ms` has failed.
"""

import time

from polling import Fault, Poller


class Listener(Poller):
    """A sensor that speaks by itself; watch(now_ms) is called once a second."""

    def __init__(self, silence_ms, *arguments):
        Poller.__init__(self, *arguments)
        self._silence_ms = silence_ms
        self._heard_ms = 0
        self._calls = [self.turn]
        self._place = 0

    def listen(self, turns, place):
        """Have `waiting` in the place of its turn while it is set up; its turn comes after that (see asking())."""
        self._calls = turns
        self._place = place

    def watch(self, now_ms):
        """Count a failure while nothing arrives."""
        if not self.is_down and not 0 <= time.ticks_diff(now_ms, self._heard_ms) <= self._silence_ms:
            self.fail(Fault("nothing arrives"), now_ms)

    def _works(self):
        self._heard_ms = time.ticks_ms()
        Poller._works(self)

    def _is_set_up(self, now_ms):
        is_set_up = Poller._is_set_up(self, now_ms)
        if is_set_up:
            self._heard_ms = now_ms
            self._calls[self._place] = self.driver.waiting
        return is_set_up

    def _go_down(self, now_ms):
        Poller._go_down(self, now_ms)
        self._calls[self._place] = self.turn
