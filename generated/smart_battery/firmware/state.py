# Generated from specs/smart_battery/board.yaml, specs/smart_battery/parameters.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 7419676caa2ab49c
"""State of the vehicle: integers in the units that go out, None while a quantity is unknown.

Properties show them in the units of people; to set a property to None or NaN makes the quantity unknown.
"""

import time

from conversion import product, to_steps
from guard import Guard
from parameters import Parameters


class BatteryState:
    """The pack that this board is part of."""

    def __init__(self):
        # Voltage of the whole pack [mV]
        self.voltage_mv = None
        # Current drawn from the pack, negative while charging [cA]
        self.current_ca = None
        # Charge drawn since the pack was full [mAh]
        self.consumed_mah = None
        # Energy drawn since the pack was full [hJ]
        self.energy_hj = None
        # Charge that is left, of a full pack. With estimate_from, voltage, it follows the discharge curve [%]
        self.remaining_pct = None
        # Charge that is left [mAh]
        self.left_mah = None
        # Whether the charge that was drawn counts from a full pack, and not from power-on
        self.counted_from_full = False
        # Voltage of each cell [mV]
        self.cells_mv = [None] * 3
        # Temperature of the pack [cdegC]
        self.temperature_cdegc = None
        # How often cells were put in since the start, and so may be others; the gauge chip counts their charge
        self.swaps_number = 0
        # Whether the pack is locked until it has been charged. The gauge chip may know; code that asks it sets it
        self.used_up = False
        # Whether protective circuits in the pack are on
        self.protected = False
        self.number = 0  # what messages call it, fixed at the start
        self.failures = 0  # failed readings in a row
        self.expires_ms = None  # when the last good one will be too old
        self.warned_ms = None  # when it was last warned about
        self.gone = False  # whether it was absent at the last good reading
        # Whether the pack is measured at all: whether BATT_MONITOR is not 0
        self.monitored = True

    @property
    def voltage(self):
        """V, or None while it is unknown; FR-00069.1."""
        if self.voltage_mv is None:
            return None
        return self.voltage_mv / 1000

    @voltage.setter
    def voltage(self, value):
        self.voltage_mv = to_steps(value, 1000)

    @property
    def current(self):
        """A, or None while it is unknown; FR-00074.9."""
        if self.current_ca is None:
            return None
        return self.current_ca / 100

    @current.setter
    def current(self, value):
        self.current_ca = to_steps(value, 100)

    @property
    def consumed(self):
        """mAh, or None while it is unknown; FR-00074.9."""
        return self.consumed_mah

    @consumed.setter
    def consumed(self, value):
        self.consumed_mah = to_steps(value, 1)

    @property
    def energy(self):
        """hJ, or None while it is unknown; FR-00074.9."""
        return self.energy_hj

    @energy.setter
    def energy(self, value):
        self.energy_hj = to_steps(value, 1)

    @property
    def remaining(self):
        """%, or None while it is unknown; FR-00074.9."""
        return self.remaining_pct

    @remaining.setter
    def remaining(self, value):
        self.remaining_pct = to_steps(value, 1)

    @property
    def left(self):
        """mAh, or None while it is unknown; FR-00074.9."""
        return self.left_mah

    @left.setter
    def left(self, value):
        self.left_mah = to_steps(value, 1)

    @property
    def cells(self):
        """List of values in V, None where one is unknown; FR-00076.7."""
        return [None if value is None else value / 1000 for value in self.cells_mv]

    @cells.setter
    def cells(self, values):
        """Take a list of as many values, or None: all are unknown."""
        steps = self.cells_mv
        if values is not None and len(values) != len(steps):
            raise ValueError(f"there are {len(steps)} values, not {len(values)}")
        for index in range(len(steps)):
            steps[index] = None if values is None else to_steps(values[index], 1000)

    @property
    def temperature(self):
        """degC, or None while it is unknown; FR-00074.9."""
        if self.temperature_cdegc is None:
            return None
        return self.temperature_cdegc / 100

    @temperature.setter
    def temperature(self, value):
        self.temperature_cdegc = to_steps(value, 100)

    @property
    def absent(self):
        """Whether there are no cells, while the board has its power from elsewhere, FR-00073.8."""
        return self.voltage_mv is not None and self.voltage_mv < 3000

    @property
    def swaps(self):
        """A number, known from the start; FR-00073.8."""
        return self.swaps_number

    @swaps.setter
    def swaps(self, value):
        self.swaps_number = to_steps(value, 1)

    @property
    def healthy(self):
        """Whether the pack's voltage is known, FR-00067.3."""
        return self.voltage_mv is not None

    @property
    def charging(self):
        """Whether current flows into the pack, FR-00072.5."""
        return self.current_ca is not None and self.current_ca < 0

    @property
    def unhealthy(self):
        """Whether the pack is too empty to be relied on, FR-00072.5."""
        return self.voltage_mv is not None and self.voltage_mv < 9900

    @property
    def over_voltage(self):
        """Whether the pack is charged above what its cells stand, FR-00072.5."""
        return self.voltage_mv is not None and self.voltage_mv >= 12750

    @property
    def under_voltage(self):
        """Whether the pack is below what its cells stand, FR-00072.5."""
        return self.voltage_mv is not None and self.voltage_mv < 9000

    @property
    def hot(self):
        """Whether the pack is warmer than it may be while it is discharged, FR-00072.5."""
        return self.temperature_cdegc is not None and self.temperature_cdegc >= 6000

    @property
    def cold(self):
        """Whether the pack is colder than it may be while it is discharged, FR-00072.5."""
        return self.temperature_cdegc is not None and self.temperature_cdegc < -2000

    @staticmethod
    def voltage_from_adc(adc, mult):
        """Return the volts that a count and a multiplier stand for, FR-00069.1."""
        return adc / 4095 * 3.3 * mult

    def set_count(self, count, multiplier):
        """Take over a count; the multiplier is in steps of BATT_VOLT_MULT.

        The same formula as voltage_from_adc() in whole numbers: nothing is lost and nothing allocated.
        """
        self.voltage_mv = product(count, multiplier, 11, 136500)

    def has_returned(self):
        """Take in what a reading has shown; return whether it was absent before and is no longer, FR-00073.8.

        Another one may have been put in: that is counted, and what was counted for the last one begins anew.
        """
        was_gone = self.gone
        self.gone = self.absent
        if self.gone or not was_gone:
            return False
        self.swaps_number = (self.swaps_number or 0) + 1
        return True

    def forget(self):
        """Make everything that is measured unknown."""
        self.voltage_mv = None

    def expire(self):
        """Forget the last reading once it is older than 1000 ms, FR-00067.3."""
        if self.expires_ms is not None and time.ticks_diff(time.ticks_ms(), self.expires_ms) > 0:
            self.forget()
            self.expires_ms = None


