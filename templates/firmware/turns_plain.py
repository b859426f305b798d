"""Finds the sensor that has its turn, in plain Python; turns_viper is the same in machine code."""

import time

_MASK = 0x3FFFFFFF  # ticks are counted in 30 bits


def next_due(times, now_us):
    """Return the number of a sensor that is due, whose next time is then a period later; -1 where none is.

    Of several it is the one that is due again first: in the order of their numbers, the last of them would lose turns.
    `times` has how many there are, and of each when it is due and its period, in us.
    """
    found = -1
    least_us = at = 0
    while at < times[0]:
        late_us = now_us - times[2 * at + 1] & _MASK
        period_us = times[2 * at + 2]
        # Further ahead than it can be: nobody asked for so long that the ticks went half round.
        if late_us < 0x20000000 or late_us < 0x40000000 - period_us:
            left_us = period_us - late_us
            if found < 0 or left_us < least_us:
                found = at
                least_us = left_us
        at += 1
    if found >= 0:
        period_us = times[2 * found + 2]
        late_us = period_us - least_us
        times[2 * found + 1] = now_us - late_us % period_us + period_us & _MASK
    return found


def asking(times, turns, most):
    """Return what asks the sensors that are due, so many of them at most; `turns` are what to call for each.

    A turn that returns something else than nothing only looked whether something waits: then comes the one that was in
    its place at first.
    """
    ticks = time.ticks_us
    heard = tuple(turns)

    def ask():
        at = next_due(times, ticks())
        if at < 0:
            return False
        if turns[at]():
            heard[at]()
        return True

    return ask if most == 1 else _several(ask, most)


def _several(ask, most):
    def ask_several():
        left = most
        while left and ask():
            left -= 1

    return ask_several
