"""The wind vane: a potentiometer that turns with the wind, and cups that close a contact once in each turn."""

import time

from machine import ADC, Pin

_METRES = 1.006  # of wind pass while the cups turn once
_FULL = 65536


class Vane:
    """Reads speed and angle of the wind; `sources: vane` of specs/board.yaml asks for them."""

    def __init__(self):
        self._pot = ADC(Pin(34))
        self._turns = 0
        self._counted = 0
        self._since_ms = time.ticks_ms()
        Pin(27, Pin.IN, Pin.PULL_UP).irq(self._turned, Pin.IRQ_FALLING)

    def _turned(self, _pin):
        self._turns = (self._turns + 1) & 0x3FFFFFFF

    def read(self):
        """Return the speed in m/s, and where the wind comes from: degrees from the bow, clockwise."""
        now_ms = time.ticks_ms()
        passed_ms = max(1, time.ticks_diff(now_ms, self._since_ms))
        turns = self._turns
        speed = ((turns - self._counted) & 0x3FFFFFFF) * 1000 * _METRES / passed_ms
        if passed_ms > 2000:  # in a light wind a turn takes longer than the time between two readings
            self._since_ms, self._counted = now_ms, turns
        return speed, self._pot.read_u16() * 360 / _FULL
