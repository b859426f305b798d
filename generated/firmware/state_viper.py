# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 5557e20688bf36f5
"""Stores each reading in the state, by MicroPython's viper emitter; state_plain has the same in Python."""

# ptr8, ptr16 and ptr32 are viper's own names.
# ruff: noqa: F821

import micropython
from micropython import const

_UNKNOWN = const(-0x3FFFFFFF - 1)
# Where a component keeps what, see state.py.
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
_BATTERY_SWAPS_NUMBER = const(12)
_BATTERY_MONITORED = const(13)
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
_BATTERY_CURRENT_IS_READ = const(31)
_BATTERY_CURRENT_EXPIRES_MS = const(32)
_BATTERY_CONSUMED_REST = const(34)
_BATTERY_ENERGY_LOW = const(35)
_BATTERY_ENERGY_MIDDLE = const(36)
_BATTERY_ENERGY_HIGH = const(37)
_BATTERY_TREND_COUNT = const(40)
_BATTERY_TREND_NEWER = const(41)
_BATTERY_TREND_OLDER = const(42)
_BATTERY_TREND_READINGS = const(43)
_BATTERY_CELLS_MV_AGE = const(83)
_BATTERY_CELLS_MV = const(84)


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
        battery = ptr32(int(battery) + 4 * (_BATTERY + _BATTERY_SIZE * first))
    while instance < 2:
        if is_alone or battery[_BATTERY_MONITORED]:
            if not is_alone and not battery[_BATTERY_IS_SET]:
                battery[_BATTERY_COUNT] = -1000000000
                battery[_BATTERY_COUNT] = int(board.read_battery_adc(instance))
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
            # What else code sets is forgotten 5000 ms after the last of it (FR-00073.11).
            if battery[_BATTERY_SET_AGE] != unknown:
                battery[_BATTERY_SET_AGE] = battery[_BATTERY_SET_AGE] + 1
                if battery[_BATTERY_SET_AGE] > 50:
                    battery[_BATTERY_SET_AGE] = _UNKNOWN
                    battery[_BATTERY_TEMPERATURE_CDEGC] = _UNKNOWN
                    if (battery[_BATTERY_CURRENT_IS_READ] ^ sign) - sign != 1:
                        battery[_BATTERY_CURRENT_MA] = _UNKNOWN
                        battery[_BATTERY_CONSUMED_MAH] = _UNKNOWN
                        battery[_BATTERY_ENERGY_HJ] = _UNKNOWN
                        battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
                        battery[_BATTERY_LEFT_MAH] = _UNKNOWN
                        battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
            told = 0
            count = (battery[_BATTERY_COUNT] ^ sign) - sign
            if count < 0 or count > 4095:
                if battery[_BATTERY_IS_SET]:
                    # Code sets it; that is forgotten 5000 ms later (FR-00073.10).
                    battery[_BATTERY_FAILURES] = battery[_BATTERY_FAILURES] + 1
                    if battery[_BATTERY_FAILURES] > 50:
                        battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
                        battery[_BATTERY_CURRENT_MA] = _UNKNOWN
                        battery[_BATTERY_CONSUMED_MAH] = _UNKNOWN
                        battery[_BATTERY_ENERGY_HJ] = _UNKNOWN
                        battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
                        battery[_BATTERY_LEFT_MAH] = _UNKNOWN
                        battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
                        count = 0
                        while count < 3:
                            battery[_BATTERY_CELLS_MV + count] = _UNKNOWN
                            count += 1
                        battery[_BATTERY_LOWEST_CELL_MV] = _UNKNOWN
                        battery[_BATTERY_HIGHEST_CELL_MV] = _UNKNOWN
                        battery[_BATTERY_TEMPERATURE_CDEGC] = _UNKNOWN
                    if battery[_BATTERY_VOLTAGE_MV] == unknown:
                        battery[_BATTERY_TREND_MV_S] = _UNKNOWN
                        battery[_BATTERY_TREND_COUNT] = 0
                        battery[_BATTERY_TREND_NEWER] = 0
                        battery[_BATTERY_TREND_OLDER] = 0
                    value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
                else:
                    # A failed reading keeps the last value; 5 in a row make it unknown (FR-00067.3).
                    battery[_BATTERY_FAILURES] = battery[_BATTERY_FAILURES] + 1
                    value = _UNKNOWN
            else:
                # count / 4095 * reference * multiplier, rounded to nearest (FR-00069.1).
                value = count * battery[_BATTERY_MULTIPLIER]
                value = value // 136500 * 11 + (value % 136500 * 11 + 68250) // 136500
                battery[_BATTERY_VOLTAGE_MV] = value
                battery[_BATTERY_FAILURES] = 0
                battery[_BATTERY_EXPIRES_MS] = now_ms - 1073740824 & 0x3FFFFFFF  # in 1000 ms
            if value != _UNKNOWN:
                if not battery[_BATTERY_IS_LOGGED]:
                    battery[_BATTERY_IS_LOGGED] = 1
                    told = 1
                # Whether it is absent; another one may have been put in (FR-00073.8).
                is_gone = battery[_BATTERY_GONE]
                if value < 3000 and value != _UNKNOWN:
                    is_gone = 1
                if value >= 6000:
                    is_gone = 0
                if battery[_BATTERY_GONE] or is_gone:
                    battery[_BATTERY_CURRENT_MA] = _UNKNOWN
                    battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
                    battery[_BATTERY_LEFT_MAH] = _UNKNOWN
                    battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
                    count = 0
                    while count < 3:
                        battery[_BATTERY_CELLS_MV + count] = _UNKNOWN
                        count += 1
                    battery[_BATTERY_LOWEST_CELL_MV] = _UNKNOWN
                    battery[_BATTERY_HIGHEST_CELL_MV] = _UNKNOWN
                    battery[_BATTERY_TEMPERATURE_CDEGC] = _UNKNOWN
                if battery[_BATTERY_GONE] and not is_gone:
                    told |= 2
                    if battery[_BATTERY_SWAPS_NUMBER] == unknown:
                        battery[_BATTERY_SWAPS_NUMBER] = 0
                    battery[_BATTERY_SWAPS_NUMBER] = battery[_BATTERY_SWAPS_NUMBER] + 1
                    if battery[_BATTERY_CONSUMED_MAH] != unknown:
                        battery[_BATTERY_CONSUMED_MAH] = 0
                        battery[_BATTERY_CONSUMED_REST] = 1800000
                    if battery[_BATTERY_ENERGY_HJ] != unknown:
                        battery[_BATTERY_ENERGY_HJ] = 0
                        battery[_BATTERY_ENERGY_LOW] = 0
                        battery[_BATTERY_ENERGY_MIDDLE] = 0
                        battery[_BATTERY_ENERGY_HIGH] = 50000
                    battery[_BATTERY_COUNTED_FROM_FULL] = 0
                battery[_BATTERY_GONE] = is_gone
            # The sum of battery.cells comes first while all of them are known (FR-00067.3).
            value = 0
            count = 0
            while count < 3 and battery[_BATTERY_CELLS_MV + count] != unknown:
                value += (battery[_BATTERY_CELLS_MV + count] ^ sign) - sign
                count += 1
            if count == 3:
                battery[_BATTERY_VOLTAGE_MV] = value
                battery[_BATTERY_EXPIRES_MS] = now_ms - 1073740824 & 0x3FFFFFFF
            elif battery[_BATTERY_FAILURES] and not battery[_BATTERY_IS_SET]:
                # A reading is forgotten once it is older than 1000 ms (FR-00067.3).
                if now_ms - battery[_BATTERY_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
                    battery[_BATTERY_FAILURES] = 5
                if battery[_BATTERY_FAILURES] >= 5:
                    battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN
                    battery[_BATTERY_TREND_MV_S] = _UNKNOWN
                    battery[_BATTERY_TREND_COUNT] = 0
                    battery[_BATTERY_TREND_NEWER] = 0
                    battery[_BATTERY_TREND_OLDER] = 0
            value = (battery[_BATTERY_VOLTAGE_MV] ^ sign) - sign
            if value != _UNKNOWN:
                # Above 13000 a warning is due, unless there was one just now (FR-00069.5).
                since = battery[_BATTERY_WARNED_MS]
                if since != unknown and now_ms - since & 0x3FFFFFFF >= 10000:
                    battery[_BATTERY_WARNED_MS] = _UNKNOWN
                if value > 13000 and battery[_BATTERY_WARNED_MS] == unknown:
                    battery[_BATTERY_WARNED_MS] = now_ms & 0x3FFFFFFF
                    told |= 4

            if battery[_BATTERY_VOLTAGE_MV] != unknown:
                # The change per second: the sum of the newer 20 readings against that of the older ones (FR-00021.1).
                value = battery[_BATTERY_VOLTAGE_MV]
                count = battery[_BATTERY_TREND_COUNT]
                at = count
                if at >= 40:
                    at -= 40
                    oldest = battery[_BATTERY_TREND_READINGS + at]
                    battery[_BATTERY_TREND_OLDER] = battery[_BATTERY_TREND_OLDER] - oldest
                if count >= 20:
                    middle = at + 20
                    if middle >= 40:
                        middle -= 40
                    middle = battery[_BATTERY_TREND_READINGS + middle]
                    battery[_BATTERY_TREND_NEWER] = battery[_BATTERY_TREND_NEWER] - middle
                    battery[_BATTERY_TREND_OLDER] = battery[_BATTERY_TREND_OLDER] + middle
                battery[_BATTERY_TREND_NEWER] = battery[_BATTERY_TREND_NEWER] + value
                battery[_BATTERY_TREND_READINGS + at] = value
                count += 1
                if count == 80:
                    count = 40
                battery[_BATTERY_TREND_COUNT] = count
                if count < 40:
                    battery[_BATTERY_TREND_MV_S] = _UNKNOWN
                else:
                    value = (battery[_BATTERY_TREND_NEWER] ^ sign) - sign
                    value -= (battery[_BATTERY_TREND_OLDER] ^ sign) - sign
                    if value < 0:
                        battery[_BATTERY_TREND_MV_S] = 0 - (20 - value) // 40
                    else:
                        battery[_BATTERY_TREND_MV_S] = (value + 20) // 40

            if is_alone:
                return told
            if told:
                return told | instance << 4
        instance += 1
        battery = ptr32(int(battery) + 4 * _BATTERY_SIZE)
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
            battery[_BATTERY_TREND_MV_S] = _UNKNOWN
            battery[_BATTERY_TREND_COUNT] = 0
            battery[_BATTERY_TREND_NEWER] = 0
            battery[_BATTERY_TREND_OLDER] = 0
            battery[_BATTERY_EXPIRES_MS] = _UNKNOWN
    # The current is forgotten once it is older than 1000 ms (FR-00077.4).
    if battery[_BATTERY_CURRENT_EXPIRES_MS] != unknown:
        if now_ms - battery[_BATTERY_CURRENT_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_CURRENT_MA] = _UNKNOWN
            battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
            battery[_BATTERY_LEFT_MAH] = _UNKNOWN
            battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
            battery[_BATTERY_CURRENT_EXPIRES_MS] = _UNKNOWN
