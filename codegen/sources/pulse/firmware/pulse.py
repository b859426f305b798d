"""Pulses at a digital input: how many, how often, and how long the last one was."""

import time
from array import array

import machine
from micropython import const
from polling import UNKNOWN

_COUNT = const(0)  # places in `values`
_FREQUENCY = const(1)
_WIDTH = const(2)
_PULSES = const(0)  # places in what the interrupts keep
_ROSE_US = const(1)
_FELL_US = const(2)
_LONGEST_US = const(100000000)  # between two pulses


class Pulse:
    """The pulses at an input; without one for `gate_ms` the frequency is 0, and the width unknown.

    `opened` opens the pin. They are counted up to 2 ** 30, and then from 0.
    """

    def __init__(self, opened, gate_ms):
        self.values = array("i", [UNKNOWN] * 3)
        self._opened = opened
        self._gate_ms = gate_ms
        self._edges = array("i", [0, 0, 0])
        self._seen = 0  # pulses at the last turn that had new ones
        self._seen_us = 0  # when the last of them began
        self._seen_ms = 0
        self._is_first = True
        self._pin = None

    def begin(self):
        """Open the pin, and count from here on."""
        self._pin = self._opened()
        self._is_first = True
        self._seen = self._edges[_PULSES]
        self._pin.irq(self._edge, machine.Pin.IRQ_RISING | machine.Pin.IRQ_FALLING)

    def poll(self, now_ms):
        """Work out what the pulses since the last turn say."""
        edges, values = self._edges, self.values
        pulses = edges[_PULSES]
        rose_us = edges[_ROSE_US]
        while pulses != edges[_PULSES]:  # one came in between
            pulses = edges[_PULSES]
            rose_us = edges[_ROSE_US]
        values[_COUNT] = pulses
        new = pulses - self._seen & 0x3FFFFFFF
        if new:
            if not self._is_first:
                self._work_out(new, time.ticks_diff(rose_us, self._seen_us))
            self._is_first = False
            self._seen = pulses
            self._seen_us = rose_us
            self._seen_ms = now_ms
        elif not 0 <= time.ticks_diff(now_ms, self._seen_ms) < self._gate_ms:
            self._is_first = True
            self._seen_ms = now_ms - self._gate_ms & 0x3FFFFFFF
            values[_FREQUENCY] = 0
            values[_WIDTH] = UNKNOWN
        return True

    def _work_out(self, new, span_us):
        """Work out the frequency of pulses in a span, in mHz, digit by digit, so that no number passes 30 bits."""
        self.values[_WIDTH] = self._width()
        if not 2 * new < span_us < _LONGEST_US:
            self.values[_FREQUENCY] = UNKNOWN  # faster than it can be counted, or nearly none
            return
        frequency = 0
        for _ in range(9):
            new *= 10
            frequency = frequency * 10 + new // span_us
            new %= span_us
        self.values[_FREQUENCY] = frequency

    def _width(self):
        """The last pulse that has ended, in us: one that goes on says nothing yet."""
        width_us = time.ticks_diff(self._edges[_FELL_US], self._edges[_ROSE_US])
        return width_us if width_us > 0 else self.values[_WIDTH]

    def _edge(self, pin):
        """Count; called by the interrupt, where nothing must need the heap."""
        edges = self._edges
        if pin.value():
            edges[_ROSE_US] = time.ticks_us()
            edges[_PULSES] = edges[_PULSES] + 1 & 0x3FFFFFFF
        else:
            edges[_FELL_US] = time.ticks_us()
