"""True values that code of the vehicle sets: the simulation sets them in the state, as that code would."""

import math


def connect(courses, now_ms, start_ms):  # noqa: ARG001 - as other inputs, see sim_adc
    """Return what sets each course when it is due."""
    setters = [Setter(course) for course in courses]

    def turn(at_ms, vehicle):
        for setter in setters:
            if at_ms >= setter.due_ms:
                setter.set(at_ms, vehicle.state)
        return min([setter.due_ms for setter in setters])

    return turn


class Setter:
    """Sets one quantity: `attribute` of an instance of a component, in `steps` to its unit, whole ones if so kept."""

    def __init__(self, course):
        settings = course.settings
        self.due_ms = 0
        self._course = course
        self._component = settings["component"]
        self._instance = settings["instance"]
        self._attribute = settings["attribute"]
        self._steps = settings["steps"]
        self._is_whole = settings["is_whole"]

    def set(self, at_ms, state):
        """Set what is true now, unless nothing does."""
        self.due_ms = at_ms + self._course.every_ms
        if self._course.fault("fail", at_ms) is not None:
            return
        value = self._course.seen(at_ms)
        if self._is_whole and value is not None:
            value *= self._steps
            if not isinstance(value, int):  # of 64 bits, a whole number is exact
                value = math.floor(value + 0.5)
        component = getattr(state, self._component)
        setattr(component[self._instance], self._attribute, value)
