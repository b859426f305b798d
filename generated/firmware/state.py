# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 5557e20688bf36f5
"""State of the vehicle: 32-bit words in one array, in the units that go out; attributes are views of them.

Attributes show what is kept in the units of people, or, by their longer names, as it is; None is unknown. To set one to
None or NaN makes it unknown.
"""

import time
from array import array

from frames import address
from lists import elements, shown_elements
from micropython import const
from parameters import Parameters
from thresholds import at_least, below
from words import KINDS, UNKNOWN, Component, number, together, truth, whole

try:
    from state_viper import expire_battery, read_battery
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from state_plain import expire_battery, read_battery

KINDS["at_least"] = at_least
KINDS["below"] = below

_SIZE = const(179)
# Where each component's words begin, how many each instance takes, and what stands where among them.
_BATTERY = const(0)
_BATTERY_SIZE = const(87)
_BATTERY_VOLTAGE_MV = const(0)
_BATTERY_CURRENT_MA = const(1)
_BATTERY_CONSUMED_MAH = const(2)
_BATTERY_ENERGY_HJ = const(3)
_BATTERY_REMAINING_PCT = const(4)
_BATTERY_LEFT_MAH = const(5)
_BATTERY_TIME_LEFT_S = const(6)
_BATTERY_COUNTED_FROM_FULL = const(7)
_BATTERY_TEMPERATURE_CDEGC = const(8)
_BATTERY_TREND_MV_S = const(9)
_BATTERY_HEALTH_NUMBER = const(10)
_BATTERY_FAILSAFE_NUMBER = const(11)
_BATTERY_SWAPS_NUMBER = const(12)
_BATTERY_MONITORED = const(13)
_BATTERY_PROTECTED = const(14)
_BATTERY_LOWEST_CELL_MV = const(15)
_BATTERY_HIGHEST_CELL_MV = const(16)
_BATTERY_COUNT = const(17)
_BATTERY_MULTIPLIER = const(18)
_BATTERY_FAILURES = const(19)
_BATTERY_IS_LOGGED = const(20)
_BATTERY_IS_SET = const(21)
_BATTERY_EXPIRES_MS = const(22)
_BATTERY_WARNED_MS = const(23)
_BATTERY_GONE = const(24)
_BATTERY_SET_AGE = const(25)
_BATTERY_CURRENT_COUNT = const(26)
_BATTERY_CURRENT_MULTIPLIER = const(27)
_BATTERY_CURRENT_OFFSET = const(28)
_BATTERY_CURRENT_FAILURES = const(29)
_BATTERY_CURRENT_IS_LOGGED = const(30)
_BATTERY_CURRENT_IS_READ = const(31)
_BATTERY_CURRENT_EXPIRES_MS = const(32)
_BATTERY_CURRENT_SINCE_MS = const(33)
_BATTERY_CONSUMED_REST = const(34)
_BATTERY_ENERGY_LOW = const(35)
_BATTERY_ENERGY_MIDDLE = const(36)
_BATTERY_ENERGY_HIGH = const(37)
_BATTERY_BATT_CAPACITY = const(38)
_BATTERY_TIME_LEFT_MEAN = const(39)
_BATTERY_TREND_COUNT = const(40)
_BATTERY_TREND_NEWER = const(41)
_BATTERY_TREND_OLDER = const(42)
_BATTERY_TREND_READINGS = const(43)
_BATTERY_CELLS_MV_AGE = const(83)
_BATTERY_CELLS_MV = const(84)
_VEHICLE = const(174)
_VEHICLE_SIZE = const(5)
_VEHICLE_ARMED = const(0)
_VEHICLE_READY = const(1)
_VEHICLE_MODE_NUMBER = const(2)
_VEHICLE_STATUS = const(3)
_VEHICLE_LOAD_DPCT = const(4)

# Names of the parameters that each has of its own.
_BATT_MONITOR = ("batt_monitor", "batt2_monitor")
_BATT_VOLT_MULT = ("batt_volt_mult", "batt2_volt_mult")


