# Generated from templates/firmware/trend.py: do not edit.
# Inputs: f9d47441c0c1f7a6
"""How fast a quantity changes, from readings at equal intervals, in whole numbers."""

from array import array

from conversion import nearest


class Trend:
    """The change per second over the last 2 * `half` readings.

    The sum of the newer half is compared with the sum of the older one; the difference times numerator / denominator is
    the change. A ramp gives its slope exactly, and the noise of single readings hardly counts.
    """

    def __init__(self, half, numerator, denominator):
        self._half = half
        self._numerator = numerator
        self._denominator = denominator
        self._readings = array("i", [0] * (2 * half))
        self.forget()

    def forget(self):
        """Start anew: a reading is missing."""
        self._count = 0
        self._newer = 0  # sums of the two halves
        self._older = 0

    def after(self, value):
        """Take in a reading; return the change in steps per second, None until there are enough readings."""
        half = self._half
        count = self._count
        readings = self._readings
        at = count % (2 * half)
        if count >= 2 * half:
            self._older -= readings[at]
        if count >= half:
            middle = readings[(at + half) % (2 * half)]
            self._newer -= middle
            self._older += middle
        self._newer += value
        readings[at] = value
        # Small for ever, and still at the same place of the ring.
        self._count = count + 1 if count < 4 * half - 1 else 2 * half
        return self._slope() if self._count >= 2 * half else None

    def _slope(self):
        return nearest(self._newer - self._older, self._numerator, self._denominator)
