# Generated from templates/firmware/program/inbox.py: do not edit.
# Inputs: 1072121dd6afbfb7
"""Taking in what arrives at a port, a limited share in each pass of the main loop: a flood must not hold it up."""

import time

from micropython import const

_BUFFER = const(512)  # bytes that one readinto() takes; of UDP it has to be a whole datagram, or its end is lost
_PIECE = const(32)  # bytes that are searched for frames at once
_PIECES = const(8)  # in a pass
_BUDGET_US = const(500)  # no more pieces in a pass from here on: bytes that look like frames take long to be searched


class Inbox:
    """Messages that arrive at a port.

    What was read is handed to the link in pieces. Views of these are made once, and bytes that do not fill a piece are
    copied to a smaller buffer: a view for each length and place would take the memory of all of them.
    """

    def __init__(self, port, link):
        self._port = port
        self._link = link
        self._buffer = bytearray(_BUFFER)
        whole = memoryview(self._buffer)
        self._pieces = [whole[at : at + _PIECE] for at in range(0, _BUFFER, _PIECE)]
        self._rest = bytearray(_PIECE)
        rest = memoryview(self._rest)
        self._rests = [rest[:length] for length in range(_PIECE)]
        self._length = 0  # bytes that were read
        self._taken = 0  # that the link has; at the end it may be more
        self._is_open = False  # whether the link may find more in the last piece
        self._pieces_left = 0
        self._start_us = 0

    def begin(self):
        """Begin a pass."""
        self._pieces_left = _PIECES
        self._start_us = time.ticks_us()

    def next(self):
        """Return the next message; None: nothing more arrived, or this pass has had its share."""
        while True:
            if self._is_open:
                message = self._link.receive()
                if message is not None:
                    return message
                self._is_open = False
            if not self._pieces_left or time.ticks_diff(time.ticks_us(), self._start_us) >= _BUDGET_US:
                return None
            if self._taken >= self._length and not self._read():
                return None
            self._put()

    def _read(self):
        self._taken = 0
        self._length = self._port.readinto(self._buffer) or 0
        return self._length

    def _put(self):
        at = self._taken
        left = self._length - at
        if left >= _PIECE:
            self._link.put(self._pieces[at // _PIECE])
        else:
            for index in range(left):
                self._rest[index] = self._buffer[at + index]
            self._link.put(self._rests[left])
        self._taken = at + _PIECE
        self._is_open = True
        self._pieces_left -= 1
