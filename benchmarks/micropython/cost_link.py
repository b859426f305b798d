"""One pass of a link of the rover: with nothing to do, and with a HEARTBEAT of a ground station. See counting.py."""

import counting  # isort: skip  before anybody looks at the clock
import select
import socket

import dialect
import messages
from mavlink import Link
from stations import Stations
from texts import Texts
from vehicle import Vehicle


class Port:
    """A port that takes everything, and has what the workload puts into `waiting`.

    Where nothing waits, look() is the ipoll() of a socket on which nothing arrives, as a UDP port has it.
    """

    name = "port"
    is_up = True
    waiting = b""

    def __init__(self):
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        poller = select.poll()
        poller.register(self._socket, select.POLLIN)
        self.ipoll = poller.ipoll

    def look(self, wait_ms):
        """Return something where something waits."""
        return ARRIVED if self.waiting else self.ipoll(wait_ms)

    def readinto(self, buffer):
        """Let what waits arrive."""
        length = len(self.waiting)
        buffer[:length] = self.waiting
        self.waiting = b""
        return length

    def write(self, frame):
        """Take all."""
        return len(frame)

    def poll(self, _now_ms):
        """Keep nothing back."""


class Datagrams(Port):
    """A port that tells its stations apart."""

    stations = Stations

    def __init__(self):
        super().__init__()
        self.home = ("127.0.0.1", 14550)
        self.ends = [self.home, ("127.0.0.1", 14551)]

    def read(self):
        """Return what waits."""
        data = self.waiting
        self.waiting = b""
        return data


ARRIVED = (True,)
quiet = Port()
quiet.look = quiet.ipoll  # without a detour by Python
vehicle = Vehicle(ports=[quiet, Port(), Datagrams()], texts=Texts(counting.unheard))
still, serial, udp = vehicle.connections
station = Link(None, 255, 190)
heartbeat = bytes(station.encode(messages.Heartbeat(unknown=False).update(type=dialect.MAV_TYPE_GCS)))


def idle(rounds):
    """Run passes in which nothing is due and nothing arrives."""
    run = still.run
    for _ in range(rounds):
        run(0)


def hear_on(connection, rounds):
    """A HEARTBEAT arrives in each pass."""
    port = connection.port
    run = connection.run
    for _ in range(rounds):
        port.waiting = heartbeat
        run(0)


def hear(rounds):
    """A HEARTBEAT arrives in each pass, on a port whose bytes may come in parts."""
    hear_on(serial, rounds)


def hear_udp(rounds):
    """A HEARTBEAT arrives in each pass, as a datagram."""
    hear_on(udp, rounds)


idle(50)
for connection in (serial, udp):
    hear_on(connection, 50)  # what is due at the start goes out, and what a new ground station is told
    before = connection.link.received
    hear_on(connection, 1)
    if connection.link.received != before + 1 or connection.faults:
        raise SystemExit("the HEARTBEAT was not received")
counting.count(idle=idle, hear=hear, hear_udp=hear_udp)
