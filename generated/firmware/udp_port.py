# Generated from templates/firmware/program/udp_port.py: do not edit.
# Inputs: bb78615c9727c196
"""A port that sends UDP over Wi-Fi.

A port takes whole frames only, and never blocks or raises, whatever happens. Its counters `sent` and `received`, in
bytes, and `dropped`, in frames, wrap at 2 ** 30, beyond which numbers of 32-bit boards need the heap. `problem` is the
exception that keeps it from working, or None.
"""

import errno
import json
import select
import socket
import time

from guard import Guard
from micropython import const
from readiness import Readiness
from stations import Stations

_WRAP = const(0x3FFFFFFF)
_LONGEST = const(1472)  # bytes of a datagram that comes in one piece
_len = len  # found here, it is found sooner than among the built-in names
_BUSY = (errno.EAGAIN, errno.ENOBUFS, errno.ENOMEM)  # there is no room for a datagram now, and that is all


class UdpPort:
    """UDP, a frame in each datagram, over Wi-Fi.

    Frames go to ends[0], and what was read last came from ends[1]. `host`, `port` is where they go at first, `home`,
    and None waits for somebody. `host` is an address, of a broadcast too: to look up a name would block. `local_port` 0
    takes any. `stations` keeps those apart who are there. `is_up` is whether there is a socket; not whether somebody
    listens. What is asked in every pass are attributes: a property takes longer, and makes storing others slow.
    `credentials` names a JSON file {"ssid": ..., "password": ...} whose "host", "port" and "local_port" override the
    arguments; None is a network that is there without Wi-Fi. What is down is tried again every `retry_ms`.
    The Wi-Fi chip is started here, which takes a second: make the port before the scheduler runs.
    """

    stations = Stations

    def __init__(self, name, host, port, local_port, credentials, retry_ms, log):
        self.name = name
        self.is_up = False
        self.problem = None
        self.dropped = 0
        self.sent = 0
        self.received = 0
        self._log = log
        self._guard = Guard()
        self._socket = None
        self._ready = Readiness(select.POLLIN)
        self.look = self._ready.look
        self.ends = [None, None]
        self.home = None
        self._address = (host, port, local_port)
        self._retry = _Retry(retry_ms)
        self._wifi = None
        self._has_wifi = credentials is not None
        if self._has_wifi:
            self._start_wifi(credentials, retry_ms)

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

    def _start_wifi(self, credentials, retry_ms):
        with self._guard:
            with open(credentials) as file:
                settings = json.load(file)
            host, port, local_port = self._address
            host = settings.get("host", host)
            if host and not all(part.isdigit() for part in host.split(".")):
                raise ValueError("host is not an address in numbers")
            self._address = (host, settings.get("port", port), settings.get("local_port", local_port))
            self._wifi = _Wifi(settings["ssid"], settings.get("password"), retry_ms)
        if self._guard.error is not None:
            self.problem = self._guard.error
            self._say("warning:", "has no Wi-Fi:", self.problem)

    def _poll_wifi(self, now_ms):
        if self._wifi is None:
            return False
        was_up = self._wifi.is_up
        self._wifi.poll(now_ms)
        if self._wifi.is_up != was_up:
            self._say("notice:", "Wi-Fi is", "down" if was_up else "up")
        return self._wifi.is_up

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
        if not (isinstance(error, OSError) and error.errno in _BUSY):
            self._fail(error)

    def _fail(self, error):
        """Close the socket; poll() opens it again. An error is logged once until that has worked."""
        if self.problem is None:
            self._say("error:", "has a socket that fails:", error)
        self.problem = error
        if self._socket is not None:
            self._close()

    def _say(self, severity, text, detail):
        with self._guard:
            self._log(severity, self.name, text, detail)

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


class _Wifi:
    """A station of a Wi-Fi network that is joined again whenever it is lost."""

    def __init__(self, ssid, password, retry_ms):
        import network  # noqa: PLC0415 - a board without Wi-Fi does not have it

        self.is_up = False
        self._wlan = network.WLAN(network.STA_IF)
        self._wlan.active(True)
        self._ssid = ssid
        self._password = password  # None for an open network
        self._guard = Guard()
        self._retry = _Retry(retry_ms)

    def poll(self, now_ms):
        with self._guard:
            self.is_up = self._wlan.isconnected()
        if self._guard.error is not None:
            self.is_up = False
        if not self.is_up and self._retry.is_due(now_ms):
            with self._guard:
                self._wlan.connect(self._ssid, self._password)


class _Retry:
    """Due at once, and then no more often than every `period_ms`."""

    def __init__(self, period_ms):
        self._period_ms = period_ms
        self._next_ms = None

    def is_due(self, now_ms):
        if self._next_ms is not None:
            ahead_ms = time.ticks_diff(self._next_ms, now_ms)
            if 0 < ahead_ms <= self._period_ms:  # further ahead: the ticks went half round since
                return False
        self._next_ms = time.ticks_add(now_ms, self._period_ms)
        return True
