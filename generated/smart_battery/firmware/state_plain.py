# Generated from specs/smart_battery/board.yaml, specs/smart_battery/parameters.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 3473f0c2a70bace6
"""Stores each reading in the state, in plain Python, for ports without machine code."""

from micropython import const

_UNKNOWN = const(-0x3FFFFFFF - 1)
# Where a component keeps what, see state.py.
_BATTERY_VOLTAGE_MV = const(0)
_BATTERY_SWAPS_NUMBER = const(10)
_BATTERY_MONITORED = const(11)
_BATTERY_LOWEST_CELL_MV = const(14)
_BATTERY_HIGHEST_CELL_MV = const(15)
_BATTERY_COUNT = const(17)
_BATTERY_MULTIPLIER = const(18)
_BATTERY_FAILURES = const(19)
_BATTERY_IS_LOGGED = const(20)
_BATTERY_EXPIRES_MS = const(21)
_BATTERY_WARNED_MS = const(22)
_BATTERY_GONE = const(23)
_BATTERY_CELLS_MV_AGE = const(24)
_BATTERY_CELLS_MV = const(25)


def read_battery(words, every, board, ticks, first):
    """Take a reading of each that is measured, from the first one to ask for on, FR-00067.1.

    It ends early where there is something to tell, and returns which one that is about, times 16, and what. 1: it is
    the first reading; 2: the battery was gone and has come back; 4: the value is above where it is warned.

    What the board raises comes out; the one that it was asked for has -1000000000 for a count then.
    `words` are those of the state, `every` the parts of each. With -1 for the first `words` are those of a
    single one, with its count.
    """
    if first < 0:
        return _take_battery(words, ticks())
    while first < 1:
        told = _read_battery(every[first], board, ticks, first)
        if told:
            return told | first << 4
        first += 1
    return 0


def _read_battery(battery, board, ticks, instance):
    if not battery[_BATTERY_MONITORED]:
        return 0
    battery[_BATTERY_COUNT] = -1000000000
    battery[_BATTERY_COUNT] = board.read_battery_adc()
    return _take_battery(battery, ticks())


def _take_battery(battery, now_ms):
    # battery.cells is forgotten 2000 ms after one was set (FR-00076.7).
    if battery[_BATTERY_CELLS_MV_AGE] != _UNKNOWN:
        battery[_BATTERY_CELLS_MV_AGE] = battery[_BATTERY_CELLS_MV_AGE] + 1
        if battery[_BATTERY_CELLS_MV_AGE] > 20:
            battery[_BATTERY_CELLS_MV_AGE] = _UNKNOWN
            count = 0
            while count < 3:
                battery[_BATTERY_CELLS_MV + count] = _UNKNOWN
                count += 1
        battery[_BATTERY_LOWEST_CELL_MV] = _UNKNOWN
        battery[_BATTERY_HIGHEST_CELL_MV] = _UNKNOWN
        count = 0
        while count < 3:
            value = battery[_BATTERY_CELLS_MV + count]
            count += 1
            if value == _UNKNOWN:
                continue
            if battery[_BATTERY_LOWEST_CELL_MV] == _UNKNOWN:
                battery[_BATTERY_LOWEST_CELL_MV] = value
            if value < battery[_BATTERY_LOWEST_CELL_MV]:
                battery[_BATTERY_LOWEST_CELL_MV] = value
            if value > battery[_BATTERY_HIGHEST_CELL_MV]:
                battery[_BATTERY_HIGHEST_CELL_MV] = value
    told = 0
    count = battery[_BATTERY_COUNT]
    if count < 0 or count > 4095:
        # A failed reading keeps the last value; 5 in a row make it unknown (FR-00067.3).
        battery[_BATTERY_FAILURES] = battery[_BATTERY_FAILURES] + 1
        # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
        if now_ms - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_FAILURES] = 5
        if battery[_BATTERY_FAILURES] >= 5:
            battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
    else:
        # count / 4095 * reference * multiplier, rounded to nearest (FR-00069.1).
        value = count * battery[_BATTERY_MULTIPLIER]
        value = value // 136500 * 11 + (value % 136500 * 11 + 68250) // 136500
        battery[_BATTERY_VOLTAGE_MV] = value
        battery[_BATTERY_FAILURES] = 0
        battery[_BATTERY_EXPIRES_MS] = now_ms - 1073740824 & 0x3FFFFFFF  # in 1000 ms
        if not battery[_BATTERY_IS_LOGGED]:
            battery[_BATTERY_IS_LOGGED] = 1
            told = 1
        # Whether it is absent; another one may have been put in (FR-00073.8).
        is_gone = battery[_BATTERY_GONE]
        if value < 3000 and value != _UNKNOWN:
            is_gone = 1
        if value >= 6000:
            is_gone = 0
        if battery[_BATTERY_GONE] and not is_gone:
            told |= 2
            if battery[_BATTERY_SWAPS_NUMBER] == _UNKNOWN:
                battery[_BATTERY_SWAPS_NUMBER] = 0
            battery[_BATTERY_SWAPS_NUMBER] = battery[_BATTERY_SWAPS_NUMBER] + 1
        battery[_BATTERY_GONE] = is_gone
        # Above 13000 a warning is due, unless there was one just now (FR-00069.5).
        since = battery[_BATTERY_WARNED_MS]
        if since != _UNKNOWN and now_ms - since & 0x3FFFFFFF >= 10000:
            battery[_BATTERY_WARNED_MS] = _UNKNOWN
        if value > 13000 and battery[_BATTERY_WARNED_MS] == _UNKNOWN:
            battery[_BATTERY_WARNED_MS] = now_ms & 0x3FFFFFFF
            told |= 4
    return told


def expire_battery(battery, now_ms):
    """Forget a reading that has become too old, FR-00067.3."""
    # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
    if battery[_BATTERY_EXPIRES_MS] != _UNKNOWN:
        if now_ms - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
            battery[_BATTERY_EXPIRES_MS] = _UNKNOWN
