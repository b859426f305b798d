# Generated from specs/parameters.yaml: do not edit.
# Inputs: bb52ebbfbbaaa1de
"""Parameters of the vehicle, kept as whole steps so that arithmetic with them is exact."""

import struct

from conversion import to_steps
from message import keep

# Of each its name, the smallest and the largest steps, numerator and denominator (a value is steps * numerator /
# denominator), the MAV_PARAM_TYPE that it goes out as, 1 where a new value is used after a restart only, and the steps
# that are accepted, where not all between the limits are. As text they take a fraction of what objects would.
_LINES = (
    "\nARMING_CHECK 1 1 1 1 6 0"  # int32
    "\nBATT2_AMP_OFFSET 0 3300 1 1000 9 1"  # real32
    "\nBATT2_AMP_PERVLT 0 9900 1 100 9 1"  # real32
    "\nBATT2_ARM_MAH 0 1000000 1 1 6 0"  # int32
    "\nBATT2_ARM_VOLT 0 100000 1 1000 9 0"  # real32
    "\nBATT2_CAPACITY 0 1000000 1 1 6 0"  # int32
    "\nBATT2_CRT_MAH 0 1000000 1 1 9 0"  # real32
    "\nBATT2_CRT_VOLT 0 100000 1 1000 9 0"  # real32
    "\nBATT2_CURR_PIN 26 28 1 1 2 1"  # int8
    "\nBATT2_FS_CRT_ACT 0 5 1 1 2 0"  # int8
    "\nBATT2_FS_LOW_ACT 0 5 1 1 2 0"  # int8
    "\nBATT2_LOW_MAH 0 1000000 1 1 9 0"  # real32
    "\nBATT2_LOW_TIMER 0 120 1 1 2 0"  # int8
    "\nBATT2_LOW_VOLT 0 100000 1 1000 9 0"  # real32
    "\nBATT2_MONITOR 0 29 1 1 2 1 0 3 4 29"  # int8
    "\nBATT2_VOLT_MULT 10000 100000 1 10000 9 1"  # real32
    "\nBATT2_VOLT_PIN 26 28 1 1 2 1"  # int8
    "\nBATT_AMP_OFFSET 0 3300 1 1000 9 1"  # real32
    "\nBATT_AMP_PERVLT 0 9900 1 100 9 1"  # real32
    "\nBATT_ARM_MAH 0 1000000 1 1 6 0"  # int32
    "\nBATT_ARM_VOLT 0 100000 1 1000 9 0"  # real32
    "\nBATT_CAPACITY 0 1000000 1 1 6 0"  # int32
    "\nBATT_CRT_MAH 0 1000000 1 1 9 0"  # real32
    "\nBATT_CRT_VOLT 0 100000 1 1000 9 0"  # real32
    "\nBATT_CURR_PIN 26 28 1 1 2 1"  # int8
    "\nBATT_FS_CRT_ACT 0 5 1 1 2 0"  # int8
    "\nBATT_FS_LOW_ACT 0 5 1 1 2 0"  # int8
    "\nBATT_LOW_MAH 0 1000000 1 1 9 0"  # real32
    "\nBATT_LOW_TIMER 0 120 1 1 2 0"  # int8
    "\nBATT_LOW_VOLT 0 100000 1 1000 9 0"  # real32
    "\nBATT_MONITOR 0 29 1 1 2 1 0 3 4 29"  # int8
    "\nBATT_REPORT 0 2 1 1 2 0"  # int8
    "\nBATT_SYS_STATUS 1 16 1 1 2 0"  # int8
    "\nBATT_VOLT_MULT 10000 100000 1 10000 9 1"  # real32
    "\nBATT_VOLT_PIN 26 28 1 1 2 1"  # int8
    "\nSR0_EXTRA1 0 50 1 1 4 0"  # int16
    "\nSR0_EXTRA3 0 50 1 1 4 0"  # int16
    "\nSR0_EXT_STAT 0 50 1 1 4 0"  # int16
    "\nSYSID_THISMAV 1 255 1 1 4 1"  # int16
    "\n"
)
COUNT = 39


