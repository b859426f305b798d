# Generated from specs/board.yaml, specs/state.yaml, specs/smart_battery/board.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 48e9cf16cd5f28e3
"""Samples of each ADC and their mean, by MicroPython's viper emitter; samples_plain is the same in Python."""

# ptr32 is viper's own name.
# ruff: noqa: F821

import time

import micropython
from micropython import const

# Places in what is counted of each input, see adc_inputs.
_FAILURES = const(0)
_LONGEST_US = const(1)
_TOTAL_US = const(2)
_READINGS = const(3)
_LONG = const(0x1FFFFFFF)  # us, above which both sides of the mean are halved: the rest stays a small number


@micropython.viper
def _has_machine_code():
    """Is here to end the import of this module where there is none: the functions below are made later."""


def battery_reading(read_u16, counts, fail):
    """Return what takes a reading by `read_u16`: the mean of 5 samples as a count, FR-00066.2; -1 of a late one."""
    ticks_us = time.ticks_us

    @micropython.viper
    def reading() -> int:
        counted = ptr32(counts)
        started = int(ticks_us())
        total = int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        took = int(ticks_us()) - started & 0x3FFFFFFF
        if took > counted[_LONGEST_US]:
            counted[_LONGEST_US] = took
        counted[_TOTAL_US] += took
        counted[_READINGS] += 1
        if counted[_TOTAL_US] > _LONG:
            counted[_TOTAL_US] >>= 1
            counted[_READINGS] >>= 1
        if took > 2000:
            return int(fail(took))
        counted[_FAILURES] = 0
        return (total + 2) // 5

    return reading
