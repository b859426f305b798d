# Generated from specs/board.yaml, specs/codegen.yaml, specs/parameters.yaml, specs/state.yaml,
#   specs/vehicle.yaml, dialect common: do not edit.
# Inputs: 1819130684940705
"""Failsafes: what is done when a value stays beyond a threshold."""

from array import array
from time import ticks_diff, ticks_ms

from micropython import const

# Numbers of the dialect.
_MAV_SEVERITY_INFO = const(6)
_MAV_SEVERITY_WARNING = const(4)

try:
    from scan_viper import holding, watch
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from scan_plain import holding, watch

OK = 0  # no level
_HEALTH = (
    (_MAV_SEVERITY_INFO, "healthy"),
    (_MAV_SEVERITY_WARNING, "warning"),
    (_MAV_SEVERITY_WARNING, "unhealthy"),  # the last level
)
_NOT = const(-1)  # it does not hold, or never counts
_UNKNOWN = const(-1073741824)  # as in words

# Where the rows that are watched have what; scan_plain says more.
_UP = const(2)
_DUE = const(3)
_WORST = const(4)
_HEAD = const(9)
_ROW = const(7)
_ROW_SENSE = const(1)
_ROW_LIMIT = const(2)
_ROW_FLOOR = const(3)
_ROW_AFTER = const(4)
_ROW_LEVEL = const(6)

# Where a condition has what.
_PLACE = const(0)
_LEVEL = const(1)
_LIMIT = const(2)
_FLOOR = const(3)
_AFTER = const(4)
_MS = const(5)
_WHY = const(6)
_ACTION = const(7)
_OFF = const(0)  # of all
_ARMED = const(0)  # among the words of the vehicle
_TIMED_FROM = const(2)
_WATCHED_AT = const(0)
_SWITCH_AT = const(13)
_LEVEL_AT = const(11)
_HEALTH_AT = const(10)
_HEALTH_EVERY_MS = const(10000)

# battery.voltage: low (FR-00020.1), critical (FR-00020.2)
_BATTERY = (
    (
        (0, 0, "batt_arm_volt", _UNKNOWN, None, 0, "below minimum arming voltage", 0),
        (5, 0, "batt_arm_mah", _UNKNOWN, None, 0, "below minimum arming capacity", 0),
        (0, 1, "batt_low_volt", 0, "batt_low_timer", 1000, "low voltage failsafe", "batt_fs_low_act"),
        (5, 1, "batt_low_mah", _UNKNOWN, None, 0, "low capacity failsafe", "batt_fs_low_act"),
        (0, 2, "batt_crt_volt", 0, "batt_low_timer", 1000, "critical voltage failsafe", "batt_fs_crt_act"),
        (5, 2, "batt_crt_mah", _UNKNOWN, None, 0, "critical capacity failsafe", "batt_fs_crt_act"),
    ),
    (
        (0, 0, "batt2_arm_volt", _UNKNOWN, None, 0, "below minimum arming voltage", 0),
        (5, 0, "batt2_arm_mah", _UNKNOWN, None, 0, "below minimum arming capacity", 0),
        (0, 1, "batt2_low_volt", 0, "batt2_low_timer", 1000, "low voltage failsafe", "batt2_fs_low_act"),
        (5, 1, "batt2_low_mah", _UNKNOWN, None, 0, "low capacity failsafe", "batt2_fs_low_act"),
        (0, 2, "batt2_crt_volt", 0, "batt2_low_timer", 1000, "critical voltage failsafe", "batt2_fs_crt_act"),
        (5, 2, "batt2_crt_mah", _UNKNOWN, None, 0, "critical capacity failsafe", "batt2_fs_crt_act"),
    ),
)
_BATTERY_INVERTED = (
    (2, 4, "voltage failsafe critical >= low"),
    (3, 5, "capacity failsafe critical >= low"),
)