class Parameters:
    """The parameters, at first with their defaults.

    An attribute has the steps of each, its name in small letters; set() checks, an attribute that is written does not.
    `changes` counts what has changed: whoever keeps something that was made of parameters makes it anew then.
    """

    def __init__(self):
        keep(self, "changes", 0)
        self._kept = b""  # records of parameters that only another firmware knows
        # Which arming checks are made; 1 is all of them, and none can be left out.
        self.arming_check = 1  # 1: All
        # Voltage of the current sensor while no current flows.
        self.batt2_amp_offset = 0  # 0 V, in steps of 0.001 V
        # Current for each volt of the current sensor.
        self.batt2_amp_pervlt = 1700  # 17 A/V, in steps of 0.01 A/V
        # Least charge that is left to arm with; 0 switches the check off.
        self.batt2_arm_mah = 0  # 0 mAh
        # Least voltage to arm with; 0 switches the check off.
        self.batt2_arm_volt = 0  # 0 V, in steps of 0.001 V
        # Charge of the full pack.
        self.batt2_capacity = 3300  # 3300 mAh
        # Charge that is left below which the second failsafe acts at once, with a current sensor; 0 switches it off.
        self.batt2_crt_mah = 0  # 0 mAh
        # Voltage below which the second failsafe acts; 0 switches it off.
        self.batt2_crt_volt = 9900  # 9.9 V, in steps of 0.001 V
        # GPIO number of the pin that the current sensor of the battery is connected to.
        self.batt2_curr_pin = 28  # 28
        # What the second failsafe does.
        self.batt2_fs_crt_act = 2  # 2: Hold
        # What the first failsafe does.
        self.batt2_fs_low_act = 2  # 2: Hold
        # Charge that is left below which the first failsafe acts at once, with a current sensor; 0 switches it off.
        self.batt2_low_mah = 0  # 0 mAh
        # Time that the voltage stays below a threshold before its failsafe acts; 0 switches both failsafes off.
        self.batt2_low_timer = 10  # 10 s
        # Voltage below which the first failsafe acts; 0 switches it off.
        self.batt2_low_volt = 10500  # 10.5 V, in steps of 0.001 V
        # How the battery is measured; 0 leaves it out of measurements, checks and telemetry.
        self.batt2_monitor = 0  # 0: Disabled
        # Pack voltage over the voltage at the ADC pin, set by the divider and calibrated against a meter.
        self.batt2_volt_mult = 39500  # 3.95, in steps of 0.0001
        # GPIO number of the pin that the divided battery voltage is connected to.
        self.batt2_volt_pin = 27  # 27
        # Voltage of the current sensor while no current flows.
        self.batt_amp_offset = 0  # 0 V, in steps of 0.001 V
        # Current for each volt of the current sensor.
        self.batt_amp_pervlt = 1700  # 17 A/V, in steps of 0.01 A/V
        # Least charge that is left to arm with; 0 switches the check off.
        self.batt_arm_mah = 0  # 0 mAh
        # Least voltage to arm with; 0 switches the check off.
        self.batt_arm_volt = 0  # 0 V, in steps of 0.001 V
        # Charge of the full pack.
        self.batt_capacity = 3300  # 3300 mAh
        # Charge that is left below which the second failsafe acts at once, with a current sensor; 0 switches it off.
        self.batt_crt_mah = 0  # 0 mAh
        # Voltage below which the second failsafe acts; 0 switches it off.
        self.batt_crt_volt = 9900  # 9.9 V, in steps of 0.001 V
        # GPIO number of the pin that the current sensor of the battery is connected to.
        self.batt_curr_pin = 28  # 28
        # What the second failsafe does.
        self.batt_fs_crt_act = 2  # 2: Hold
        # What the first failsafe does.
        self.batt_fs_low_act = 2  # 2: Hold
        # Charge that is left below which the first failsafe acts at once, with a current sensor; 0 switches it off.
        self.batt_low_mah = 0  # 0 mAh
        # Time that the voltage stays below a threshold before its failsafe acts; 0 switches both failsafes off.
        self.batt_low_timer = 10  # 10 s
        # Voltage below which the first failsafe acts; 0 switches it off.
        self.batt_low_volt = 10500  # 10.5 V, in steps of 0.001 V
        # How the battery is measured; 0 leaves it out of measurements, checks and telemetry.
        self.batt_monitor = 3  # 3: Analog Voltage Only
        # Which generation of battery messages is sent; the other one is sent when a ground station asks for it.
        self.batt_report = 0  # 0: Old
        # Number of the battery that SYS_STATUS is about, from 1; where that one is switched off, the first that is not.
        self.batt_sys_status = 1  # 1
        # Pack voltage over the voltage at the ADC pin, set by the divider and calibrated against a meter.
        self.batt_volt_mult = 39500  # 3.95, in steps of 0.0001
        # GPIO number of the pin that the divided battery voltage is connected to.
        self.batt_volt_pin = 26  # 26
        # Rate of the EXTRA1 stream; 0 switches it off.
        self.sr0_extra1 = 2  # 2 Hz
        # Rate of the EXTRA3 stream; 0 switches it off.
        self.sr0_extra3 = 1  # 1 Hz
        # Rate of the EXTENDED_STATUS stream; 0 switches it off.
        self.sr0_ext_stat = 1  # 1 Hz
        # MAVLink system id of the vehicle.
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
