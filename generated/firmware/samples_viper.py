# Generated from specs/board.yaml, specs/state.yaml: do not edit.
# Inputs: ef67438766adcd14
"""Samples of each ADC and their mean, by MicroPython's viper emitter; samples_plain is the same in Python."""

import time

import micropython


@micropython.viper
def _has_machine_code():
    """Is here to end the import of this module where there is none: the functions below are made later."""


def battery_reading(read_u16, failures, instance, fail):
    """Return what takes a reading by `read_u16`: the mean of 5 samples as a count, FR-00066.2; -1 of a late one."""
    ticks_us = time.ticks_us

    @micropython.viper
    def reading() -> int:
        started = int(ticks_us())
        total = int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        total += int(read_u16()) >> 4
        took = int(ticks_us()) - started & 0x3FFFFFFF
        if took > 2000:
            return int(fail(instance, took))
        if failures[instance]:
            failures[instance] = 0
        return (total + 2) // 5

    return reading