class SystemState:
    """Everything the telemetry reports."""

    def __init__(self, parameters=None, log=print):
        self.parameters = parameters or Parameters()
        self._log = log
        self._guard = Guard()
        self.battery = BatteryState()
        self.battery.number = self.parameters.batt_id
        self.battery.monitored = self.parameters.batt_monitor != 0
        # A multiplier that is changed counts from the next start.
        self._batt_volt_mult = self.parameters.batt_volt_mult
        self._battery_is_logged = False

    def update_battery(self, board):
        """Take one reading; call it every 100 ms, FR-00067.1.

        It never raises. A failed reading keeps the last value; 5 in a row make it unknown.
        """
        battery = self.battery
        if not battery.monitored:
            return
        count = self._read_battery(board)
        if not self._is_good_battery(board, count):
            battery.failures += 1
            if battery.failures >= 5:
                battery.forget()
            return
        battery.failures = 0
        battery.set_count(count, self._batt_volt_mult)
        battery.expires_ms = time.ticks_add(time.ticks_ms(), 1000)
        if not self._battery_is_logged:
            self._battery_is_logged = True
            self._log(f"battery: voltage {battery.voltage:.2f} V")
        if battery.has_returned():
            self._log("notice: Battery connected")
        self._warn_battery(battery, time.ticks_ms())

    def _warn_battery(self, battery, now_ms):
        if battery.warned_ms is not None and time.ticks_diff(now_ms, battery.warned_ms) >= 10000:
            battery.warned_ms = None  # at once, since ticks of long ago seem to lie ahead
        if battery.voltage_mv > 13000 and battery.warned_ms is None:
            battery.warned_ms = now_ms
            self._log("warning: the battery's voltage is above 13 V:", battery.voltage)

    def _read_battery(self, board):
        with self._guard:
            return board.read_battery_adc()

    def _is_good_battery(self, board, count):
        if self._guard.error is not None:
            if self.battery.failures == 0:
                self._log("error: the board cannot read the battery:", self._guard.error)
            return False
        return not board.battery_failures and isinstance(count, int) and 0 <= count <= 4095

    def calibrate_battery(self, measured):
        """Set BATT_VOLT_MULT to what a meter shows, in V; return whether it was accepted.

        new = old * measured / reading, FR-00069.6; it counts from the next start.
        """
        reading = self.battery.voltage
        if not reading or measured is None:
            return False
        old = self.parameters.value("BATT_VOLT_MULT", self._batt_volt_mult)
        return self.parameters.set("BATT_VOLT_MULT", old * measured / reading)
