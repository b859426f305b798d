"""Messages that set quantities, of tests/projects/received: parsed alone, and parsed and taken. See counting.py."""

import counting  # isort: skip  before anybody looks at the clock
import messages
from mavlink import Link
from texts import Texts
from vehicle import Vehicle


class Port:
    """A port on which nothing arrives: frames are put into its link."""

    name = "port"
    is_up = True

    def readinto(self, _buffer):
        """Nothing."""
        return 0

    def write(self, frame):
        """Take all."""
        return len(frame)


connection = Vehicle(ports=[Port()], texts=Texts(counting.unheard)).connections[0]
link = connection.link
link._state[16] = 0  # one pass may do any work: here all rounds are in one
own = Link(None, connection.system_id, 191)  # another component of the vehicle
stick = messages.ManualControl(unknown=False).update(target=connection.system_id, x=500, buttons=3)
fix = messages.GpsInput(unknown=False).update(time_usec=7, lat=481173000, lon=115166667, alt=545.4, hdop=0.9, vn=1.5)
frames = {"manual_control": bytes(own.encode(stick)), "gps_input": bytes(own.encode(fix))}


def parsed(name):
    """Return a workload: a frame becomes a message."""
    frame = frames[name]

    def work(rounds):
        before = link.received
        for _ in range(rounds):
            link.put(frame)
            link.receive()
        return link.received - before

    return work


def taken(name, table, alone=False):
    """Return a workload: and the message sets quantities, those of one table or of all that are for it."""
    frame = frames[name]
    reception = connection.receptions[table]
    services = connection.services

    def work(rounds):
        takers = services._takers
        if alone:
            services._takers = {messages.GpsInput.ID: (reception.take, ())}
        handle = services.handle
        before = reception.taken
        for _ in range(rounds):
            link.put(frame)
            handle(link.receive())
        services._takers = takers
        return reception.taken - before

    return work


counting.count(
    stick_parsed=parsed("manual_control"),
    stick_taken=taken("manual_control", "MANUAL_CONTROL"),
    fix_parsed=parsed("gps_input"),
    fix_taken=taken("gps_input", "fix", alone=True),
    both_taken=taken("gps_input", "fix"),
)
