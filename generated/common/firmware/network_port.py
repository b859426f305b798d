# Generated from templates/firmware/program/network_port.py: do not edit.
# Inputs: 7e5d3880771702f9
"""The common part of ports over Wi-Fi: counters, the settings on the board, and the network that they wait for.

A port takes whole frames only, and never blocks or raises, whatever happens. Its counters `sent` and `received`, in
bytes, and `dropped`, in frames, wrap at 2 ** 30, beyond which numbers of 32-bit boards need the heap. `problem` is the
exception that keeps it from working, or None.
"""

import errno
import json
import time

from guard import Guard

BUSY = (errno.EAGAIN, errno.ENOBUFS, errno.ENOMEM)  # there is no room for these bytes now, and that is all

_joined = []  # the networks that ports wait for: each is shared, or one port would break off the other's try


class NetworkPort:
    """Waits for a network, which starts the Wi-Fi chip: make the port before the scheduler runs, it takes a second.

    `credentials` names a JSON file {"ssid": ..., "password": ...} whose other entries override what a port was given;
    None is a network that is there without Wi-Fi. An entry with the name of the port has entries for it alone. What is
    down is tried again every `retry_ms`. `has_network` is whether the Wi-Fi was there when it was last asked.
    """

    def __init__(self, name, credentials, retry_ms, log):
        self.name = name
        self.is_up = False
        self.problem = None
        self.dropped = 0
        self.sent = 0
        self.received = 0
        self._log = log
        self._guard = Guard()
        self._retry = Retry(retry_ms)
        self._wifi = None
        self.has_network = False
        self._has_wifi = credentials is not None
        if self._has_wifi:
            self._start_wifi(credentials, retry_ms)

    def _take_settings(self, shared, own):
        """Take what the file says for all ports, and for this one."""

    def _start_wifi(self, credentials, retry_ms):
        with self._guard:
            with open(credentials) as file:
                settings = json.load(file)
            self._take_settings(settings, settings.get(self.name, {}))
            self._wifi = _network(settings["ssid"], settings.get("password"), retry_ms)
        if self._guard.error is not None:
            self.problem = self._guard.error
            self._say("warning:", "has no Wi-Fi:", self.problem)

    def _poll_wifi(self, now_ms):
        """Return whether the network is there."""
        if self._wifi is None:
            return False
        self._wifi.poll(now_ms)
        if self._wifi.is_up != self.has_network:
            self.has_network = self._wifi.is_up
            self._say("notice:", "Wi-Fi is", "up" if self.has_network else "down")
        return self.has_network

    def _say(self, severity, text, detail):
        with self._guard:
            self._log(severity, self.name, text, detail)


def numbered(host):
    """Return a host that is an address in numbers, or nothing. ValueError: to look up a name would block."""
    if host and not all(part.isdigit() for part in host.split(".")):
        raise ValueError("host is not an address in numbers")
    return host


def _network(ssid, password, retry_ms):
    for wifi in _joined:
        if wifi.is_of(ssid, password):
            return wifi
    _joined.append(_Wifi(ssid, password, retry_ms))
    return _joined[-1]


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
        self._retry = Retry(retry_ms)

    def is_of(self, ssid, password):
        return self._ssid == ssid and self._password == password

    def poll(self, now_ms):
        with self._guard:
            self.is_up = self._wlan.isconnected()
        if self._guard.error is not None:
            self.is_up = False
        if not self.is_up and self._retry.is_due(now_ms):
            with self._guard:
                self._wlan.connect(self._ssid, self._password)


class Retry:
    """Due at once, and then no more often than every `period_ms`, which may be changed."""

    def __init__(self, period_ms):
        self.period_ms = period_ms
        self._next_ms = None

    def is_due(self, now_ms):
        """Return whether it is time for another try, which begins now."""
        if self._next_ms is not None:
            ahead_ms = time.ticks_diff(self._next_ms, now_ms)
            if 0 < ahead_ms <= self.period_ms:  # further ahead: the ticks went half round since
                return False
        self.begin(now_ms)
        return True

    def begin(self, now_ms):
        """Let a pause begin."""
        self._next_ms = time.ticks_add(now_ms, self.period_ms)
