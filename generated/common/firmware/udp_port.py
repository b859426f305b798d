# Generated from templates/firmware/program/udp_port.py: do not edit.
# Inputs: c9caadee8780dcf1
"""A port that sends UDP over Wi-Fi."""

import select
import socket

from micropython import const
from network_port import BUSY, NetworkPort, numbered
from readiness import Readiness
from stations import Stations

_WRAP = const(0x3FFFFFFF)
_LONGEST = const(1472)  # bytes of a datagram that comes in one piece
_len = len  # found here, it is found sooner than among the built-in names


class UdpPort(NetworkPort):
    """UDP, a frame in each datagram, over Wi-Fi.

    Frames go to ends[0], and what was read last came from ends[1]. `host`, `port` is where they go at first, `home`,
    and None waits for somebody. `host` is an address, of a broadcast too: to look up a name would block. `local_port` 0
    takes any. `stations` keeps those apart who are there. `is_up` is whether there is a socket; not whether somebody
    listens. What is asked in every pass are attributes: a property takes longer, and makes storing others slow.
    `credentials` and `retry_ms` are those of NetworkPort; "host", "port" and "local_port" in the file override the
    arguments.
    """

    stations = Stations

    def __init__(self, name, host, port, local_port, credentials, retry_ms, log):
        self._socket = None
        self._ready = Readiness(select.POLLIN)
        self.look = self._ready.look
        self.ends = [None, None]
        self.home = None
        self._address = (host, port, local_port)
        NetworkPort.__init__(self, name, credentials, retry_ms, log)

    def read(self):
        """Return the next datagram, None for none."""
        if self._socket is None:
            return None
        with self._guard:
            if self._ready.check():
                return self._receive()
        if self._guard.error is not None:
            self._note(self._guard.error)
        return None

    def write(self, frame):
        """Send a frame as one datagram and return its length, or drop it and return 0."""
        if self._socket is not None and self.ends[0] is not None and self._is_sent(frame):
            length = _len(frame)
            self.sent = (self.sent + length) & _WRAP
            return length
        self.dropped = (self.dropped + 1) & _WRAP
        return 0

    def poll(self, now_ms):
        """Keep Wi-Fi and socket up; `now_ms` is time.ticks_ms()."""
        if self._has_wifi and not self._poll_wifi(now_ms):
            if self._socket is not None:
                self._close()
            return
        if self._socket is None and self._retry.is_due(now_ms):
            with self._guard:
                self._open()
            if self._guard.error is None:
                self.problem = None
            else:
                self._fail(self._guard.error)

    def _take_settings(self, shared, own):
        named = dict(shared)
        named.update(own)
        host, port, local_port = self._address
        host = numbered(named.get("host", host))
        self._address = (host, named.get("port", port), named.get("local_port", local_port))

    def _open(self):
        host, port, local_port = self._address
        if self.home is None and host:
            self.home = socket.getaddrinfo(host, port)[0][-1]
        if self.ends[0] is None:
            self.ends[0] = self.home
        self._socket = opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        opened.setblocking(False)
        if hasattr(socket, "SO_BROADCAST"):
            opened.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
        opened.bind(socket.getaddrinfo("0.0.0.0", local_port)[0][-1])  # noqa: S104 - a ground station may be anywhere
        self._ready.watch(opened)
        self.is_up = True

    def _close(self):
        with self._guard:
            self._ready.forget(self._socket)
        with self._guard:
            self._socket.close()
        self._socket = None
        self.is_up = False

    def _note(self, error):
        if not (isinstance(error, OSError) and error.errno in BUSY):
            self._fail(error)

    def _fail(self, error):
        """Close the socket; poll() opens it again. An error is logged once until that has worked."""
        if self.problem is None:
            self._say("error:", "has a socket that fails:", error)
        self.problem = error
        if self._socket is not None:
            self._close()

    def _is_sent(self, frame):  # functions with few variables: those of larger ones would lie on the heap
        try:
            self._send(frame)
            return True
        except Exception:
            return self._is_sent_now(frame)

    def _is_sent_now(self, frame):
        """Try once more, and keep what goes wrong: the guard takes as long as sending a frame does."""
        with self._guard:
            self._send(frame)
        if self._guard.error is None:
            return True
        self._note(self._guard.error)
        return False

    def _send(self, frame):
        self._socket.sendto(frame, self.ends[0])

    def _receive(self):
        data, self.ends[1] = self._socket.recvfrom(_LONGEST)
        self.received = (self.received + len(data)) & _WRAP
        return data
