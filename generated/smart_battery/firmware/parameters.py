# Generated from specs/smart_battery/parameters.yaml: do not edit.
# Inputs: c58b4526c9f4728d
"""Parameters of the vehicle, kept as whole steps so that arithmetic with them is exact."""

import struct

from conversion import to_steps

# name: (smallest, largest, numerator, denominator, type, used after a restart only)
# A value is steps * numerator / denominator, its type the MAV_PARAM_TYPE that it goes out as.
_TABLE = {
    "BATT_CAPACITY": (
        0,
        1000000,
        1,
        1,
        6,  # int32
        False,
    ),
    "BATT_ID": (
        0,
        9,
        1,
        1,
        1,  # uint8
        True,
    ),
    "BATT_MONITOR": (
        0,
        3,
        1,
        1,
        2,  # int8
        True,
    ),
    "BATT_REPORT": (
        0,
        2,
        1,
        1,
        2,  # int8
        False,
    ),
    "BATT_STATUS_RATE": (
        0,
        100,
        1,
        10,
        9,  # real32
        False,
    ),
    "BATT_V2_RATE": (
        0,
        100,
        1,
        10,
        9,  # real32
        False,
    ),
    "BATT_VOLT_MULT": (
        10000,
        100000,
        1,
        10000,
        9,  # real32
        True,
    ),
    "BATT_VOLT_PIN": (
        26,
        28,
        1,
        1,
        2,  # int8
        True,
    ),
    "COMPID_BATT": (
        1,
        255,
        1,
        1,
        4,  # int16
        True,
    ),
    "SYSID_THISMAV": (
        1,
        255,
        1,
        1,
        4,  # int16
        True,
    ),
}
NAMES = tuple(sorted(_TABLE))

_CHOICES = {}  # steps that are accepted, where not all between the limits are
_CHOICES["BATT_MONITOR"] = (0, 3)
_ATTRIBUTES = {}  # where an attribute is not called as its parameter is, in small letters


class Parameters:
    """The parameters, at first with their defaults.

    An attribute has the steps of each, its name in small letters; set() checks, an attribute that is written does not.
    `changes` counts what set() has changed.
    """

    def __init__(self):
        self.changes = 0
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

    def names(self):
        """Return the names in their order; a name's place is the parameter's index."""
        return list(NAMES)

    def get(self, name):
        """Return the value of a parameter. KeyError: there is no such parameter."""
        if name not in _TABLE:
            raise KeyError(name)
        return self.value(name, getattr(self, attribute_of(name)))

    def value(self, name, steps):
        """Return what so many steps of a parameter are worth."""
        return steps * _TABLE[name][2] / _TABLE[name][3]

    def limits(self, name):
        """Return the smallest and the largest value of a parameter."""
        return self.value(name, _TABLE[name][0]), self.value(name, _TABLE[name][1])

    def type_of(self, name):
        """Return the MAV_PARAM_TYPE that a parameter goes out as."""
        return _TABLE[name][4]

    def is_after_reboot(self, name):
        """Return whether a new value is used only after the next start."""
        return _TABLE[name][5]

    def set(self, name, value):
        """Take a value over, rounded to the nearest step; return whether it was accepted.

        Unknown names, NaN and values outside the limits change nothing.
        """
        steps = self._steps(name, value)
        if steps is None:
            return False
        if getattr(self, attribute_of(name)) != steps:
            setattr(self, attribute_of(name), steps)
            self.changes += 1
        return True

    def _steps(self, name, value):
        """Return the steps of an acceptable value, else None."""
        if name not in _TABLE:
            return None
        smallest, largest, numerator, denominator, _, _ = _TABLE[name]
        steps = to_steps(value, denominator, numerator)
        if steps is None or not smallest <= steps <= largest or steps not in _CHOICES.get(name, (steps,)):
            return None
        return steps

    def dump(self):
        """Return what differs from the defaults, for the storage.

        Each is the length of its name in a byte, its name and its value as a float of 32 bits: a later firmware with
        other steps still understands it.
        """
        defaults = Parameters()
        records = []
        for name in NAMES:
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
                if name not in _TABLE:
                    self._kept += data[at : end + 4]
            else:
                setattr(self, attribute_of(name), steps)
            at = end + 4
        return problems


def attribute_of(name):
    """Return the attribute of Parameters that has the steps of a parameter."""
    return _ATTRIBUTES.get(name) or name.lower()