class BatteryState(Component):
    """One battery of the rover."""

    NAME = "battery"
    SIZE = _BATTERY_SIZE
    # What is known from the start: places and values, for each of them where it differs.
    START = (
        _BATTERY_CONSUMED_REST,
        1800000,
        _BATTERY_ENERGY_LOW,
        0,
        _BATTERY_ENERGY_MIDDLE,
        0,
        _BATTERY_ENERGY_HIGH,
        50000,
        _BATTERY_COUNTED_FROM_FULL,
        0,
        _BATTERY_HEALTH_NUMBER,
        2,
        _BATTERY_FAILSAFE_NUMBER,
        0,
        _BATTERY_SWAPS_NUMBER,
        0,
        _BATTERY_MONITORED,
        1,
        _BATTERY_PROTECTED,
        0,
        _BATTERY_TREND_COUNT,
        0,
        _BATTERY_TREND_NEWER,
        0,
        _BATTERY_TREND_OLDER,
        0,
        _BATTERY_FAILURES,
        0,
        _BATTERY_IS_LOGGED,
        0,
        _BATTERY_CURRENT_FAILURES,
        0,
        _BATTERY_CURRENT_IS_LOGGED,
        0,
        _BATTERY_GONE,
        0,
    )
    # Attributes, made when they are first used: names, kind and what words.py tells that kind.
    VIEWS = (
        # Voltage of the whole pack [mV]
        # V, or None while it is unknown; FR-00069.1
        " voltage_mv: voltage: number 0 0 65534 voltage 1000 1 19\n"
        # Current drawn from the pack, negative while charging. It is measured with BATT_MONITOR 4 [mA]
        # A, or None while it is unknown; FR-00077.3
        " current_ma: current: number 1 -327680 327670 current 1000 1 25\n"
        # Charge drawn since the start, or since the pack was put in [mAh]
        # mAh, or None while it is unknown; FR-00077.5
        " consumed_mah: consumed: number 2 - + consumed 1 1 25\n"
        # Energy drawn since the start, or since the pack was put in [hJ]
        # hJ, or None while it is unknown; FR-00077.5
        " energy_hj: energy: number 3 - + energy 1 1 25\n"
        # Charge that is left, of a full pack. With estimate_from and curve it follows the discharge curve [%]
        # %, or None while it is unknown; FR-00068.5
        " remaining_pct: remaining: number 4 0 100 remaining 1 1 25\n"
        # Charge that is left of BATT_CAPACITY, where current is measured [mAh]
        # mAh, or None while it is unknown; FR-00077.6
        " left_mah: left: number 5 0 + left 1 1 25\n"
        # How long the charge is enough, as far as the last half minute tells [s]
        # s, or None while it is unknown; FR-00077.7
        " time_left_s: time_left: number 6 0 1000000 time_left 1 1 25\n"
        # Whether the charge that was drawn counts from a full pack, and not from power-on
        " counted_from_full: truth 7\n"
        # Temperature of the pack. The rover has no sensor for it [cdegC]
        # degC, or None while it is unknown; FR-00068.6
        " temperature_cdegc: temperature: number 8 -32768 32766 temperature 100 1 25\n"
        # Change of the pack's voltage per second, positive while it rises [mV/s]
        " trend_mv_s: whole 9 - + trend\n"
        # V/s, or None while it is unknown; FR-00021.1
        " trend: result 9 1000\n"
        # 0 healthy, 1 warning (below BATT_LOW_VOLT), 2 unhealthy (below BATT_CRT_VOLT, or unknown)
        # A number, known from the start; FR-00021.3
        " health_number: health: number 10 0 2 health 1\n"
        # The level that the failsafe has reached, 0 none, 1 low, 2 critical
        # A number, known from the start; FR-00073.5
        " failsafe_number: failsafe: number 11 0 2 failsafe 1\n"
        # Whether no pack is connected. One that works has more volts; a failed reading does not count
        # FR-00073.8
        " absent: below 0 3000\n"
        # How often a pack was put in since the start, and so may be another one
        # A number, known from the start; FR-00073.8
        " swaps_number: swaps: number 12 0 1000000 swaps 1\n"
        # Whether the pack is measured at all: whether BATT_MONITOR is not 0
        " monitored: truth 13\n"
        # Whether the pack's voltage is known
        # FR-00067.3
        " healthy: known 0\n"
        # Whether current flows into the pack
        # FR-00072.5
        " charging: below 1 0\n"
        # Whether the pack cannot be relied on. Its voltage is too low, or unknown
        # FR-00072.5
        " unhealthy: at_least 10 2\n"
        # Whether the failsafe has found the pack low. Until the next start nothing arms the rover
        # FR-00072.5
        " used_up: at_least 11 1\n"
        # Whether the pack is charged above what its cells stand
        # FR-00072.5
        " over_voltage: at_least 0 12750\n"
        # Whether the pack is below what its cells stand
        # FR-00072.5
        " under_voltage: below 0 9000 None 3000\n"
        # Whether the pack is warmer than it may be while it is discharged
        # FR-00072.5
        " hot: at_least 8 6000\n"
        # Whether the pack is colder than it may be while it is discharged
        # FR-00072.5
        " cold: below 8 -2000\n"
        # Whether protective circuits in the pack are on. The rover cannot tell; code that can sets it
        " protected: truth 14\n"
        # Voltage of the cell that has the least [mV]
        # V, or None while it is unknown; FR-00072.5
        " lowest_cell_mv: lowest_cell: number 15 - + lowest_cell 1000\n"
        # Voltage of the cell that has the most [mV]
        # V, or None while it is unknown; FR-00072.5
        " highest_cell_mv: highest_cell: number 16 - + highest_cell 1000\n"
        # Whether a cell is charged above what it stands, whatever the pack's voltage is
        # FR-00072.5
        " cell_over_voltage: at_least 16 4250\n"
        # Whether a cell is below what it stands, whatever the pack's voltage is
        # FR-00072.5
        " cell_under_voltage: below 15 3000\n"
        # Whether more is drawn than the pack stands for seconds
        # FR-00072.5
        " over_current: at_least 1 132000\n"
        # Failed readings in a row
        " failures: whole 19\n"
        # When the last good reading will be too old
        " expires_ms: whole 22\n"
    )
    # Voltage of each cell. Unknown until code sets it [mV]
    cells_mv = elements(_BATTERY_CELLS_MV, 3, 0, 65534, "cells_mv", age=_BATTERY_CELLS_MV_AGE)
    cells = shown_elements("cells_mv", 1000)  # V each, or None while it is unknown; FR-00076.7

    @staticmethod
    def voltage_from_adc(adc, mult):
        """Return the volts that a count and a multiplier stand for, FR-00069.1."""
        return adc / 4095 * 3.3 * mult

    def set_count(self, count, multiplier):
        """Take over a count; the multiplier is in steps of BATT_VOLT_MULT. Return what there is to tell.

        The same formula as voltage_from_adc() in whole numbers: nothing is lost and nothing allocated. A count
        that cannot be, such as -1, is a failed reading.
        """
        words = self.words
        own = words[_BATTERY_MULTIPLIER]
        words[_BATTERY_COUNT] = count
        words[_BATTERY_MULTIPLIER] = multiplier
        told = read_battery(words, None, None, time.ticks_ms, -1)
        words[_BATTERY_MULTIPLIER] = own
        return told

    def forget(self):
        """Make everything that is measured unknown."""
        self.words[_BATTERY_VOLTAGE_MV] = UNKNOWN
        self.words[_BATTERY_CURRENT_MA] = UNKNOWN
        self.words[_BATTERY_REMAINING_PCT] = UNKNOWN
        self.words[_BATTERY_LEFT_MAH] = UNKNOWN
        self.words[_BATTERY_TIME_LEFT_S] = UNKNOWN
        self.words[_BATTERY_TREND_MV_S] = UNKNOWN
        self.words[_BATTERY_TREND_COUNT] = 0
        self.words[_BATTERY_TREND_NEWER] = 0
        self.words[_BATTERY_TREND_OLDER] = 0

    def expire(self):
        """Forget the last reading once it is older than 1000 ms, FR-00067.3."""
        expire_battery(self.words, time.ticks_ms())


