# Generated from templates/firmware/program/readiness.py: do not edit.
# Inputs: fe9a12375d1934ca
"""Looking whether a stream has something to read, or room to write, without waiting for it."""

import select


class Readiness:
    """Whether a stream or a socket is ready, without waiting and without the heap."""

    def __init__(self, stream, events):
        poller = select.poll()
        poller.register(stream, events)
        self._poll = poller.ipoll if hasattr(poller, "ipoll") else poller.poll

    def check(self):
        for _ in self._poll(0):
            return True
        return False
