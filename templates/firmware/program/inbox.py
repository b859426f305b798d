"""Taking in what arrives at a port, a limited share in each pass of the main loop: a flood must not hold it up."""

import time

from micropython import const

_SIZE = const(256)  # bytes that one readinto() takes
_WORK = const(256)  # bytes that are searched for frames in a pass; to check a frame counts as much as its length
_PATIENCE_MS = const(500)  # for the end of a frame, where a port does not know better


class Inbox:
    """Messages that arrive at a port.

    A datagram, which ports with `ends` read(), has whole frames: what is not whole at its end is given up at once, so
    that nobody's bytes become part of another one's frame. Other ports readinto() a buffer and may bring a frame in
    parts: it is given up when its end did not come within the time that the longest one takes, the `patience_ms`.
    """

    def __init__(self, port, link):
        self._port = port
        self._link = link
        self._state = link._state  # frames_plain says what it holds
        self._state[16] = _WORK
        self._has_datagrams = getattr(port, "ends", None) is not None
        self._buffer = None if self._has_datagrams else bytearray(_SIZE)
        self._patience_ms = getattr(port, "patience_ms", _PATIENCE_MS)
        self._total = 0  # bytes that arrived
        self._start = -1  # at which of them the frame begins that is not whole
        self._since_ms = 0  # when that was noticed
        self._read_ms = 0
        self._is_open = False  # whether the link may find more in what it has

    def begin(self):
        """Begin a pass."""
        self._state[15] = 0

    def next(self):
        """Return the next message; None: nothing more arrived, or this pass has had its share."""
        while True:
            if self._is_open:
                message = self._link.receive()
                if message is not None:
                    return message
                if self._state[15] >= _WORK:
                    return None
                if self._has_datagrams and self._state[0] < self._state[1]:
                    self._link.give_up()
                    continue
                self._is_open = False
            if not self._read() and (self._state[0] == self._state[1] or not self._is_given_up()):
                return None
            self._is_open = True

    def _read(self):
        if self._has_datagrams:
            data = self._port.read()
            if data:
                self._link.put(data)
            return data
        count = self._port.readinto(self._buffer)
        if not count:
            return count
        self._total = (self._total + count) & 0x3FFFFFFF
        self._read_ms = time.ticks_ms()
        self._link.put_part(self._buffer, count)
        return count

    def _is_given_up(self):
        """Give up the frame that is not whole, if its end does not come; return whether that was done."""
        start = (self._total - self._state[1] + self._state[0]) & 0x3FFFFFFF
        if start != self._start:
            self._start = start
            self._since_ms = self._read_ms
        if time.ticks_diff(time.ticks_ms(), self._since_ms) < self._patience_ms:
            return False
        self._link.give_up()
        return True
