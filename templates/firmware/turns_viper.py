"""Which sensor has its turn, in machine code; turns_plain has the same in Python."""

# ptr32 is viper's own name.
# ruff: noqa: F821

import time

import micropython


@micropython.viper
def next_due(times, now_us: int) -> int:
    """Return the number of the first sensor that is due, whose next time is then a period later; -1 where none is.

    `times` has how many there are, and of each when it is due and its period, in us.
    """
    slot = ptr32(times)
    count = slot[0]
    at = 0
    while at < count:
        late_us = now_us - slot[1] & 0x3FFFFFFF
        # Further ahead than it can be: nobody asked for so long that the ticks went half round.
        if late_us < 0x20000000 or late_us - 0x20000000 < 0x20000000 - slot[2]:
            slot[1] = now_us - late_us % slot[2] + slot[2] & 0x3FFFFFFF
            return at
        slot = ptr32(int(slot) + 8)
        at += 1
    return -1


def asking(times, turns, most):
    """Return what asks the sensors that are due, so many of them at most; `turns` are what to call for each."""
    ticks = time.ticks_us
    due = next_due

    @micropython.native
    def ask():
        left = most
        while left:
            at = due(times, ticks())
            if at < 0:
                return
            turns[at]()
            left -= 1

    return ask


def turning(poll):
    """Return the turn of a sensor for which nothing waits most of the time, and what tells it how to find out."""

    def waiting():
        return True

    @micropython.native
    def turn():
        if waiting():
            poll()

    def listen(function):
        nonlocal waiting
        waiting = function

    return turn, listen
