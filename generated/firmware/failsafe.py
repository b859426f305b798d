# Generated from specs/board.yaml, specs/codegen.yaml, specs/parameters.yaml, specs/state.yaml,
#   specs/vehicle.yaml: do not edit.
# Inputs: 81eb060591773640
"""Failsafes: what is done when a measured value stays too low while the vehicle is armed."""

import time

import dialect

OK, LOW, CRITICAL = 0, 1, 2
_HEALTH = (
    (dialect.MAV_SEVERITY_INFO, "healthy"),
    (dialect.MAV_SEVERITY_WARNING, "warning"),
    (dialect.MAV_SEVERITY_WARNING, "unhealthy"),
)
_LONGEST_MS = 1 << 24  # time below a threshold is not counted further
_ABOVE = -1


class BatteryFailsafe:
    """Watches the battery's voltage, FR-00020.

    `level` is the highest that was reached: it stays until the next start, and only rises. A value of 0 or less, or an
    unknown one, neither restarts a timer nor lets it go on.
    """

    def __init__(self, state, texts):
        self._state = state
        self._texts = texts
        self.level = OK
        self._updated_ms = time.ticks_ms()
        self._low_ms = _ABOVE  # how long it has been below BATT_LOW_VOLT
        self._critical_ms = _ABOVE  # how long it has been below BATT_CRT_VOLT
        self._told_ms = None  # when a change of health was logged
        self._told = OK

    def update(self, now_ms):
        """Look at the latest value; return the level that is reached just now, else 0. Call it after each reading."""
        passed_ms = time.ticks_diff(now_ms, self._updated_ms)
        self._updated_ms = now_ms
        value = self._state.battery.voltage_mv
        self._set_health(value, now_ms)
        if not self._state.vehicle.armed:
            self._low_ms = _ABOVE
            self._critical_ms = _ABOVE
            return OK
        if value is None or value <= 0:
            return OK
        parameters = self._state.parameters
        self._low_ms = _below(self._low_ms, passed_ms, value < parameters.batt_low_volt)  # FR-00020.1
        self._critical_ms = _below(self._critical_ms, passed_ms, value < parameters.batt_crt_volt)  # FR-00020.2
        return self._escalate(parameters.batt_low_timer * 1000)

    def _escalate(self, limit_ms):
        if limit_ms <= 0:  # BATT_LOW_TIMER 0 switches both levels off
            return OK
        if self._critical_ms >= limit_ms and self.level < CRITICAL:
            return self._reach(CRITICAL, "critical")
        if self._low_ms >= limit_ms and self.level < LOW:
            return self._reach(LOW, "low")
        return OK

    def _reach(self, level, word):
        self.level = level
        self._texts.say(dialect.MAV_SEVERITY_WARNING, self._text(word))
        return level

    def _text(self, word):
        battery = self._state.battery
        used = battery.consumed_mah or 0
        return f"Battery 1 is {word} {battery.voltage:.2f}V used {used} mAh"

    def action(self):
        """Return the action of the level that was reached, 0 for none."""
        if self.level == CRITICAL:
            return self._state.parameters.batt_fs_crt_act
        if self.level == LOW:
            return self._state.parameters.batt_fs_low_act
        return 0

    def problem(self):
        """Return why the vehicle must not be armed, as a text, or None."""
        value = self._state.battery.voltage_mv
        if value is None:
            return "Battery 1 unhealthy"
        parameters = self._state.parameters
        if value < parameters.batt_arm_volt:
            return "Battery 1 below minimum arming voltage"
        if value < parameters.batt_low_volt:
            return "Battery 1 low voltage failsafe"
        if value < parameters.batt_crt_volt:
            return "Battery 1 critical voltage failsafe"
        if self.level != OK:
            return "Battery 1 low voltage failsafe" if self.level == LOW else "Battery 1 critical voltage failsafe"
        if 0 < parameters.batt_low_volt <= parameters.batt_crt_volt:
            return "Battery 1 voltage failsafe critical >= low"
        return None

    def _set_health(self, value, now_ms):
        health = self._health(value)
        self._state.battery.health_number = health
        if self._told_ms is not None and time.ticks_diff(now_ms, self._told_ms) >= 10000:
            self._told_ms = None  # at once, since ticks of long ago seem to lie ahead
        if health != self._told and self._told_ms is None:
            self._told = health
            self._told_ms = now_ms
            self._texts.say(_HEALTH[health][0], "Battery 1 health: " + _HEALTH[health][1])

    def _health(self, value):
        parameters = self._state.parameters
        if value is None or value < parameters.batt_crt_volt:
            return CRITICAL
        return LOW if value < parameters.batt_low_volt else OK


def _below(since_ms, passed_ms, is_below):
    """Return how long a value has been below, now that so much time has passed."""
    if not is_below:
        return _ABOVE
    if since_ms == _ABOVE:
        return 0
    return min(since_ms + passed_ms, _LONGEST_MS)