class VehicleState(Component):
    """The rover as a whole."""

    NAME = "vehicle"
    SIZE = _VEHICLE_SIZE
    # What is known from the start: places and values.
    START = (
        _VEHICLE_ARMED,
        0,
        _VEHICLE_READY,
        0,
        _VEHICLE_MODE_NUMBER,
        0,
        _VEHICLE_STATUS,
        3,
        _VEHICLE_LOAD_DPCT,
        0,
    )
    # Whether the motors may turn
    armed = truth(_VEHICLE_ARMED)
    # Whether the checks before arming pass
    ready = truth(_VEHICLE_READY)
    # Drive mode, a number of the autopilot's own
    # A number, known from the start
    mode_number, mode = number(_VEHICLE_MODE_NUMBER, 0, 1000000, "mode", 1)
    # What the vehicle is doing (MAV_STATE)
    status = whole(_VEHICLE_STATUS, 0, 8, "status")
    # Share of the main loop's time that is used [d%]
    # %, known from the start
    load_dpct, load = number(_VEHICLE_LOAD_DPCT, 0, 1000, "load", 10)


class SystemState:
    """Everything the telemetry reports; `words` is the whole array."""

    def __init__(self, parameters=None, log=print):
        self.parameters = parameters or Parameters()
        self.words = array("i", [UNKNOWN] * _SIZE)
        self.words_at = address(self.words)
        self._log = log
        self.battery = together(BatteryState, self.words, _BATTERY, _BATTERY_SIZE, 2, log)
        for instance in range(2):
            words = self.battery[instance].words
            words[_BATTERY_MONITORED] = 1 if getattr(self.parameters, _BATT_MONITOR[instance]) != 0 else 0
            words[_BATTERY_MULTIPLIER] = getattr(self.parameters, _BATT_VOLT_MULT[instance])
            words[_BATTERY_IS_SET] = 1 if getattr(self.parameters, _BATT_MONITOR[instance]) == 29 else 0
        self.battery_words = tuple(self.battery[instance].words for instance in range(2))
        self._start_battery()
        self.vehicle = together(VehicleState, self.words, _VEHICLE, _VEHICLE_SIZE, 1, log)

    def _start_battery(self):
        updates = self._battery_updates()
        next(updates)
        self.update_battery = updates.send
        if any(getattr(self.parameters, each) == 4 for each in _BATT_MONITOR):
            import battery_current  # noqa: PLC0415  where it is measured only

            self.update_battery = battery_current.behind(self.update_battery, self, self._log)

    def _battery_updates(self):
        """Go on for ever: update_battery(board) is one turn, which takes one reading of each, FR-00067.1.

        Call it every 100 ms. It never raises. A failed reading keeps the last value; 5 in a row make it unknown.
        What lives on between the calls can keep an exception without heap at each of them, and looks up no names.
        """
        words = self.words
        every = self.battery_words
        read = read_battery
        ticks = time.ticks_ms
        first = 0
        try:
            board = yield
            while True:
                try:
                    told = read(words, every, board, ticks, first)
                    if told:
                        first = (told >> 4) + 1
                        self.tell_battery(told & 15, told >> 4)
                    else:
                        first = 0
                        board = yield
                except Exception as error:
                    from reading_turns import failed  # noqa: PLC0415  boards of codegen raise nothing

                    places = (_BATTERY_COUNT, _BATTERY_FAILURES)
                    first = failed(read, every, places, self.tell_battery, error, first)
        except (KeyboardInterrupt, SystemExit):
            self._start_battery()  # a generator that was interrupted cannot go on
            raise

    def tell_battery(self, told, instance, error=None):
        """Do what a reading gives cause to, or tell of a board that raises."""
        value = self.battery[instance].voltage
        if told & 1:
            self._log(f"battery {instance + 1}: voltage {value:.2f} V")
        if told & 2:
            self._log(f"notice: Battery {instance + 1} connected")
        if told & 4:
            self._log(f"warning: battery {instance + 1}'s voltage is above 13 V:", value)
        if error is not None:
            self._log(f"error: the board cannot read battery {instance + 1}:", str(error) or type(error).__name__)

    def calibrate_battery(self, measured, instance=0):
        """Set its multiplier to what a meter shows, in V; return whether it was accepted.

        new = old * measured / reading, FR-00069.6; it counts from the next start.
        """
        reading = self.battery[instance].voltage
        if not reading or measured is None or None not in self.battery[instance].cells:
            return False  # or it is a sum that calibrates nothing
        if self.battery[instance].words[_BATTERY_IS_SET]:
            return False  # code sets it
        own = self.battery[instance].words[_BATTERY_MULTIPLIER]
        old = self.parameters.value(("BATT_VOLT_MULT", "BATT2_VOLT_MULT")[instance], own)
        return self.parameters.set(("BATT_VOLT_MULT", "BATT2_VOLT_MULT")[instance], old * measured / reading)
