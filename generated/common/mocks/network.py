# Generated from templates/mocks/network.py: do not edit.
# Inputs: ded8f7aed4fe114b
"""The board's module `network`, as far as the firmware uses it: a Wi-Fi station that follows a script, `radio`.

Only the state of the connection is made up. Sockets are those of the host, and work without it.
"""

import errno

import mock_time

STA_IF = 0
AP_IF = 1

STAT_IDLE = 0
STAT_CONNECTING = 1
STAT_GOT_IP = 3


class Radio:
    """The Wi-Fi around the board, as a test sets it up.

    `connect_after_ms` is the virtual time from connect() to an address, None for never. `absent` makes WLAN() fail and
    `failures` the next calls of connect(). `connects` counts those calls, `credentials` is what the last one was given.
    """

    def __init__(self):
        self.reset()

    def reset(self):
        """Nobody has connected; a connection takes a second."""
        self.connect_after_ms = 1000
        self.absent = False
        self.failures = 0
        self.connects = 0
        self.credentials = None
        self._since_us = None

    def drop(self):
        """Lose the connection, until the next connect()."""
        self._since_us = None

    def connect(self, *credentials):
        """Begin to connect."""
        self.connects += 1
        self.credentials = credentials
        if self.failures > 0:
            self.failures -= 1
            raise OSError(errno.ENODEV)
        self._since_us = mock_time.elapsed_us()

    def status(self):
        """Return STAT_IDLE, STAT_CONNECTING or STAT_GOT_IP."""
        if self._since_us is None:
            return STAT_IDLE
        if self.connect_after_ms is None:
            return STAT_CONNECTING
        is_up = mock_time.elapsed_us() - self._since_us >= 1000 * self.connect_after_ms
        return STAT_GOT_IP if is_up else STAT_CONNECTING


radio = Radio()


class WLAN:
    """A station; all of them are the same radio."""

    def __init__(self, interface=STA_IF):
        if radio.absent:
            raise OSError(errno.ENODEV)
        self._interface = interface
        self._is_active = False

    def active(self, is_active=None):
        """Return whether the interface is on, or switch it."""
        if is_active is None:
            return self._is_active
        self._is_active = bool(is_active)
        if not self._is_active:
            radio.drop()
        return None

    def connect(self, ssid=None, key=None):
        """Begin to connect; OSError where the interface is off."""
        if not self._is_active:
            raise OSError(errno.ENODEV)
        radio.connect(ssid, key)

    def disconnect(self):
        """End the connection."""
        radio.drop()

    def isconnected(self):
        """Return whether there is a connection with an address."""
        return radio.status() == STAT_GOT_IP

    def status(self):
        """Return how far the connection is."""
        return radio.status()

    def ifconfig(self):
        """Return address, netmask, gateway and name server: those of the host itself."""
        return ("127.0.0.1", "255.0.0.0", "127.0.0.1", "127.0.0.1")
