"""A vehicle with connections whose ports are lists of bytes: the services as tests and measurements drive them."""

import mock_time

mock_time.install()

import time  # noqa: E402  the clock has to be in place before the firmware looks at it

import services  # noqa: E402
from connection import Connection  # noqa: E402
from mavlink import Link  # noqa: E402
from parameters import Parameters  # noqa: E402
from streams import Streams  # noqa: E402
from texts import Texts  # noqa: E402


class Port:
    """A port that hands out what it was given, and takes `room` bytes in each pass, or all for None."""

    name = "bench"

    def __init__(self):
        self.is_up = True
        self.room = None
        self.left = 0
        self.arrived = b""
        self.written = b""
        self.polls = 0
        self.delay_us = 0

    def readinto(self, buffer):
        """Read what is there, up to the size of the buffer."""
        count = min(len(buffer), len(self.arrived))
        if count:
            buffer[:count] = self.arrived[:count]
            self.arrived = self.arrived[count:]
            mock_time.advance_us(self.delay_us)
        return count

    def write(self, frame):
        """Take a whole frame, or nothing."""
        if not self.is_up or (self.room is not None and self.left < len(frame)):
            return 0
        self.left -= len(frame)
        self.written += bytes(frame)
        return len(frame)

    def poll(self, _now_ms):
        """Count the passes; a buffer of `room` bytes is empty again in the next one."""
        self.polls += 1
        self.left = self.room or 0


class Vehicle:
    """Keeps what it was asked to do."""

    FORCE_ARM = 21196
    MESSAGES = 8
    SILENCE_MS = 10000

    def __init__(self, calls):
        self.parameters = Parameters()
        self.texts = Texts()
        self.connections = []
        self.calls = calls
        self.is_armed = False
        self.problem = None
        self.restart_ms = None
        self.is_broken = False

    def arm(self, force=False):
        """Arm, unless there is a problem; None or why not."""
        return self._do("arm", force, True)

    def disarm(self, force=False):
        """Disarm, unless there is a problem; None or why not."""
        return self._do("disarm", force, False)

    def reboot(self, force=False):
        """Note that the board is to start again, unless it is armed; None or why not."""
        if self.is_armed and not force:
            return "Reboot: disarm first"
        if self.is_armed:
            self.disarm(True)
        self.calls.append(["reboot"])
        return self.problem

    def remind(self):
        """Note that a ground station has appeared."""
        self.calls.append(["remind"])

    def _do(self, name, force, is_armed):
        if self.is_broken:
            raise OSError(5)
        self.calls.append([name, force])
        if self.problem is not None and not force:
            return self.problem
        self.is_armed = is_armed
        return None


class Bench:
    """A vehicle with connections of these MAVLink versions."""

    def __init__(self, versions=(2,), longest=78, messages_in=None):
        self.calls = []
        self.vehicle = Vehicle(self.calls)
        for version in versions:
            port = Port()
            known = services.receivable() if messages_in is None else messages_in
            link = Link(port, 1, 1, version, known, longest)
            self.vehicle.connections.append(self._connection(port, link))
        self.connection = self.vehicle.connections[0]
        self.port = self.connection.port

    def _connection(self, port, link):
        return Connection(self.vehicle, port, link, lambda _budget: Streams(link, self.calls))

    def passes(self, count):
        """Run so many passes of 2.5 ms."""
        for _ in range(count):
            for connection in self.vehicle.connections:
                connection.run(time.ticks_ms())
            mock_time.advance_us(2500)
