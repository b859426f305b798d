# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 22bc6f042f62670f
"""State of the vehicle: integers in the units that go out, None while a quantity is unknown.

Properties show them in the units of people; to set a property to None or NaN makes the quantity unknown.
"""

import time

from conversion import product, to_steps
from guard import Guard
from parameters import Parameters
from trend import Trend

# Names of the parameters that each has of its own.
_BATT_MONITOR = ("batt_monitor", "batt2_monitor")
_BATT_VOLT_MULT = ("batt_volt_mult", "batt2_volt_mult")


class BatteryState:
    """One battery of the rover."""

    def __init__(self):
        # Voltage of the whole pack [mV]
        self.voltage_mv = None
        # Current drawn from the pack, negative while charging. The rover has no sensor for it [cA]
        self.current_ca = None
        # Charge drawn since the pack was full, or put in [mAh]
        self.consumed_mah = None
        # Energy drawn since the pack was full, or put in [hJ]
        self.energy_hj = None
        # Charge that is left, of a full pack. With estimate_from, voltage, it follows the discharge curve [%]
        self.remaining_pct = None
        # Charge that is left. Nothing on the rover counts it; code that does sets it [mAh]
        self.left_mah = None
        # Whether the charge that was drawn counts from a full pack, and not from power-on
        self.counted_from_full = False
        # Voltage of each cell. Unknown until code sets it [mV]
        self.cells_mv = [None] * 3
        # Temperature of the pack. The rover has no sensor for it [cdegC]
        self.temperature_cdegc = None
        # Change of the pack's voltage per second, positive while it rises [mV/s]
        self.trend_mv_s = None
        # 0 healthy, 1 warning (below BATT_LOW_VOLT), 2 unhealthy (below BATT_CRT_VOLT, or unknown)
        self.health_number = 2
        # The level that the failsafe has reached, 0 none, 1 low, 2 critical
        self.failsafe_number = 0
        # How often a pack was put in since the start, and so may be another one
        self.swaps_number = 0
        # Whether protective circuits in the pack are on. The rover cannot tell; code that can sets it
        self.protected = False
        self.failures = 0  # failed readings in a row
        self.expires_ms = None  # when the last good one will be too old
        self.warned_ms = None  # when it was last warned about
        self.gone = False  # whether it was absent at the last good reading
        self._readings = Trend(20, 1, 40)
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
        """A, or None while it is unknown; FR-00068.4."""
        if self.current_ca is None:
            return None
        return self.current_ca / 100

    @current.setter
    def current(self, value):
        self.current_ca = to_steps(value, 100)

    @property
    def consumed(self):
        """mAh, or None while it is unknown; FR-00068.6."""
        return self.consumed_mah

    @consumed.setter
    def consumed(self, value):
        self.consumed_mah = to_steps(value, 1)

    @property
    def energy(self):
        """hJ, or None while it is unknown; FR-00068.6."""
        return self.energy_hj

    @energy.setter
    def energy(self, value):
        self.energy_hj = to_steps(value, 1)

    @property
    def remaining(self):
        """%, or None while it is unknown; FR-00068.5."""
        return self.remaining_pct

    @remaining.setter
    def remaining(self, value):
        self.remaining_pct = to_steps(value, 1)

    @property
    def left(self):
        """mAh, or None while it is unknown; FR-00072.4."""
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
        """degC, or None while it is unknown; FR-00068.6."""
        if self.temperature_cdegc is None:
            return None
        return self.temperature_cdegc / 100

    @temperature.setter
    def temperature(self, value):
        self.temperature_cdegc = to_steps(value, 100)

    @property
    def trend(self):
        """V/s, or None while it is unknown; FR-00021.1."""
        if self.trend_mv_s is None:
            return None
        return self.trend_mv_s / 1000

    @property
    def health(self):
        """A number, known from the start; FR-00021.3."""
        return self.health_number

    @health.setter
    def health(self, value):
        self.health_number = to_steps(value, 1)

    @property
    def failsafe(self):
        """A number, known from the start; FR-00073.5."""
        return self.failsafe_number

    @failsafe.setter
    def failsafe(self, value):
        self.failsafe_number = to_steps(value, 1)

    @property
    def absent(self):
        """Whether no pack is connected. One that works has more volts; a failed reading does not count, FR-00073.8."""
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
        """Whether the pack cannot be relied on. Its voltage is too low, or unknown, FR-00072.5."""
        return self.health_number is not None and self.health_number >= 2

    @property
    def used_up(self):
        """Whether the failsafe has found the pack low. Until the next start nothing arms the rover, FR-00072.5."""
        return self.failsafe_number is not None and self.failsafe_number >= 1

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
        self.trend_mv_s = self._readings.after(self.voltage_mv)

    def keep(self):
        """Count the last value once more: a reading has failed, and the trend takes readings at equal intervals."""
        self.trend_mv_s = self._readings.after(self.voltage_mv)

    def has_returned(self):
        """Take in what a reading has shown; return whether it was absent before and is no longer, FR-00073.8.

        Another one may have been put in: that is counted, and what was counted for the last one begins anew.
        """
        was_gone = self.gone
        self.gone = self.absent
        if self.gone or not was_gone:
            return False
        self.swaps_number = (self.swaps_number or 0) + 1
        if self.consumed_mah is not None:
            self.consumed_mah = 0
        if self.energy_hj is not None:
            self.energy_hj = 0
        self.counted_from_full = False
        return True

    def forget(self):
        """Make everything that is measured unknown."""
        self.voltage_mv = None
        self.trend_mv_s = None
        self._readings.forget()

    def expire(self):
        """Forget the last reading once it is older than 1000 ms, FR-00067.3."""
        if self.expires_ms is not None and time.ticks_diff(time.ticks_ms(), self.expires_ms) > 0:
            self.forget()
            self.expires_ms = None


