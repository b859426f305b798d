# ruff: noqa: T201  what is printed is the answer
"""Feeds pieces of a file to a codec, and writes down each message that it finds.

Arguments: the file, each piece with its length of two bytes before it, and the file for the messages.
"""

import json
import sys

import messages
from mavlink import Link

WORK = 256  # bytes that are looked at before others have their turn
LONGEST = 280  # of a frame: so many more may be looked at to end with it


def taken(link, out):
    """Write down what the link finds now; return the most bytes that it looked at in one turn."""
    most = 0
    state = link._state  # frames_plain says what it holds
    while True:
        state[15] = 0
        message = link.receive()
        most = max(most, state[15])
        if message is not None:
            out.write(f"{message.ID} {message.source_sequence} {bytes(message.wire[: message.LENGTH]).hex()}\n")
        elif state[15] < WORK:
            return most


def main():
    """Feed all pieces, and what is left in the end."""
    link = Link(None, messages=messages.ALL)
    state = link._state
    state[16] = WORK
    most = 0
    with open(sys.argv[1], "rb") as pieces, open(sys.argv[2], "w") as out:
        head = pieces.read(2)
        while head:
            link.put(pieces.read(head[0] | head[1] << 8))
            most = max(most, taken(link, out))
            head = pieces.read(2)
        while state[0] < state[1]:
            link.give_up()
            most = max(most, taken(link, out))
    form = "machine code" if "frames_viper" in sys.modules else "plain"
    print(json.dumps({"form": form, "work": most, "most": WORK + LONGEST}))


main()
