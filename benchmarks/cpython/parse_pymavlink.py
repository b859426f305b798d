"""Receiving BATTERY_STATUS with pymavlink's parse_buffer.

With the argument "plain" it does not find fastcrc, a CRC in machine code that it takes where it is installed.
Arguments: installed or plain, file with the frames, passes, rounds per pass.
"""

import sys
from pathlib import Path

if sys.argv[1] == "plain":
    sys.modules["fastcrc"] = None

from pymavlink.dialects.v20 import common
from stopwatch import answer

data = Path(sys.argv[2]).read_bytes()
passes, count = map(int, sys.argv[3:5])
link = common.MAVLink(None)


def received(first, count):
    """Receive all frames `count` times; return how many there were."""
    messages = 0
    for _ in range(first, first + count):
        messages += len(link.parse_buffer(data))
    return messages


def values(message):
    """Return the values that the other contestants show."""
    charge = [message.current_consumed, message.energy_consumed, message.temperature]
    return [*charge, message.voltages[0], message.current_battery, message.battery_remaining]


answer(received, count, passes, [values(message) for message in link.parse_buffer(data)])
