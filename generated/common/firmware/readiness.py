# Generated from templates/firmware/program/readiness.py: do not edit.
# Inputs: db3784cc149f70d3
"""Looking whether streams have something to read, or room to write, without waiting for it."""

import select


class Readiness:
    """Asks whether a stream or a socket is ready, without waiting and without the heap.

    look(0) returns something for each one that is watched and ready: it is the poll() of select that takes no heap.
    """

    def __init__(self, events):
        self._events = events
        self._poller = select.poll()
        self._has_objects = hasattr(self._poller, "ipoll")  # else look() tells of numbers
        self.look = self._poller.ipoll if self._has_objects else self._poller.poll

    def watch(self, stream):
        """Look at a stream from now on. OSError: it cannot be asked."""
        self._poller.register(stream, self._events)

    def key(self, stream):
        """Return what look() tells of a stream by, with what it is ready for."""
        return stream if self._has_objects else stream.fileno()

    def forget(self, stream):
        """Look at a stream no more; before it is closed."""
        self._poller.unregister(stream)

    def check(self):
        """Return whether one of the streams is ready."""
        for _ in self.look(0):
            return True
        return False
