"""Receiving BATTERY_STATUS with the generated codec: put() and receive() into one message that is used again.

The six values that change are live: receiving puts them into an array, as C's decode puts them into a struct. With the
argument "classes", feed() makes a new message of each frame; no field is read then.
Arguments: objects or classes, file with the frames, passes, rounds per pass.
"""

import sys

import messages
from mavlink import Link
from stopwatch import answer

passes, count = map(int, sys.argv[3:5])
NAMES = ("current_consumed", "energy_consumed", "temperature", "voltages[0]", "current_battery", "battery_remaining")

with open(sys.argv[2], "rb") as file:
    data = file.read()


def received_into_object(first, count):
    """Receive all frames `count` times; return how many there were."""
    received = 0
    for _ in range(first, first + count):
        link.put(data)
        while link.receive() is not None:
            received += 1
    return received


def received_by_class(first, count):
    """Do so with feed()."""
    received = 0
    for _ in range(first, first + count):
        for _ in link.feed(data):
            received += 1
    return received


if sys.argv[1] == "classes":
    link = Link(None, messages=(messages.BatteryStatus,))
    shown = [[message.raw(name.split("[")[0]) for name in NAMES] for message in link.feed(data)]
    for values in shown:
        values[3] = values[3][0]
    answer(received_by_class, count, passes, shown)
else:
    message = messages.BatteryStatus(live=NAMES)
    link = Link(None, messages=(message,))
    link.put(data)
    shown = []
    while link.receive() is not None:
        shown.append(list(message.live))
    answer(received_into_object, count, passes, shown)
