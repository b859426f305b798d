# Generated from templates/mocks/sim_course.py: do not edit.
# Inputs: 1d2e8c4a1d85cb1b
"""The true values of one quantity in a simulation, over time, and the faults on their way to the firmware."""


class Course:
    """A course of the scenario: `points` of a time in ms and a value, in the unit of the quantity, ascending in time.

    A value is a number, a boolean, a text, or None for what cannot be known. `label` names the quantity; `settings` is
    what the mock has to know that hands it to the firmware; `faults` are those of this course.
    """

    def __init__(self, data, faults):
        self.label = data["label"]
        self.settings = data["settings"]
        self.every_ms = data["every_ms"]
        self._points = data["points"]
        self._is_line = data["is_line"]
        self._noise = data["noise"]
        self._faults = [fault for fault in faults if fault["of"] == self.label]
        self._next = 0  # the first point that lies ahead, when it was last looked for
        self._random = (data["seed"] * 2654435761 + 1) & 0x7FFFFFFF
        self._stuck = None

    def value(self, at_ms):
        """Return what is true: straight lines between two numbers, else steps; the first and the last one stay."""
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
        if not self._is_line or not is_number(start) or not is_number(end):
            return start
        return start + (end - start) * (at_ms - start_ms) / (end_ms - start_ms)

    def seen(self, at_ms):
        """Return what one look at it finds: with its noise, or as it was when it got stuck."""
        if self.fault("stuck", at_ms) is None:
            self._stuck = None
            return self._noisy(at_ms)
        if self._stuck is None:
            self._stuck = (self._noisy(at_ms),)
        return self._stuck[0]

    def fault(self, kind, at_ms):
        """Return the fault of this kind that there is at a time; None without one."""
        for fault in self._faults:
            until_ms = fault["until_ms"]
            if fault["fault"] == kind and fault["at_ms"] <= at_ms and (until_ms is None or at_ms < until_ms):
                return fault
        return None

    def _noisy(self, at_ms):
        value = self.value(at_ms)
        if not self._noise or not is_number(value):
            return value
        self._random = (self._random * 1103515245 + 12345) & 0x7FFFFFFF
        return value + ((self._random >> 8) % 2001 - 1000) / 1000 * self._noise


def is_number(value):
    """Return whether lines can be drawn to a value."""
    return isinstance(value, (int, float)) and not isinstance(value, bool)
