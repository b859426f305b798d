"""The turn of a sensor for which nothing waits, most of the time, in machine code; see turns_plain."""

import micropython


def turning(poll):
    """Return what is called in each slot, and what tells it which function says whether something waits."""

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
