# Generated from templates/firmware/program/serial_port.py: do not edit.
# Inputs: c716e7cccd610898
"""Ports on a UART or on USB, where bytes may go and come in parts.

A port takes whole frames only, and never blocks or raises, whatever happens. Its counters `sent` and `received`, in
bytes, and `dropped`, in frames, wrap at 2 ** 30, beyond which numbers of 32-bit boards need the heap. `problem` is the
exception that keeps it from working, or None.
"""

import select
import sys

from conversion import limited
from guard import Guard
from micropython import const
from readiness import Readiness

_WRAP = const(0x3FFFFFFF)
_PIECE = const(32)  # bytes that are written at once from the buffer
_PIECES = const(8)  # so many of them in one poll(), so that it stays short


class StreamPort:
    """A UART or USB: `stream` has readinto(buffer) and write(data), which may do a part and return None for nothing.

    What the stream does not take at once waits in a buffer of `size` bytes. A frame that does not fit into it is
    dropped. `stream` None is a port that could not be opened.
    """

    def __init__(self, name, stream, size):
        self.name = name
        self.problem = None
        self.dropped = 0
        self.sent = 0
        self.received = 0
        self._stream = stream
        self._guard = Guard()
        self._ring = bytearray(size)
        self._first = 0  # where in the ring the oldest byte is
        self._waiting = 0  # bytes in the ring
        piece = bytearray(_PIECE)
        self._piece = piece
        self._pieces = [memoryview(piece)[:length] for length in range(_PIECE + 1)]  # slices would be made on the heap

    @property
    def is_up(self):
        """Return whether the stream is there, and its last reading or writing did not fail."""
        return self._stream is not None and self.problem is None

    def readinto(self, buffer):
        """Read what has arrived into `buffer`; return how many bytes, 0 for none."""
        if self._stream is None:
            return 0
        count = limited(self._try_readinto(buffer), 0, len(buffer))
        self.problem = self._guard.error
        self.received = (self.received + count) & _WRAP
        return count

    def write(self, frame):
        """Send or keep a whole frame and return its length, or drop it and return 0."""
        length = len(frame)
        if self._stream is None or length > len(self._ring) - self._waiting:
            self.dropped = (self.dropped + 1) & _WRAP
            return 0
        self._keep(frame, 0 if self._waiting else self._offer(frame))
        return length

    def poll(self, _now_ms):
        """Send what waits, as far as the stream takes it; return whether something still waits."""
        for _ in range(_PIECES):
            if not self._waiting or not self._send_piece():
                break
        return self._waiting > 0

    def _keep(self, frame, start):
        ring = self._ring
        end = (self._first + self._waiting) % len(ring)
        for index in range(start, len(frame)):
            ring[end] = frame[index]
            end += 1
            if end == len(ring):
                end = 0
        self._waiting += len(frame) - start

    def _send_piece(self):
        """Offer the oldest bytes; return whether the stream took all of these."""
        length = min(self._waiting, _PIECE)
        self._fill_piece(length)
        taken = self._offer(self._pieces[length])
        self._first = (self._first + taken) % len(self._ring)
        self._waiting -= taken
        return taken == length

    def _fill_piece(self, length):
        ring = self._ring
        piece = self._piece
        at = self._first
        for index in range(length):
            piece[index] = ring[at]
            at += 1
            if at == len(ring):
                at = 0

    def _offer(self, data):
        """Return how many bytes the stream takes now."""
        count = limited(self._try_write(data), 0, len(data))
        self.problem = self._guard.error
        self.sent = (self.sent + count) & _WRAP
        return count

    # Functions with a `with` have to be as small as these, or MicroPython puts their variables on the heap.

    def _try_write(self, data):
        with self._guard:
            return int(self._stream.write(data) or 0)
        return 0

    def _try_readinto(self, buffer):
        with self._guard:
            return int(self._stream.readinto(buffer) or 0)
        return 0


def open_uart(name, id, tx, rx, baud, size):  # noqa: A002 - the board's own argument name
    """Return a port on a UART: GPIO numbers of its pins, `baud` bits per second, buffers of `size` bytes each way."""

    def opened():
        import machine  # noqa: PLC0415 - not every host has one

        pins = {"tx": machine.Pin(tx), "rx": machine.Pin(rx)}
        return machine.UART(id, baudrate=baud, timeout=0, rxbuf=size, txbuf=size, **pins)

    return _port(name, opened, size, baud)


def open_fixed_uart(name, id, baud, size):  # noqa: A002 - the board's own argument name
    """Return a port on a UART whose pins are its own, as on a pyboard: received bytes wait in `size` bytes."""

    def opened():
        import machine  # noqa: PLC0415 - not every host has one

        return machine.UART(id, baudrate=baud, timeout=0, rxbuf=size)

    return _port(name, opened, size, baud)


def _port(name, opened, size, baud=2800000):
    guard = Guard()
    stream = None
    with guard:
        stream = opened()
    port = StreamPort(name, stream, size)
    port.problem = guard.error
    port.patience_ms = 100 + 2800000 // baud  # 280 bytes of 10 bits, and as long as a radio may pause
    return port


def open_usb(name, size):
    """Return a port on the board's USB serial line; from then on a byte 3 that arrives is no Ctrl-C any more."""

    def opened():
        import micropython  # noqa: PLC0415

        usb = _Usb(sys.stdin, sys.stdout)
        micropython.kbd_intr(-1)
        return usb

    return _port(name, opened, size)


class _Usb:
    """Standard input and output a byte at a time: being ready means that one more byte does not block."""

    def __init__(self, source, sink):
        self._source = _unbuffered(source)
        self._sink = _unbuffered(sink)
        self._source_ready = Readiness(select.POLLIN)
        self._source_ready.watch(source)
        self._sink_ready = Readiness(select.POLLOUT)
        self._sink_ready.watch(sink)
        self._byte_in = bytearray(1)
        self._byte_out = bytearray(1)

    def readinto(self, buffer):
        count = 0
        while count < len(buffer) and self._source_ready.check() and self._source.readinto(self._byte_in):
            buffer[count] = self._byte_in[0]
            count += 1
        return count

    def write(self, data):
        count = 0
        while count < len(data) and self._sink_ready.check():
            self._byte_out[0] = data[count]
            if not self._sink.write(self._byte_out):
                break
            count += 1
        return count


def _unbuffered(stream):
    return getattr(stream.buffer, "raw", stream.buffer)  # CPython has a buffer more, which poll() does not see
