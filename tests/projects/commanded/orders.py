"""Runs the whole program of the boat, in `generated` of the folder that it is started in, by the steps of orders.json.

It prints a line for each case: the frames that were sent, as hexadecimal digits, and what the methods of the vehicle
were given.
"""

import gc
import json
import sys

sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]

from program_bench import Craft, Port, run  # noqa: E402


class Boat(Craft):
    """Notes what each method is given; `says` has what it returns, or raises."""

    def __init__(self):
        self.given = []
        self.says = {}
        Craft.__init__(self, ports=[Port(), Port()])

    def _do(self, name, *values):
        self.given.append([name] + [[str(value), type(value).__name__] for value in values])
        said = self.says.get(name)
        if isinstance(said, list):
            said = said.pop(0) if said else None
        if said == "raise":
            raise ValueError("no water")
        return NotImplemented if said == "not written" else said

    def pump(self, duration, power):
        return self._do("pump", duration, power)

    def pump_progress(self):
        return self._do("progress")

    def pump_cancel(self):
        return self._do("cancel")

    def change_speed(self, kind, speed, throttle):
        return self._do("speed", kind, speed, throttle)

    def count(self, most, least, beside, wide):
        return self._do("count", most, least, beside, wide)

    def set_lights(self, level, lamps):
        return self._do("lights", level, lamps)

    def go_to(self, lat, lon, speed, options):
        return self._do("go", lat, lon, speed, options)

    def turn(self, angle, direction, relative):
        return self._do("turn", angle, direction, relative)

    def lower(self, depth, frame):
        return self._do("lower", depth, frame)

    def set_home(self, lat, lon, altitude):
        return self._do("home", lat, lon, altitude)

    def land(self, north, east):
        return self._do("land", north, east)

    def move_flap(self, flap):
        return self._do("flap", flap)

    def check_mode(self, _mode):
        return self.says.get("check_mode")


def played(steps):
    """Return the frames of both links and what was given in a case."""
    boat = Boat()
    ports = [connection.port for connection in boat.connections]
    for verb, *values in steps:
        if verb == "frame":
            ports[values[0]].arrives(bytes.fromhex(values[1]))
            run(boat, 40000)
        elif verb == "run":
            run(boat, values[0] * 1000)
        elif verb == "says":
            boat.says[values[0]] = values[1]
        elif verb == "arm":
            assert boat.arm() is None
        elif verb == "set_mode":
            boat.given.append([str(boat.set_mode(values[0]))])
    kept = [[frame.hex() for frame in port.frames if frame[7] in (0, 77, 253)] for port in ports]
    return {"frames": kept, "given": boat.given, "faults": [each.faults for each in boat.connections]}


with open("orders.json") as file:  # a case in each line: all at once would need much memory
    for line in file:
        name, steps = json.loads(line)
        sys.stdout.write(json.dumps([name, played(steps)]) + "\n")
        gc.collect()
