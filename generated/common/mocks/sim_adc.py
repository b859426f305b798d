# Generated from templates/mocks/sim_adc.py: do not edit.
# Inputs: 0b8e82b4b1080f25
"""True values that the firmware measures with an ADC: each becomes counts at its pin.

Every kind of input in a simulation has a module `sim_<kind>` with such a connect(): it gets the courses of that kind,
a function that returns the scenario's time in ms, and that of the board's start. It lets the mocks of the board follow
them, and returns a function to be called with the time and the vehicle whenever the firmware waits, or None. The
function returns the time in ms before which it need not be called again, or None.
"""

import machine
import mock_time


def connect(courses, now_ms, start_ms):
    """Let the ADC input at the `gpio` of each course follow it."""
    for course in courses:
        analog = machine.analog(course.settings["gpio"])
        analog.source = _reader(course, now_ms)
        analog.absent = course.fault("absent", start_ms) is not None


def _reader(course, now_ms):
    zero = course.settings["zero"]  # what count 0 stands for, and the largest one
    span = course.settings["full"] - zero

    def read(_elapsed_us):
        at_ms = now_ms()
        slow = course.fault("slow", at_ms)
        if slow is not None:
            mock_time.advance_us(slow["delay_us"])
        elif course.fault("fail", at_ms) is not None or course.fault("absent", at_ms) is not None:
            return None
        value = course.seen(at_ms)
        if value is None:
            return None
        return count((value - zero) / span) if span else 0  # a multiplier of 0 shows nothing

    return read


def count(share):
    """Return the count that stands for a share of full scale, rounded and limited."""
    return min(max(int(share * machine.FULL_SCALE + 0.5), 0), machine.FULL_SCALE)