class Failsafe:
    """Watches one thing: how long each condition of its levels holds without a break.

    `title` is what texts call it, `level` the highest it reached: it stays until the next start and only rises.
    `is_against` arming: whether a value or a parameter was, beside the level, at the last update; True before.
    A value that is unknown, or not believed, neither restarts a time nor lets it go on.
    """

    def __init__(self, vehicle, component, title, conditions):
        self.title = title
        self.level = OK
        self.is_against = True
        self._vehicle = vehicle
        self._parameters = vehicle.parameters
        self._conditions = conditions
        self._component = component
        self._vehicle_words = vehicle.state.vehicle.words
        self._reached = None  # the condition that led to the level
        self._words = component.words
        now_ms = ticks_ms() & 0x3FFFFFFF
        head = (len(conditions), _TIMED_FROM, OK, _NOT, OK, now_ms, _WATCHED_AT, 2, _HEALTH_AT)
        self._rows = array("i", head + (0, 0, 0, 0, _NOT, _NOT, 0) * len(conditions))
        self._follow()
        self._told_ms = None  # when a change of health was logged
        self._told = OK

    def update(self, now_ms):
        """Look at the value; return the level that is reached just now, else 0. Call it after each reading."""
        if not self._words[_SWITCH_AT]:
            self.is_against = False
            return OK
        if self._changes != self._parameters.changes:
            self._follow()
        rows = self._rows
        found = watch(self._words, rows, now_ms, 1 if self._vehicle_words[_ARMED] else 0)
        self.is_against = found != 0 or self._mixed is not None
        if rows[_WORST] != self._told or self._told_ms is not None:
            self._tell_health(rows[_WORST], now_ms)
        due = None if rows[_DUE] < 0 else self._conditions[rows[_DUE]]
        if due and due[_LEVEL] > self.level:
            return self._reach(due)
        return OK

    def _follow(self):
        """Take over what parameters make of the limits and times."""
        self._changes = self._parameters.changes
        rows = self._rows
        for index in range(len(self._conditions)):
            condition = self._conditions[index]
            at = _ROW * index + _HEAD
            rows[at + _ROW_AFTER] = self._after_ms(condition)
            rows[at + _ROW_LEVEL] = condition[_LEVEL]
            rows[at] = condition[_PLACE]
            limit = self._limit(condition)
            rows[at + _ROW_SENSE] = 0 if limit is None else -1
            rows[at + _ROW_LIMIT] = limit or 0
            rows[at + _ROW_FLOOR] = condition[_FLOOR]
        self._mixed = self._mixed_up()

    def _limit(self, condition):
        """Return the limit of a condition, None for one that is switched off."""
        limit = getattr(self._parameters, condition[_LIMIT])
        if limit == _OFF:  # switched off
            return None
        return limit

    def _after_ms(self, condition):
        """Return for how long a condition has to hold, -1 for one that is switched off."""
        if condition[_AFTER] is None:
            return condition[_MS]
        return getattr(self._parameters, condition[_AFTER]) * condition[_MS] or _NOT  # 0 switches it off

    def _reach(self, condition):
        level = condition[_LEVEL]
        self.level = self._rows[_UP] = level
        self._reached = condition
        self._words[_LEVEL_AT] = level
        word = ("low", "critical")[level - 1]
        self._vehicle.texts.say(_MAV_SEVERITY_WARNING, _battery_text(self.title, self._component, word))
        return level

    def action(self):
        """Return the action of the level that was reached, 0 for none."""
        return getattr(self._parameters, self._reached[_ACTION]) if self.level else 0

    def problem(self):
        """Return why the vehicle must not be armed, as words to put behind the title, or None."""
        if not self._words[_SWITCH_AT]:
            return None
        if self._words[_WATCHED_AT] == _UNKNOWN:
            return "unhealthy"
        held = self._holding()
        if held:
            index = 0
            while not held >> index & 1:
                index += 1
            return self._conditions[index][_WHY]
        if self.level:
            return self._reached[_WHY]
        return self._mixed

    def _holding(self):
        """Return which conditions hold, a bit for each; not while the value is unknown."""
        if self._changes != self._parameters.changes:
            self._follow()
        return holding(self._words, self._rows)

    def _mixed_up(self):
        """Return the first level, in words, that is on and no worse than the one before it; None for none."""
        for pair in _BATTERY_INVERTED:
            if self._is_inverted(pair):
                return pair[2]
        return None

    def _is_inverted(self, pair):
        milder, worse = self._conditions[pair[0]], self._conditions[pair[1]]
        first = getattr(self._parameters, milder[_LIMIT])
        second = getattr(self._parameters, worse[_LIMIT])
        return 0 < first <= second

    def _tell_health(self, health, now_ms):
        """Say how the value is doing, where that has changed, and not too often."""
        if self._told_ms is not None and ticks_diff(now_ms, self._told_ms) >= _HEALTH_EVERY_MS:
            self._told_ms = None  # at once, since ticks of long ago seem to lie ahead
        if health != self._told and self._told_ms is None:
            self._told = health
            self._told_ms = now_ms
            severity, word = _HEALTH[2 if health == 2 else health and 1]
            self._vehicle.texts.say(severity, self.title + " health: " + word)


def _battery_text(title, battery, level):
    said = f"{title} is {level}"
    if battery.voltage is not None:
        said += f" {battery.voltage:.2f}V"
    if battery.consumed is not None:
        said += f" used {battery.consumed:.0f} mAh"
    return said


def battery_failsafes(vehicle):
    """Return what watches battery.voltage of each, FR-00020."""
    return [
        Failsafe(
            vehicle,
            vehicle.state.battery[instance],
            f"Battery {instance + 1}",
            _BATTERY[instance],
        )
        for instance in range(2)
    ]
