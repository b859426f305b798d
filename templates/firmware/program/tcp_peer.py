"""The other end of a TCP connection: frames go there whole, though a socket may take and bring them in parts."""

from time import ticks_diff

from guard import Guard
from micropython import const
from network_port import BUSY

_PIECE = const(256)  # bytes that are read at once
_PATIENCE_MS = const(2000)  # for the end of a frame: a lost packet is sent again by then
_NEW, _OLD = const(0xFD), const(0xFE)  # a frame begins so


class Peer:
    """The other end of `socket`, which does not block; its readiness is reported by `key`.

    `error` is the exception, or the text, with which the connection has ended; None while it is there. `heard_ms` is
    the time.ticks_ms() of its last frame, or of its beginning, and `is_heard` whether there was one. `arrived` are the
    bytes that came with the last receive().
    """

    def __init__(self, socket, key, now_ms):
        self.socket = socket
        self.key = key
        self.error = None
        self.heard_ms = now_ms
        self.is_heard = False
        self.is_ready = False  # whether there may be something to read
        self.arrived = 0
        self._unsent = b""  # the end of a frame that was sent in part
        self._is_full = False  # whether the socket did not take the last frame as a whole
        self._full_ms = None  # since when the socket is full, as noticed by send()
        self._kept = b""  # the beginning of a frame
        self._kept_ms = None  # since when one is kept, as noticed by check()
        self._is_shorter = False  # whether a start was given up, so that there may be a whole frame in what is kept
        self._brought = 0  # bytes that were received last, with what was kept
        self._guard = Guard()

    def send(self, frame):
        """Return whether a frame is taken: its end may follow in flush(), and nothing goes out before that has."""
        if not self.flush():
            return False
        count = self._try_send(frame)
        self._is_full = count < len(frame)
        if count > 0 and self._is_full:
            self._unsent = bytes(frame[count:])
        return count > 0

    def flush(self):
        """Send the end of a frame that was sent in part; return whether nothing of it is left."""
        if self.error is not None:
            return False
        if self._unsent:
            self._unsent = self._unsent[self._try_send(self._unsent) :]
            self._is_full = len(self._unsent) > 0
        return not self._unsent

    def receive(self):
        """Return the bytes that have arrived, after the kept beginning of a frame, which counts alone once its start
        was given up; None where there is nothing to look at.
        """
        self.is_ready = False
        data = self._try_receive()
        if not data:
            if data is not None and self.error is None:
                self.error = "closed by the other end"
            if self.error is not None or not self._is_shorter:
                return None
            data = b""
        self._is_shorter = False
        self.arrived = len(data)  # what was kept is counted already
        if self._kept:
            data = self._kept + data
            self._kept = b""
        self._brought = len(data)
        return data

    def keep(self, data):
        """Keep the beginning of a frame until more arrives."""
        self._kept = data
        if len(data) < self._brought:
            self._kept_ms = None  # it is another one

    def check(self, now_ms, timeout_ms):
        """Notice how long something lasts, and end the connection where that is too long; twice a second or more."""
        if ticks_diff(now_ms, self.heard_ms) >= timeout_ms:
            self.error = self.error or "silent"
        if not self._is_full:
            self._full_ms = None
        elif self._full_ms is None:
            self._full_ms = now_ms
        elif ticks_diff(now_ms, self._full_ms) >= timeout_ms:
            self.error = self.error or "takes nothing"
        if not self._kept:
            self._kept_ms = None
        elif self._kept_ms is None:
            self._kept_ms = now_ms
        elif ticks_diff(now_ms, self._kept_ms) >= _PATIENCE_MS:
            self._give_up()

    def _give_up(self):
        """Look on behind the first byte of a frame whose end does not come: perhaps it is none.

        What is left is looked at with the next pass, though nothing more may ever arrive.
        """
        kept = self._kept
        start = 1
        while start < len(kept) and kept[start] != _NEW and kept[start] != _OLD:
            start += 1
        self._kept = kept[start:]
        self._kept_ms = None
        self._is_shorter = self.is_ready = len(self._kept) > 0

    # Functions with a `try` or a `with` have to be as small as these, or MicroPython puts their variables on the heap.

    def _try_send(self, data):
        """Return how many bytes the socket takes now."""
        try:
            return self.socket.send(data)
        except Exception:
            return self._try_send_now(data)

    def _try_send_now(self, data):
        """Try once more, and keep what goes wrong: the guard takes as long as sending does."""
        with self._guard:
            return self.socket.send(data)
        self._note()
        return 0

    def _try_receive(self):
        """Return what has arrived, b"" at its end, None for nothing yet."""
        with self._guard:
            return self.socket.recv(_PIECE)
        self._note()
        return None

    def _note(self):
        error = self._guard.error
        if not (isinstance(error, OSError) and error.errno in BUSY):
            self.error = error
