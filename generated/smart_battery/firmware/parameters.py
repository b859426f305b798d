# Generated from specs/smart_battery/parameters.yaml: do not edit.
# Inputs: c58b4526c9f4728d
"""Parameters of the vehicle, kept as whole steps so that arithmetic with them is exact."""

import struct

from conversion import to_steps
from message import keep

# Of each its name, the smallest and the largest steps, numerator and denominator (a value is steps * numerator /
# denominator), the MAV_PARAM_TYPE that it goes out as, 1 where a new value is used after a restart only, and the steps
# that are accepted, where not all between the limits are. As text they take a fraction of what objects would.
_LINES = (
    "\nBATT_CAPACITY 0 1000000 1 1 6 0"  # int32
    "\nBATT_ID 0 9 1 1 1 1"  # uint8
    "\nBATT_MONITOR 0 3 1 1 2 1 0 3"  # int8
    "\nBATT_REPORT 0 2 1 1 2 0"  # int8
    "\nBATT_STATUS_RATE 0 100 1 10 9 0"  # real32
    "\nBATT_V2_RATE 0 100 1 10 9 0"  # real32
    "\nBATT_VOLT_MULT 10000 100000 1 10000 9 1"  # real32
    "\nBATT_VOLT_PIN 26 28 1 1 2 1"  # int8
    "\nCOMPID_BATT 1 255 1 1 4 1"  # int16
    "\nSYSID_THISMAV 1 255 1 1 4 1"  # int16
    "\n"
)
COUNT = 10


class Parameters:
    """The parameters, at first with their defaults.

    An attribute has the steps of each, its name in small letters; set() checks, an attribute that is written does not.
    `changes` counts what has changed: whoever keeps something that was made of parameters makes it anew then.
    """

    def __init__(self):
        keep(self, "changes", 0)
        self._kept = b""  # records of parameters that only another firmware knows
        # Charge of the full pack.
        self.batt_capacity = 3300  # 3300 mAh
        # Id of the battery in its messages; the autopilot's own batteries have 0 and 1.
        self.batt_id = 2  # 2
        # How the battery is measured; 0 leaves it out of measurements and telemetry.
        self.batt_monitor = 3  # 3: Analog Voltage Only
        # Which generation of battery messages is sent; the other one is sent when a ground station asks for it.
        self.batt_report = 0  # 0: Old
        # Rate of BATTERY_STATUS, where BATT_REPORT chooses the old generation; 0 switches it off.
        self.batt_status_rate = 5  # 0.5 Hz, in steps of 0.1 Hz
        # Rate of BATTERY_STATUS_V2, where BATT_REPORT chooses the new generation; 0 switches it off.
        self.batt_v2_rate = 10  # 1 Hz, in steps of 0.1 Hz
        # Pack voltage over the voltage at the ADC pin, set by the divider and calibrated against a meter.
        self.batt_volt_mult = 39500  # 3.95, in steps of 0.0001
        # GPIO number of the pin that the divided battery voltage is connected to.
        self.batt_volt_pin = 26  # 26
        # MAVLink component id; 180 for the first battery of a vehicle, 181 for the second, others for more.
        self.compid_batt = 180  # 180
        # MAVLink system id, that of the vehicle that the battery is part of.
        self.sysid_thismav = 1  # 1
        keep(self, "changes", 0)

    def __setattr__(self, name, value):
        keep(self, name, value)
        keep(self, "changes", self.changes + 1)

    def names(self):
        """Return the names in their order; a name's place is the parameter's index."""
        return [name_of(index) for index in range(COUNT)]

    def get(self, name):
        """Return the value of a parameter. KeyError: there is no such parameter."""
        if _place(name) < 0:
            raise KeyError(name)
        return self.value(name, getattr(self, attribute_of(name)))

    def value(self, name, steps):
        """Return what so many steps of a parameter are worth."""
        about = facts_of(name)
        return steps * about[2] / about[3]

    def limits(self, name):
        """Return the smallest and the largest value of a parameter."""
        about = facts_of(name)
        return self.value(name, about[0]), self.value(name, about[1])

    def type_of(self, name):
        """Return the MAV_PARAM_TYPE that a parameter goes out as."""
        return facts_of(name)[4]

    def is_after_reboot(self, name):
        """Return whether a new value is used only after the next start."""
        return facts_of(name)[5] != 0

    def set(self, name, value):
        """Take a value over, rounded to the nearest step; return whether it was accepted.

        Unknown names, NaN and values outside the limits change nothing.
        """
        steps = self._steps(name, value)
        if steps is None:
            return False
        if getattr(self, attribute_of(name)) != steps:
            changes = self.changes
            setattr(self, attribute_of(name), steps)
            keep(self, "changes", changes + 1)  # a small port does not ask __setattr__
        return True

    def _steps(self, name, value):
        """Return the steps of an acceptable value, else None."""
        if _place(name) < 0:
            return None
        about = facts_of(name)
        steps = to_steps(value, about[3], about[2])
        if steps is None or not about[0] <= steps <= about[1] or steps not in (about[6:] or (steps,)):
            return None
        return steps

    def dump(self):
        """Return what differs from the defaults, for the storage.

        Each is the length of its name in a byte, its name and its value as a float of 32 bits: a later firmware with
        other steps still understands it.
        """
        defaults = Parameters()
        records = []
        for name in self.names():
            if getattr(self, attribute_of(name)) != getattr(defaults, attribute_of(name)):
                records.append(bytes([len(name)]) + name.encode() + struct.pack("<f", self.get(name)))
        return self._kept + b"".join(records)

    def restore(self, data):
        """Take over what dump() returned, perhaps of another firmware; return what could not be, as texts."""
        problems = []
        at = 0
        while at < len(data):
            end = at + 1 + data[at]
            if end + 4 > len(data):
                problems.append("the stored parameters end within one")
                break
            name = "".join([chr(byte) for byte in data[at + 1 : end]])
            value = struct.unpack("<f", data[end : end + 4])[0]
            steps = self._steps(name, value)
            if steps is None:
                problems.append(f"stored {name} = {value} is not accepted")
                if _place(name) < 0:
                    self._kept += data[at : end + 4]
            else:
                setattr(self, attribute_of(name), steps)
            at = end + 4
        return problems


def attribute_of(name):
    """Return the attribute of Parameters that has the steps of a parameter."""
    return name.lower()


def name_of(index):
    """Return the name of the parameter with an index, from 0 to COUNT - 1."""
    start = 0
    for _ in range(index):
        start = _LINES.find("\n", start + 1)
    return _LINES[start + 1 : _LINES.find(" ", start)]


def index_of(name):
    """Return the index of a parameter, None if there is none of this name."""
    start = _place(name)
    return None if start < 0 else _LINES.count("\n", 0, start)


def _place(name):
    """Return where the line of a parameter begins, -1 if there is none of this name, whatever that is."""
    return -1 if " " in name else _LINES.find(f"\n{name} ")


def facts_of(name):
    """Return the numbers in the line of a parameter."""
    start = _place(name) + 1
    return [int(word) for word in _LINES[start : _LINES.find("\n", start)].split()[1:]]
