# Generated from specs/board.yaml, specs/state.yaml, specs/smart_battery/board.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 48e9cf16cd5f28e3
"""Takes samples of each ADC and their mean, in plain Python, for ports without machine code."""

import time

from micropython import const

# Places in what is counted of each input, see adc_inputs.
_FAILURES = const(0)
_LONGEST_US = const(1)
_TOTAL_US = const(2)
_READINGS = const(3)
_LONG = const(0x1FFFFFFF)  # us, above which both sides of the mean are halved: the rest stays a small number


def battery_reading(read_u16, counts, fail):
    """Return what takes a reading by `read_u16`: the mean of 5 samples as a count, FR-00066.2; -1 of a late one."""
    ticks_us = time.ticks_us

    def reading():
        us = ticks_us()
        total = read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        us = ticks_us() - us & 0x3FFFFFFF  # one variable: with more of them all would lie on the heap
        if us > counts[_LONGEST_US]:
            counts[_LONGEST_US] = us
        counts[_TOTAL_US] += us
        counts[_READINGS] += 1
        if counts[_TOTAL_US] > _LONG:
            counts[_TOTAL_US] >>= 1
            counts[_READINGS] >>= 1
        if us > 2000:
            return fail(us)
        counts[_FAILURES] = 0
        return (total + 2) // 5

    return reading
