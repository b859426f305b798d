# Generated from specs/smart_battery/board.yaml, specs/smart_battery/parameters.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 3473f0c2a70bace6
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
from wide import integer, shown_integer
from words import KINDS, UNKNOWN, Component, together

try:
    from state_viper import expire_battery, read_battery
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from state_plain import expire_battery, read_battery

KINDS["at_least"] = at_least
KINDS["below"] = below
KINDS["integer"] = integer
KINDS["shown_integer"] = shown_integer

_SIZE = const(28)
# Where each component's words begin, how many each instance takes, and what stands where among them.
_BATTERY = const(0)
_BATTERY_SIZE = const(28)
_BATTERY_VOLTAGE_MV = const(0)
_BATTERY_CURRENT_MA = const(1)
_BATTERY_CONSUMED_MAH = const(2)
_BATTERY_ENERGY_HJ = const(3)
_BATTERY_REMAINING_PCT = const(5)
_BATTERY_LEFT_MAH = const(6)
_BATTERY_TIME_LEFT_S = const(7)
_BATTERY_COUNTED_FROM_FULL = const(8)
_BATTERY_TEMPERATURE_CDEGC = const(9)
_BATTERY_SWAPS_NUMBER = const(10)
_BATTERY_MONITORED = const(11)
_BATTERY_USED_UP = const(12)
_BATTERY_PROTECTED = const(13)
_BATTERY_LOWEST_CELL_MV = const(14)
_BATTERY_HIGHEST_CELL_MV = const(15)
_BATTERY_NUMBER = const(16)
_BATTERY_COUNT = const(17)
_BATTERY_MULTIPLIER = const(18)
_BATTERY_FAILURES = const(19)
_BATTERY_IS_LOGGED = const(20)
_BATTERY_EXPIRES_MS = const(21)
_BATTERY_WARNED_MS = const(22)
_BATTERY_GONE = const(23)
_BATTERY_CELLS_MV_AGE = const(24)
_BATTERY_CELLS_MV = const(25)


