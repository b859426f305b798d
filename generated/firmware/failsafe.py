# Generated from specs/board.yaml, specs/codegen.yaml, specs/parameters.yaml, specs/state.yaml,
#   specs/vehicle.yaml, dialect common: do not edit.
# Inputs: 085475eff43ab31b
"""Failsafes: what is done when a measured value stays too low while the vehicle is armed."""

import time

from micropython import const

# Numbers of the dialect.
_MAV_SEVERITY_INFO = const(6)
_MAV_SEVERITY_WARNING = const(4)

OK, LOW, CRITICAL = 0, 1, 2
_HEALTH = (
    (_MAV_SEVERITY_INFO, "healthy"),
    (_MAV_SEVERITY_WARNING, "warning"),
    (_MAV_SEVERITY_WARNING, "unhealthy"),
)
_LONGEST_MS = const(1 << 24)  # time below a threshold is not counted further
_ABOVE = const(-1)

# Names of the parameters that each has of its own.
_BATT_LOW_VOLT = ("batt_low_volt", "batt2_low_volt")
_BATT_FS_LOW_ACT = ("batt_fs_low_act", "batt2_fs_low_act")
_BATT_CRT_VOLT = ("batt_crt_volt", "batt2_crt_volt")
_BATT_FS_CRT_ACT = ("batt_fs_crt_act", "batt2_fs_crt_act")
_BATT_LOW_TIMER = ("batt_low_timer", "batt2_low_timer")
_BATT_ARM_VOLT = ("batt_arm_volt", "batt2_arm_volt")


class BatteryFailsafe:
    """Watches the voltage of one battery, FR-00020.

    `title` is what texts call it. `level` is the highest that was reached: it stays until the next start and only
    rises. A value of 0 or less, or an unknown one, neither restarts a timer nor lets it go on.
    """

    def __init__(self, state, texts, instance=0):
        self._state = state
        self._parameters = state.parameters
        self._battery = state.battery[instance]
        self._texts = texts
        self._instance = instance
        self.title = f"Battery {instance + 1}"
        self.level = OK
        self._updated_ms = time.ticks_ms()
        self._low_ms = _ABOVE  # how long it has been below BATT_LOW_VOLT
        self._critical_ms = _ABOVE  # how long it has been below BATT_CRT_VOLT
        self._told_ms = None  # when a change of health was logged
        self._told = OK

    def update(self, now_ms):
        """Look at the latest value; return the level that is reached just now, else 0. Call it after each reading."""
        if not self._battery.monitored:
            return OK
        passed_ms = time.ticks_diff(now_ms, self._updated_ms)
        self._updated_ms = now_ms
        value = self._battery.voltage_mv
        self._set_health(value, now_ms)
        if not self._state.vehicle.armed:
            self._low_ms = _ABOVE
            self._critical_ms = _ABOVE
            return OK
        if value is None or value <= 0:
            return OK
        self._low_ms = _below(self._low_ms, passed_ms, self._is_low(value))  # FR-00020.1
        self._critical_ms = _below(self._critical_ms, passed_ms, self._is_critical(value))  # FR-00020.2
        return self._escalate()

    def _is_low(self, value):
        return value < getattr(self._parameters, _BATT_LOW_VOLT[self._instance])

    def _is_critical(self, value):
        return value < getattr(self._parameters, _BATT_CRT_VOLT[self._instance])

    def _escalate(self):
        limit_ms = getattr(self._parameters, _BATT_LOW_TIMER[self._instance]) * 1000
        if limit_ms <= 0:  # BATT_LOW_TIMER 0 switches both levels off
            return OK
        if self._critical_ms >= limit_ms and self.level < CRITICAL:
            return self._reach(CRITICAL, "critical")
        if self._low_ms >= limit_ms and self.level < LOW:
            return self._reach(LOW, "low")
        return OK

    def _reach(self, level, word):
        self.level = level
        self._battery.failsafe_number = level
        self._texts.say(_MAV_SEVERITY_WARNING, self._text(word))
        return level

    def _text(self, word):
        battery = self._battery
        used = battery.consumed_mah or 0
        return f"{self.title} is {word} {battery.voltage:.2f}V used {used} mAh"

    def action(self):
        """Return the action of the level that was reached, 0 for none."""
        if self.level == CRITICAL:
            return getattr(self._parameters, _BATT_FS_CRT_ACT[self._instance])
        if self.level == LOW:
            return getattr(self._parameters, _BATT_FS_LOW_ACT[self._instance])
        return 0

    def problem(self):
        """Return why the vehicle must not be armed, as words to put behind the title, or None."""
        battery = self._battery
        if not battery.monitored:
            return None
        value = battery.voltage_mv
        if value is None:
            return "unhealthy"
        if self._is_below_minimum(value):
            return "below minimum arming voltage"
        if self._is_low(value):
            return "low voltage failsafe"
        if self._is_critical(value):
            return "critical voltage failsafe"
        if self.level != OK:
            return "low voltage failsafe" if self.level == LOW else "critical voltage failsafe"
        if self._is_inverted():
            return "voltage failsafe critical >= low"
        return None

    def _is_below_minimum(self, value):
        return value < getattr(self._parameters, _BATT_ARM_VOLT[self._instance])

    def _is_inverted(self):
        low = getattr(self._parameters, _BATT_LOW_VOLT[self._instance])
        return 0 < low <= getattr(self._parameters, _BATT_CRT_VOLT[self._instance])

    def _set_health(self, value, now_ms):
        health = self._health(value)
        self._battery.health_number = health
        if self._told_ms is not None and time.ticks_diff(now_ms, self._told_ms) >= 10000:
            self._told_ms = None  # at once, since ticks of long ago seem to lie ahead
        if health != self._told and self._told_ms is None:
            self._told = health
            self._told_ms = now_ms
            self._texts.say(_HEALTH[health][0], self.title + " health: " + _HEALTH[health][1])

    def _health(self, value):
        if value is None or self._is_critical(value):
            return CRITICAL
        return LOW if self._is_low(value) else OK


def _below(since_ms, passed_ms, is_below):
    """Return how long a value has been below, now that so much time has passed."""
    if not is_below:
        return _ABOVE
    if since_ms == _ABOVE:
        return 0
    return min(since_ms + passed_ms, _LONGEST_MS)
