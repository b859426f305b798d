# Generated from templates/mocks/waveform.py: do not edit.
# Inputs: de0fb1dc5a1c42df
"""A battery of a scenario: its true voltage and current over time, and the counts that an ADC makes of the voltage."""

FULL_SCALE = 4095  # counts of the 12 bit converter


class Course:
    """Values over time: points of a time in ms and a value, straight lines between them, the ends stay."""

    def __init__(self, points):
        self._points = points
        self._next = 0  # the first point that lies ahead, when it was last looked for

    def value(self, at_ms):
        """Return the value at a time, rounded."""
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


class Waveform:
    """The pack of one instance, see the settings: times in ms since the scenario's start, mV and mA.

    `reference_mv` is what full scale of the converter stands for.
    """

    def __init__(self, battery, reference_mv):
        self._voltage = Course(battery["points"])
        self._current = Course(battery["currents"]) if battery["currents"] else None
        self._noise_mv = battery["noise_mv"]
        self._volts = reference_mv * battery["divider_millionths"]
        self._amperes = reference_mv * battery.get("current_millionths", 1000000)
        self._random = (battery["seed"] * 2654435761 + 1) & 0x7FFFFFFF

    def millivolts(self, at_ms):
        """Return the true voltage."""
        return self._voltage.value(at_ms)

    def milliamperes(self, at_ms):
        """Return the true current, None where the scenario has none."""
        return None if self._current is None else self._current.value(at_ms)

    def count(self, at_ms):
        """Return what one reading of the voltage gives, 0 to 4095, with the noise of that reading."""
        return _count(self.millivolts(at_ms) + self._deviation(), self._volts)

    def current_count(self, at_ms):
        """Return what one reading of the current gives, 0 to 4095; without a current there is none."""
        return _count(self.milliamperes(at_ms) or 0, self._amperes)

    def _deviation(self):
        if not self._noise_mv:
            return 0
        self._random = (self._random * 1103515245 + 12345) & 0x7FFFFFFF
        return (self._random >> 8) % (2 * self._noise_mv + 1) - self._noise_mv


def _count(thousandths, denominator):
    """Return the count that stands for so many mV or mA, rounded and limited."""
    count = (2 * thousandths * FULL_SCALE * 1000000 + denominator) // (2 * denominator)
    return min(max(count, 0), FULL_SCALE)
