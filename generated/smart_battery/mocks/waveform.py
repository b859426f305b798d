# Generated from templates/mocks/waveform.py: do not edit.
# Inputs: a531785d9b2d25f6
"""The battery of a scenario: its true voltage over time, and the counts that an ADC makes of it."""

FULL_SCALE = 4095  # counts of the 12 bit converter


class Waveform:
    """The pack of one scenario, see the scenario's data: times in ms since its start, voltages in mV.

    `reference_mv` is what full scale of the converter stands for.
    """

    def __init__(self, scenario, reference_mv):
        self._points = scenario["points"]
        self._noise_mv = scenario["noise_mv"]
        self._denominator = reference_mv * scenario["divider_millionths"]
        self._random = (scenario["seed"] * 2654435761 + 1) & 0x7FFFFFFF
        self._next = 0  # the first point that lies ahead, when it was last looked for

    def millivolts(self, at_ms):
        """Return the true voltage; before the first point and after the last one it stays."""
        points = self._points
        index = self._next
        if index and points[index - 1][0] > at_ms:
            index = 0
        while index < len(points) and points[index][0] <= at_ms:
            index += 1
        self._next = index
        if index in (0, len(points)):
            return points[0 if index == 0 else -1][1]
        start_ms, start = points[index - 1]
        end_ms, end = points[index]
        return start + ((end - start) * (at_ms - start_ms) * 2 + end_ms - start_ms) // (2 * (end_ms - start_ms))

    def count(self, at_ms):
        """Return what one reading gives, 0 to 4095, with the noise of that reading."""
        millivolts = self.millivolts(at_ms) + self._deviation()
        count = (2 * millivolts * FULL_SCALE * 1000000 + self._denominator) // (2 * self._denominator)
        return min(max(count, 0), FULL_SCALE)

    def _deviation(self):
        if not self._noise_mv:
            return 0
        self._random = (self._random * 1103515245 + 12345) & 0x7FFFFFFF
        return (self._random >> 8) % (2 * self._noise_mv + 1) - self._noise_mv