class BatteryState(Component):
    """The pack that this board is part of."""

    NAME = "battery"
    SIZE = _BATTERY_SIZE
    # What is known from the start: places and values.
    START = (
        _BATTERY_COUNTED_FROM_FULL,
        0,
        _BATTERY_SWAPS_NUMBER,
        0,
        _BATTERY_MONITORED,
        1,
        _BATTERY_USED_UP,
        0,
        _BATTERY_PROTECTED,
        0,
        _BATTERY_NUMBER,
        0,
        _BATTERY_FAILURES,
        0,
        _BATTERY_IS_LOGGED,
        0,
        _BATTERY_GONE,
        0,
    )
    # Attributes, made when they are first used: names, kind and what words.py tells that kind.
    VIEWS = (
        # Voltage of the whole pack [mV]
        # V, or None while it is unknown; FR-00069.1
        " voltage_mv: voltage: number 0 0 655340 voltage 1000\n"
        # Current drawn from the pack, negative while charging [mA]
        # A, or None while it is unknown; FR-00074.9
        " current_ma: current: number 1 -327680 327670 current 1000\n"
        # Charge drawn since the pack was full [mAh]
        # mAh, or None while it is unknown; FR-00074.9
        " consumed_mah: consumed: number 2 - + consumed 1\n"
        # Energy drawn since the pack was full [hJ]
        " energy_hj: integer 3 2 -2147483648 2147483647 energy\n"
        # hJ, or None while it is unknown; FR-00074.9
        " energy: shown_integer 3 2 -2147483648 2147483647 energy 1\n"
        # Charge that is left, of a full pack. With estimate_from and curve it follows the discharge curve [%]
        # %, or None while it is unknown; FR-00074.9
        " remaining_pct: remaining: number 5 0 100 remaining 1\n"
        # Charge that is left [mAh]
        # mAh, or None while it is unknown; FR-00074.9
        " left_mah: left: number 6 0 + left 1\n"
        # How long that is enough [s]
        # s, or None while it is unknown; FR-00074.9
        " time_left_s: time_left: number 7 0 1000000 time_left 1\n"
        # Whether the charge that was drawn counts from a full pack, and not from power-on
        " counted_from_full: truth 8\n"
        # Temperature of the pack [cdegC]
        # degC, or None while it is unknown; FR-00074.9
        " temperature_cdegc: temperature: number 9 -32768 32766 temperature 100\n"
        # Whether there are no cells, while the board has its power from elsewhere
        # FR-00073.8
        " absent: below 0 3000\n"
        # How often cells were put in since the start, and so may be others; the gauge chip counts their charge
        # A number, known from the start; FR-00073.8
        " swaps_number: swaps: number 10 0 1000000 swaps 1\n"
        # Whether the pack is measured at all: whether BATT_MONITOR is not 0
        " monitored: truth 11\n"
        # Whether the pack's voltage is known
        # FR-00067.3
        " healthy: known 0\n"
        # Whether current flows into the pack
        # FR-00072.5
        " charging: below 1 0\n"
        # Whether the pack is too empty to be relied on
        # FR-00072.5
        " unhealthy: below 0 9900\n"
        # Whether the pack is locked until it has been charged. The gauge chip may know; code that asks it sets it
        " used_up: truth 12\n"
        # Whether the pack is charged above what its cells stand
        # FR-00072.5
        " over_voltage: at_least 0 12750\n"
        # Whether the pack is below what its cells stand
        # FR-00072.5
        " under_voltage: below 0 9000 None 3000\n"
        # Whether the pack is warmer than it may be while it is discharged
        # FR-00072.5
        " hot: at_least 9 6000\n"
        # Whether the pack is colder than it may be while it is discharged
        # FR-00072.5
        " cold: below 9 -2000\n"
        # Whether protective circuits in the pack are on
        " protected: truth 13\n"
        # Voltage of the cell that has the least [mV]
        # V, or None while it is unknown; FR-00072.5
        " lowest_cell_mv: lowest_cell: number 14 - + lowest_cell 1000\n"
        # Voltage of the cell that has the most [mV]
        # V, or None while it is unknown; FR-00072.5
        " highest_cell_mv: highest_cell: number 15 - + highest_cell 1000\n"
        # Whether a cell is charged above what it stands, whatever the pack's voltage is
        # FR-00072.5
        " cell_over_voltage: at_least 15 4250\n"
        # Whether a cell is below what it stands, whatever the pack's voltage is
        # FR-00072.5
        " cell_under_voltage: below 14 3000\n"
        # Whether more is drawn than the pack stands for seconds
        # FR-00072.5
        " over_current: at_least 1 132000\n"
        # What messages call it
        " number: whole 16\n"
        # Failed readings in a row
        " failures: whole 19\n"
        # When the last good reading will be too old
        " expires_ms: whole 21\n"
    )
    # Voltage of each cell [mV]
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

    def expire(self):
        """Forget the last reading once it is older than 1000 ms, FR-00067.3."""
        expire_battery(self.words, time.ticks_ms())


class SystemState:
    """Everything the telemetry reports; `words` is the whole array."""

    def __init__(self, parameters=None, log=print):
        self.parameters = parameters or Parameters()
        self.words = array("i", [UNKNOWN] * _SIZE)
        self.words_at = address(self.words)
        self._log = log
        self.battery = together(BatteryState, self.words, _BATTERY, _BATTERY_SIZE, 1, log)
        for instance in range(1):
            words = self.battery[instance].words
            words[_BATTERY_NUMBER] = self.parameters.batt_id
            words[_BATTERY_MONITORED] = 1 if self.parameters.batt_monitor != 0 else 0
            words[_BATTERY_MULTIPLIER] = self.parameters.batt_volt_mult
        self.battery_words = tuple(self.battery[instance].words for instance in range(1))
        self._start_battery()

    def _start_battery(self):
        updates = self._battery_updates()
        next(updates)
        self.update_battery = updates.send

    def _battery_updates(self):
        """Go on for ever: update_battery(board) is one turn, which takes one reading, FR-00067.1.

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
            self._log(f"battery: voltage {value:.2f} V")
        if told & 2:
            self._log("notice: Battery connected")
        if told & 4:
            self._log("warning: the battery's voltage is above 13 V:", value)
        if error is not None:
            self._log("error: the board cannot read the battery:", str(error) or type(error).__name__)

    def calibrate_battery(self, measured):
        """Set BATT_VOLT_MULT to what a meter shows, in V; return whether it was accepted.

        new = old * measured / reading, FR-00069.6; it counts from the next start.
        """
        reading = self.battery.voltage
        if not reading or measured is None:
            return False
        own = self.battery.words[_BATTERY_MULTIPLIER]
        old = self.parameters.value("BATT_VOLT_MULT", own)
        return self.parameters.set("BATT_VOLT_MULT", old * measured / reading)
