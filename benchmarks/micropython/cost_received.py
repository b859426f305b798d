"""Messages that set quantities, of tests/projects/received: parsed alone, and parsed and taken. See counting.py.

Each frame goes from its bytes to the words of the state as in a pass of the main loop, see connection.py; what is left
out are the port, and asking who it comes from.
"""

import counting  # isort: skip  before anybody looks at the clock
import dialect
import messages
from mavlink import Link
from message import keep
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
ground = Link(None, 255, 190)
mode = messages.Heartbeat(unknown=False).update(type=dialect.MAV_TYPE_GCS, custom_mode=77)
stick = messages.ManualControl(unknown=False).update(target=connection.system_id, x=500, buttons=3)
sticks = messages.RcChannelsOverride(unknown=False).update(
    target_system=connection.system_id, chan1_raw=1500, chan2_raw=1600, chan8_raw=1700, chan9_raw=1800, chan18_raw=1900
)
fix = messages.GpsInput(unknown=False).update(
    time_usec=7, lat=481173000, lon=115166667, alt=545.4, hdop=0.9, vn=1.5, vd=0.25, satellites_visible=9, yaw=9000
)
frames = {
    "HEARTBEAT": bytes(ground.encode(mode)),
    "MANUAL_CONTROL": bytes(own.encode(stick)),
    "RC_CHANNELS_OVERRIDE": bytes(ground.encode(sticks)),
    "fix": bytes(own.encode(fix)),
}
link.put(frames["HEARTBEAT"])
connection.services.handle(link.receive())  # a ground station is heard


def parsed(name):
    """Return a workload: a frame becomes a message."""
    frame = frames[name]
    put, receive = link.put, link.receive

    def work(rounds):
        before = link.received
        for _ in range(rounds):
            put(frame)
            receive()
        return link.received - before

    return work


def taken(name, both=False):
    """Return a workload: and the message sets quantities, those of one table or of both that are for it."""
    frame = frames[name]
    reception = connection.receptions[name]
    put, receive = link.put, link.receive

    def work(rounds):
        put(frame)
        message = receive()
        number, tables = message.ID, connection.tables
        before = reception.taken
        of_all = message._take
        if not both:
            keep(message, "_take", reception.take)
        for _ in range(rounds):
            put(frame)
            message = receive()
            take = message._take
            found = 0 if take is None else take(0)
            if found:
                if found > 0:
                    tables[number].tell()
                found = tables[number].called
                if found is not None:
                    found()
        keep(message, "_take", of_all)
        return reception.taken - before

    return work


counting.count(
    mode_parsed=parsed("HEARTBEAT"),
    mode_taken=taken("HEARTBEAT"),
    stick_parsed=parsed("MANUAL_CONTROL"),
    stick_taken=taken("MANUAL_CONTROL"),
    sticks_parsed=parsed("RC_CHANNELS_OVERRIDE"),
    sticks_taken=taken("RC_CHANNELS_OVERRIDE"),
    fix_parsed=parsed("fix"),
    fix_taken=taken("fix"),
    both_taken=taken("fix", both=True),
)
