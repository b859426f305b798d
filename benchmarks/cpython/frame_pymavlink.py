"""Values to frame with pymavlink: a message object of its dialect, then pack().

With the argument "plain" it does not find fastcrc, a CRC in machine code that it takes where it is installed.
Arguments: installed or plain, passes, frames per pass, and what the frame has, see frame.py.
"""

import sys

if sys.argv[1] == "plain":
    sys.modules["fastcrc"] = None

from pymavlink.dialects.v20 import common
from stopwatch import answer

passes, count, system, component, number, function, kind = map(int, sys.argv[2:9])
temperature, millivolts, current, energy, remaining = map(int, sys.argv[9:14])
link = common.MAVLink(None, srcSystem=system, srcComponent=component)
voltages = [millivolts, *[65535] * 9]


def frames(first, count):
    """Make `count` frames; the charge counts on from `first`. Return the last frame."""
    encode = link.battery_status_encode
    frame = b""
    for consumed in range(first, first + count):
        frame = encode(number, function, kind, temperature, voltages, current, consumed, energy, remaining).pack(link)
    return frame


answer(frames, count, passes, [bytes(frames(first, 1)).hex() for first in (1234, 98765)])
