# Generated from specs/board.yaml, specs/state.yaml: do not edit.
# Inputs: ef67438766adcd14
"""What takes samples of each ADC and their mean, in plain Python, for ports without machine code."""

import time


def battery_reading(read_u16, failures, instance, fail):
    """Return what takes a reading by `read_u16`: the mean of 5 samples as a count, FR-00066.2; -1 of a late one."""
    ticks_us = time.ticks_us

    def reading():
        us = ticks_us()
        total = read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        us = ticks_us() - us & 0x3FFFFFFF  # one variable: with one more all would lie on the heap
        if us > 2000:
            return fail(instance, us)
        if failures[instance]:
            failures[instance] = 0
        return (total + 2) // 5

    return reading
