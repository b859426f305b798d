"""One pass of a link of the rover: with nothing to do, and with a HEARTBEAT of a ground station. See counting.py."""

import counting  # isort: skip  before anybody looks at the clock
import dialect
import messages
from mavlink import Link
from vehicle import Vehicle


class Port:
    """A port that takes everything; `frame` is what arrives in each pass, once."""

    name = "port"
    is_up = True
    frame = b""
    waiting = b""

    def readinto(self, buffer):
        """Let the frame arrive."""
        length = len(self.waiting)
        buffer[:length] = self.waiting
        self.waiting = b""
        return length

    def write(self, frame):
        """Take all."""
        return len(frame)

    def poll(self, _now_ms):
        """A pass ends."""
        self.waiting = self.frame


port = Port()
vehicle = Vehicle(ports=[port])
connection = vehicle.connections[0]
station = Link(None, 255, 190)
heartbeat = bytes(station.encode(messages.Heartbeat(unknown=False).update(type=dialect.MAV_TYPE_GCS)))


def idle(rounds):
    """Nothing is due and nothing arrives."""
    port.frame = b""
    run = connection.run
    for _ in range(rounds):
        run(0)


def hear(rounds):
    """A HEARTBEAT arrives in each pass."""
    port.frame = heartbeat
    run = connection.run
    for _ in range(rounds):
        run(0)


hear(50)  # what is due at the start goes out, and what a new ground station is told
before = connection.link.received
hear(1)
if connection.link.received != before + 1 or connection.faults:
    raise SystemExit("the HEARTBEAT was not received")
counting.count(idle=idle, hear=hear)
