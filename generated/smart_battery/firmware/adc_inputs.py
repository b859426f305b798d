# Generated from templates/firmware/adc_inputs.py: do not edit.
# Inputs: 0a140ef1e45b1f3f
"""Inputs of the converter that measure one thing, of one instance or of several."""


class AdcInputs:
    """`failures` are failed readings in a row, of each. What is to be told of them is in adc_faults.

    `name` is what texts call an input, with {} for the number of its instance; `pins` are the GPIO numbers, None for
    one that is left alone. `open_adc(gpio)` sets an input up, and `reading(read_u16, failures, instance, fail)` makes
    what takes a reading of it.
    """

    def __init__(self, log, name, pins, open_adc, reading):
        self.failures = [0] * len(pins)
        self.given = log, name, pins, open_adc, reading
        self.readers = [None] * len(pins)
        self.tell = None
        for instance, gpio in enumerate(pins):
            if gpio is not None and not self.open(instance):
                self.fail(instance)
                self.failures[instance] = 0  # no reading was tried yet

    def read(self, instance=0):
        """Return the mean of the samples as a count; -1 of a failed or late reading. It never raises."""
        try:
            return self.readers[instance]()
        except Exception:  # to keep it, or to do more here, would take heap at each call
            return self.fail(instance)

    def fail(self, instance, took=None):
        """Count a reading that failed, or that took so many us; return -1."""
        self.failures[instance] += 1
        if self.tell is None:
            from adc_faults import AdcFaults  # noqa: PLC0415  most boards never need it

            self.tell = AdcFaults(self).tell
        return self.tell(instance, took)

    def open(self, instance):
        """Set an input up; return whether it is there."""
        _, _, pins, open_adc, reading = self.given
        try:
            self.readers[instance] = reading(open_adc(pins[instance]).read_u16, self.failures, instance, self.fail)
        except Exception:
            return False
        return True