class VehicleState:
    """The rover as a whole."""

    def __init__(self):
        # Whether the motors may turn
        self.armed = False
        # Whether the checks before arming pass
        self.ready = False
        # Drive mode, a number of the autopilot's own
        self.mode_number = 0
        # What the vehicle is doing (MAV_STATE)
        self.status = 3
        # Share of the main loop's time that is used [d%]
        self.load_dpct = 0

    @property
    def mode(self):
        """A number, known from the start."""
        return self.mode_number

    @mode.setter
    def mode(self, value):
        self.mode_number = to_steps(value, 1)

    @property
    def load(self):
        """%, known from the start."""
        if self.load_dpct is None:
            return None
        return self.load_dpct / 10

    @load.setter
    def load(self, value):
        self.load_dpct = to_steps(value, 10)


class SystemState:
    """Everything the telemetry reports."""

    def __init__(self, parameters=None, log=print):
        self.parameters = parameters or Parameters()
        self._log = log
        self._guard = Guard()
        self.battery = [BatteryState() for _ in range(2)]
        for instance in range(2):
            self.battery[instance].monitored = getattr(self.parameters, _BATT_MONITOR[instance]) != 0
        # A multiplier that is changed counts from the next start.
        self._batt_volt_mult = [getattr(self.parameters, _BATT_VOLT_MULT[instance]) for instance in range(2)]
        self.vehicle = VehicleState()
        self._battery_is_logged = [False] * 2

    def update_battery(self, board):
        """Take one reading of each; call it every 100 ms, FR-00067.1.

        It never raises. A failed reading keeps the last value; 5 in a row make it unknown.
        """
        for instance in range(2):
            self._update_battery(board, instance)

    def _update_battery(self, board, instance):
        battery = self.battery[instance]
        if not battery.monitored:
            return
        count = self._read_battery(board, instance)
        if not self._is_good_battery(board, count, instance):
            battery.failures += 1
            if battery.failures >= 5:
                battery.forget()
            if battery.voltage_mv is not None:
                battery.keep()
            return
        battery.failures = 0
        battery.set_count(count, self._batt_volt_mult[instance])
        battery.expires_ms = time.ticks_add(time.ticks_ms(), 1000)
        if not self._battery_is_logged[instance]:
            self._log_battery(instance)
        if battery.has_returned():
            self._log(f"notice: Battery {instance + 1} connected")
        self._warn_battery(battery, time.ticks_ms(), instance)

    def _warn_battery(self, battery, now_ms, instance):
        if battery.warned_ms is not None and time.ticks_diff(now_ms, battery.warned_ms) >= 10000:
            battery.warned_ms = None  # at once, since ticks of long ago seem to lie ahead
        if battery.voltage_mv > 13000 and battery.warned_ms is None:
            battery.warned_ms = now_ms
            self._log(f"warning: battery {instance + 1}'s voltage is above 13 V:", battery.voltage)

    def _log_battery(self, instance):
        self._battery_is_logged[instance] = True
        self._log(f"battery {instance + 1}: voltage {self.battery[instance].voltage:.2f} V")

    def _read_battery(self, board, instance):
        with self._guard:
            return board.read_battery_adc(instance)

    def _is_good_battery(self, board, count, instance):
        if self._guard.error is not None:
            if self.battery[instance].failures == 0:
                self._log(f"error: the board cannot read battery {instance + 1}:", self._guard.error)
            return False
        return not board.battery_failures[instance] and isinstance(count, int) and 0 <= count <= 4095

    def calibrate_battery(self, measured, instance=0):
        """Set its multiplier to what a meter shows, in V; return whether it was accepted.

        new = old * measured / reading, FR-00069.6; it counts from the next start.
        """
        reading = self.battery[instance].voltage
        if not reading or measured is None:
            return False
        name = ("BATT_VOLT_MULT", "BATT2_VOLT_MULT")[instance]
        old = self.parameters.value(name, self._batt_volt_mult[instance])
        return self.parameters.set(name, old * measured / reading)
