# Generated from templates/firmware/adc_faults.py: do not edit.
# Inputs: ccab546c0d8860e7
"""Texts about inputs of the converter that fail, and how they come back; loaded with the first fault."""

import time

from micropython import const

_QUIET_MS = const(10000)  # between two texts about one input
_TICKS = const(0x3FFFFFFF)


class AdcFaults:
    """The first fault of an input is told at once, and then one every 10 s at most, with how many there were since.

    The first late reading is told in any case. An input that could not be set up is tried again before each text.
    """

    def __init__(self, inputs):
        count = len(inputs.counts)
        self._inputs = inputs
        self._told_ms = [None] * count
        self._untold = [0] * count
        self._was_late = [False] * count

    def tell(self, instance, took):
        """Tell of a failed reading, unless there was a text just now; return -1."""
        told_ms = self._told_ms[instance]
        is_first_late = took is not None and not self._was_late[instance]
        if told_ms is not None and time.ticks_ms() - told_ms & _TICKS < _QUIET_MS and not is_first_late:
            self._untold[instance] += 1
            return -1
        untold = self._untold[instance]
        self._told_ms[instance] = time.ticks_ms()
        self._untold[instance] = 0
        self._was_late[instance] = took is not None
        log, name, pins, _, _ = self._inputs.given
        name = name.format(instance + 1)
        gpio = pins[instance]
        if took is not None:
            text = f"error: {name}'s ADC took too long to read, in us: {took}"
        elif self._inputs.readers[instance] is not None:
            text = f"error: {name}'s ADC cannot be read"
        elif self._inputs.open(instance):
            text = f"notice: {name} is read on GPIO {gpio} again"
        else:
            text = f"warning: no ADC for {name} on GPIO {gpio}"
        log(f"{text} ({untold} more)" if untold else text)
        return -1
