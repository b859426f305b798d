"""Pins of a host with interrupts: pulse() lets pulses arrive at one. machine.Pin is this class."""

import machine
import mock_time

_pins = {}


class Pin(machine.Pin):
    """A pin that calls what irq() was given at each edge."""

    def __init__(self, id, *arguments, **named):  # noqa: A002 - the board's own argument name
        machine_pin.__init__(self, id, *arguments, **named)
        _pins[id] = self

    def change(self, level):
        """Let the level at the pin become another one."""
        if level != self._level:
            self._level = level
            if self.handler is not None and self.trigger & (1 if level else 2):
                self.handler(self)


def pulse(gpio, high_us, low_us, count=1):
    """Let so many pulses arrive: high for so many microseconds, then low."""
    for _ in range(count):
        _pins[gpio].change(1)
        mock_time.advance_us(high_us)
        _pins[gpio].change(0)
        mock_time.advance_us(low_us)


machine_pin = machine.Pin
machine.Pin = Pin
