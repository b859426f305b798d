# Generated from templates/firmware/adc_inputs.py: do not edit.
# Inputs: 0a36a5ee5548aaac
"""Inputs of the converter that measure one thing, of one instance or of several."""

from array import array

from micropython import const

_FAILURES = const(0)


class AdcInputs:
    """`counts` has four numbers of each: failed readings in a row, the longest time, the sum of all, how many.

    `name` is what texts call an input, with {} for the number of its instance; `pins` are the GPIO numbers, None for
    one that is left alone. `open_adc(gpio)` sets an input up, and `reading(read_u16, counts, fail)` makes what takes a
    reading of it, and times it. What is to be told of failures is in adc_faults.
    """

    def __init__(self, log, name, pins, open_adc, reading):
        self.counts = [array("I", (0, 0, 0, 0)) for _ in pins]
        self.given = log, name, pins, open_adc, reading
        self.readers = [None] * len(pins)
        self.tell = None
        for instance, gpio in enumerate(pins):
            if gpio is not None and not self.open(instance):
                self.fail(instance)
                self.counts[instance][_FAILURES] = 0  # no reading was tried yet

    def figures(self, instance=0):
        """Return failed readings in a row, the longest time in us, late ones included, and the mean of all times."""
        failures, longest_us, total_us, readings = self.counts[instance]
        return failures, longest_us, total_us // (readings or 1)

    def read(self, instance=0):
        """Return the mean of the samples as a count; -1 of a failed or late reading. It never raises."""
        try:
            return self.readers[instance]()
        except Exception:  # to keep it, or to do more here, would take heap at each call
            return self.fail(instance)

    def fail(self, instance, took=None):
        """Count a reading that failed, or that took so many us; return -1."""
        self.counts[instance][_FAILURES] += 1
        if self.tell is None:
            from adc_faults import AdcFaults  # noqa: PLC0415  most boards never need it

            self.tell = AdcFaults(self).tell
        return self.tell(instance, took)

    def open(self, instance):
        """Set an input up; return whether it is there."""
        _, _, pins, open_adc, reading = self.given
        try:
            read_u16 = open_adc(pins[instance]).read_u16
            self.readers[instance] = reading(read_u16, self.counts[instance], lambda took: self.fail(instance, took))
        except Exception:
            return False
        return True
