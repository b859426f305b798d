"""Values to frame with the generated codec: six changing values go into `live`, then the link encodes the message.

The loop is bytecode, as a program that calls the codec mostly is, and counts.
Arguments: passes, frames per pass, and what the frame has, see frame.py.
"""

import sys

import messages
from mavlink import Link
from stopwatch import answer

passes, count, system, component, number, function, kind = map(int, sys.argv[1:8])
VALUES = tuple(map(int, sys.argv[8:13]))


def _message():
    names = (
        "current_consumed",
        "energy_consumed",
        "temperature",
        "voltages[0]",
        "current_battery",
        "battery_remaining",
    )
    made = messages.BatteryStatus(live=names)
    return made.update(id=number, battery_function=function, type=kind)


message = _message()
link = Link(None, system, component)


def frames(first, count):
    """Make `count` frames; the charge counts on from `first`. Return the last frame."""
    encode = link.encode
    live = message.live
    temperature, millivolts, current, energy, remaining = VALUES
    frame = None
    for consumed in range(first, first + count):
        live[0] = consumed
        live[1] = energy
        live[2] = temperature
        live[3] = millivolts
        live[4] = current
        live[5] = remaining
        frame = encode(message)
    return frame


answer(frames, count, passes, [bytes(frames(first, 1)).hex() for first in (1234, 98765)])
