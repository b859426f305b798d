"""Objects of the firmware have all attributes from their beginning: one that gets more later takes heap then."""

import sys

from program_bench import (
    IS_MICROPYTHON,
    GOES_OUT,
    SECOND_US,
    Flash,
    GroundStation,
    Port,
    finish,
    main,
    messages,
    mock_time,
    needs,
    new_craft,
    run,
    run_passes,
    save,
)
from program_facts import FORCE_ARM, PARAMETERS
from serial_port import StreamPort
from storage import Storage
from udp_port import UdpPort

import dialect
import network_port


class Beginnings:
    """Notes which attributes each object of the firmware has once it is made."""

    def __init__(self):
        self.made = []
        self.before = []

    def __enter__(self):
        for module in list(sys.modules.values()):
            if "firmware" in (getattr(module, "__file__", None) or ""):
                for kind in list(vars(module).values()):
                    if isinstance(kind, type) and kind.__module__ == module.__name__ and "__init__" in vars(kind):
                        self.before.append((kind, kind.__init__))
                        kind.__init__ = self.noting(kind, kind.__init__)
        return self

    def __exit__(self, *_raised):
        for kind, begin in self.before:
            kind.__init__ = begin

    def begin_anew(self):
        """Note again what each has: it is complete with what stands around it."""
        self.made = [(own, set(vars(own))) for own, _ in self.made]

    def noting(self, kind, begin):
        """Return what makes an object, and notes what it has then."""

        def note(own, *values, **named):
            begin(own, *values, **named)
            if type(own) is kind and hasattr(own, "__dict__"):
                self.made.append((own, set(vars(own))))

        return note


def nothing_is_added_later():
    """Whatever a vehicle, its links and its ports are asked to do."""
    needs(not IS_MICROPYTHON, "a way to look into classes")
    with Beginnings() as beginnings:
        _live_through_all(beginnings)
    added = {
        (type(own).__name__, name)
        for own, begun in beginnings.made
        for name in set(vars(own)) - begun
        if not isinstance(own, Exception)
    }
    assert added == set(), sorted(added)
    assert len(beginnings.made) > 20, len(beginnings.made)


def _live_through_all(beginnings):
    """Let a vehicle do most of what it can do, from its first pass on, and parts of it by themselves."""
    craft = new_craft(flash=Flash(), ports=[Port(), Port()])
    beginnings.begin_anew()
    stations = [GroundStation(connection.port) for connection in craft.connections]
    run(craft, SECOND_US)
    for station in stations:
        station.send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS)
        station.send(messages.Ping, target_system=0, target_component=0)
        for number in GOES_OUT:
            station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, 500000)
            station.command(dialect.MAV_CMD_REQUEST_MESSAGE, number)
            run_passes(craft, 4)
        if PARAMETERS:
            station.send(messages.ParamRequestList)
            station.set_parameter(PARAMETERS[0], 1)
        run(craft, SECOND_US)
    if FORCE_ARM is not None:
        craft.arm(force=True)
        run(craft, SECOND_US)
        craft.disarm()
    craft.port.room = 0
    craft.texts("warning: " + "it is long " * 10)
    run(craft, SECOND_US)
    craft.port.room = None
    run(craft, SECOND_US)
    if PARAMETERS:
        save(craft)
    storage = Storage(("a", "b"), 64)
    storage.load()
    storage.begin(b"payload")
    finish(storage)
    port = StreamPort("attributes", Port(), 100)
    port.write(b"frame")
    port.readinto(bytearray(5))
    port.poll(0)
    port = UdpPort("attributes", "127.0.0.1", 1, 0, None, 1000, lambda *_words: None)
    port.poll(mock_time.ticks_ms())
    port.write(b"frame")
    port.read()
    port._close()
    wifi = network_port._Wifi("attributes", None, 5000)
    wifi.poll(0)


CHECKS = ((nothing_is_added_later,),)
LONG = (nothing_is_added_later,)

if __name__ == "__main__":
    main(CHECKS)
