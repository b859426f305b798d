# Generated from specs/smart_battery/board.yaml, specs/smart_battery/parameters.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 3473f0c2a70bace6
"""Stores each reading in the state, by MicroPython's viper emitter; state_plain has the same in Python."""

# ptr8, ptr16 and ptr32 are viper's own names.
# ruff: noqa: F821

import micropython
from micropython import const

_UNKNOWN = const(-0x3FFFFFFF - 1)
# Where a component keeps what, see state.py.
_BATTERY = const(0)
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


@micropython.viper
def read_battery(words, every, board, ticks, first: int) -> int:
    """Take a reading of each that is measured, from the first one to ask for on, FR-00067.1.

    It ends early where there is something to tell, and returns which one that is about, times 16, and what. 1: it is
    the first reading; 2: the battery was gone and has come back; 4: the value is above where it is warned.

    What the board raises comes out; the one that it was asked for has -1000000000 for a count then.
    `words` are those of the state, `every` the parts of each, which plain Python looks at. With -1 for the first
    `words` are those of a single one, with its count.
    """
    bit = 1
    sign = bit << 31
    unknown = sign | bit << 30
    now_ms = int(ticks())
    is_alone = first < 0
    instance = first
    battery = ptr32(words)
    if not is_alone:
        battery = ptr32(int(battery) + 4 * _BATTERY)
    while instance < 1:
        if is_alone or battery[_BATTERY_MONITORED]:
            if not is_alone:
                battery[_BATTERY_COUNT] = -1000000000
                battery[_BATTERY_COUNT] = int(board.read_battery_adc())
            # battery.cells is forgotten 2000 ms after one was set (FR-00076.7).
            if battery[_BATTERY_CELLS_MV_AGE] != unknown:
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
                    value = (battery[_BATTERY_CELLS_MV + count] ^ sign) - sign
                    count += 1
                    if value == _UNKNOWN:
                        continue
                    if battery[_BATTERY_LOWEST_CELL_MV] == unknown:
                        battery[_BATTERY_LOWEST_CELL_MV] = value
                    if value < (battery[_BATTERY_LOWEST_CELL_MV] ^ sign) - sign:
                        battery[_BATTERY_LOWEST_CELL_MV] = value
                    if value > (battery[_BATTERY_HIGHEST_CELL_MV] ^ sign) - sign:
                        battery[_BATTERY_HIGHEST_CELL_MV] = value
            told = 0
            count = (battery[_BATTERY_COUNT] ^ sign) - sign
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
                    if battery[_BATTERY_SWAPS_NUMBER] == unknown:
                        battery[_BATTERY_SWAPS_NUMBER] = 0
                    battery[_BATTERY_SWAPS_NUMBER] = battery[_BATTERY_SWAPS_NUMBER] + 1
                battery[_BATTERY_GONE] = is_gone
                # Above 13000 a warning is due, unless there was one just now (FR-00069.5).
                since = battery[_BATTERY_WARNED_MS]
                if since != unknown and now_ms - since & 0x3FFFFFFF >= 10000:
                    battery[_BATTERY_WARNED_MS] = _UNKNOWN
                if value > 13000 and battery[_BATTERY_WARNED_MS] == unknown:
                    battery[_BATTERY_WARNED_MS] = now_ms & 0x3FFFFFFF
                    told |= 4

            if is_alone:
                return told
            if told:
                return told | instance << 4
        instance += 1
    return 0


@micropython.viper
def expire_battery(battery: ptr32, now_ms: int):
    """Forget a reading that has become too old, FR-00067.3."""
    bit = 1
    unknown = bit << 31 | bit << 30
    # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
    if battery[_BATTERY_EXPIRES_MS] != unknown:
        if now_ms - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
            battery[_BATTERY_EXPIRES_MS] = _UNKNOWN
