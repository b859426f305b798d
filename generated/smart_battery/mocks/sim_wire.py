# Generated from templates/mocks/sim_wire.py: do not edit.
# Inputs: 8bf7afb8c3030b5c
"""What goes over the wire in a simulation: the frames that a port took, and what they say about the batteries."""

import math

ARMED_FLAG = 128  # MAV_MODE_FLAG_SAFETY_ARMED
_READ = ("HEARTBEAT", "BATTERY_STATUS", "BATTERY_STATUS_V2")


class Wire:
    """What goes out, taken from the frames that a port accepted.

    `instances` is how many batteries the firmware has, and `first_number` returns the id of the first. `millivolts` is
    what was reported last, by instance; None for unknown.
    """

    def __init__(self, records, instances, first_number):
        import messages  # noqa: PLC0415 - the firmware's own, after the clock
        from receiver import Receiver  # noqa: PLC0415

        classes = [getattr(messages, name) for name in dir(messages)]
        classes = [cls for cls in classes if isinstance(cls, type) and getattr(cls, "NAME", "")]
        self._names = {cls.ID: cls.NAME for cls in classes}
        self._read_ids = [cls.ID for cls in classes if cls.NAME in _READ]
        self._receiver = Receiver([cls() for cls in classes if cls.NAME in _READ])
        self._records = records
        self._instances = instances
        self._first_number = first_number
        self._next_sequence = {}
        self._port_class = None
        self.counts = {}
        self.frames = 0
        self.size = 0
        self.gaps = 0
        self.is_armed = False
        self.status = None
        self.millivolts = {}

    def listen(self, port_class):
        """Take note of every frame that ports of this class accept."""
        self._port_class = port_class
        write = port_class.write

        def heard(port, frame):
            taken = write(port, frame)
            if taken:
                self.take(port, frame)
            return taken

        port_class.write = heard

    def take(self, port, frame):
        """Take note of one whole frame."""
        is_new = frame[0] == 0xFD
        number = frame[7] | frame[8] << 8 | frame[9] << 16 if is_new else frame[5]
        self._check_sequence(port, frame[4] if is_new else frame[2])
        count = self.counts.setdefault(self._names.get(number, str(number)), [0, 0])
        count[0] += 1
        count[1] += len(frame)
        self.frames += 1
        self.size += len(frame)
        if number in self._read_ids:
            self._receiver.put(bytes(frame))
            message = self._receiver.receive()
            while message is not None:
                self._read(message)
                message = self._receiver.receive()

    def _check_sequence(self, port, sequence):
        expected = self._next_sequence.get(id(port), sequence)
        self._next_sequence[id(port)] = (sequence + 1) & 0xFF
        self.gaps += (sequence - expected) & 0xFF

    def _read(self, message):
        if message.NAME == "HEARTBEAT":
            self.is_armed = bool(message.base_mode & ARMED_FLAG)
            self.status = message.system_status
            return
        instance = message.id - self._first_number() if self._instances > 1 else 0
        if not 0 <= instance < self._instances:
            return
        if message.NAME == "BATTERY_STATUS":
            millivolts = _millivolts(message)
            current = message.current_battery
            milliamperes = None if current is None else current * 10
        else:
            millivolts = _thousandths(message.voltage)
            milliamperes = _thousandths(message.current)
        self.millivolts[instance] = millivolts
        self._records.put("battery", instance=instance, millivolts=millivolts, milliamperes=milliamperes)

    def status_of_links(self, vehicle):
        """Return the sums of the counters that the heard ports and their links keep."""
        connections = getattr(vehicle, "connections", None) or ()
        heard = [connection for connection in connections if isinstance(connection.port, self._port_class)]
        return {
            "dropped": sum(connection.port.dropped for connection in heard),
            "received": sum(connection.port.received for connection in heard),
            "crc_errors": sum(connection.link.crc_errors for connection in heard),
            "gaps": self.gaps,
        }


class SilentPort:
    """A port without anybody at its other end."""

    is_up = False
    dropped = sent = received = 0

    def __init__(self, name):
        self.name = name

    def readinto(self, buffer):  # noqa: ARG002 - nothing arrives
        """Read nothing."""
        return 0

    def write(self, frame):  # noqa: ARG002 - nobody takes it
        """Take nothing."""
        return 0

    def poll(self, now_ms):
        """Do nothing."""


def _millivolts(status):
    """Return the sum of the cells of a BATTERY_STATUS, None if none is known."""
    cells = [cell for cell in status.voltages if cell is not None]
    cells += [cell for cell in getattr(status, "voltages_ext", ()) if cell is not None]
    return sum(cells) if cells else None


def _thousandths(value):
    """Return thousandths of a number, rounded; None for None and NaN."""
    return None if value is None or math.isnan(value) else round(value * 1000)
