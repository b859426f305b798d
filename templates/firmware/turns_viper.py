"""Finds the sensor that has its turn, in machine code; turns_plain has the same in Python."""

# ptr32 is viper's own name.
# ruff: noqa: F821

import time

import micropython


@micropython.viper
def next_due(times, now_us: int) -> int:
    """Return the number of a sensor that is due, whose next time is then a period later; -1 where none is.

    Of several it is the one that is due again first: in the order of their numbers, the last of them would lose turns.
    `times` has how many there are, and of each when it is due and its period, in us.
    """
    slot = ptr32(times)
    count = slot[0]
    found = -1
    least_us = 0
    at = 0
    while at < count:
        late_us = now_us - slot[1] & 0x3FFFFFFF
        # Further ahead than it can be: nobody asked for so long that the ticks went half round.
        if late_us < 0x20000000 or late_us - 0x20000000 < 0x20000000 - slot[2]:
            left_us = slot[2] - late_us
            if found < 0 or left_us < least_us:
                found = at
                least_us = left_us
        slot = ptr32(int(slot) + 8)
        at += 1
    if found >= 0:
        slot = ptr32(int(ptr32(times)) + 8 * found)
        late_us = slot[2] - least_us
        slot[1] = now_us - late_us % slot[2] + slot[2] & 0x3FFFFFFF
    return found


def asking(times, turns, most):
    """Return what asks the sensors that are due, so many of them at most; `turns` are what to call for each.

    A turn that returns something else than nothing only looked whether something waits: then comes the one that was in
    its place at first.
    """
    ticks = time.ticks_us
    heard = tuple(turns)
    due = next_due  # one name less to find each time

    @micropython.native
    def ask():
        at = due(times, ticks())
        if at < 0:
            return False
        if turns[at]():
            heard[at]()
        return True

    return ask if most == 1 else _several(ask, most)


def _several(ask, most):
    @micropython.native
    def ask_several():
        left = most
        while left and ask():
            left -= 1

    return ask_several
