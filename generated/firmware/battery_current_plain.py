# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 5557e20688bf36f5
"""Stores each reading in the state, in plain Python, for ports without machine code."""

import time

from micropython import const

_UNKNOWN = const(-0x3FFFFFFF - 1)
# Where a component keeps what, see state.py.
_BATTERY_VOLTAGE_MV = const(0)
_BATTERY_CURRENT_MA = const(1)
_BATTERY_CONSUMED_MAH = const(2)
_BATTERY_ENERGY_HJ = const(3)
_BATTERY_REMAINING_PCT = const(4)
_BATTERY_LEFT_MAH = const(5)
_BATTERY_TIME_LEFT_S = const(6)
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
# Places in what is counted of each input, see adc_inputs.
_FAILURES = const(0)
_LONGEST_US = const(1)
_TOTAL_US = const(2)
_READINGS = const(3)
_LONG = const(0x1FFFFFFF)  # us, above which both sides of the mean are halved: the rest stays a small number


def read_battery_current(words, every, board, ticks, first):
    """Take a reading of each that is measured, from the first one to ask for on, FR-00077.3.

    It ends early where there is something to tell, and returns which one that is about, times 16, and what. 1: it is
    the first reading; 2: the battery was gone and has come back; 4: the value is above where it is warned.

    What the board raises comes out; the one that it was asked for has -1000000000 for a count then.
    `words` are those of the state, `every` the parts of each. With -1 for the first `words` are those of a
    single one, with its count.
    """
    if first < 0:
        return _take_battery_current(words, ticks())
    while first < 2:
        told = _read_battery_current(every[first], board, ticks, first)
        if told:
            return told | first << 4
        first += 1
    return 0


def _read_battery_current(battery, board, ticks, instance):
    if not battery[_BATTERY_CURRENT_IS_READ]:
        return 0
    battery[_BATTERY_CURRENT_COUNT] = -1000000000
    battery[_BATTERY_CURRENT_COUNT] = board.read_battery_current_adc(instance)
    return _take_battery_current(battery, ticks())


def _take_battery_current(battery, now_ms):
    told = 0
    count = battery[_BATTERY_CURRENT_COUNT]
    if count < 0 or count > 4095:
        # A failed reading keeps the last value; 5 in a row make it unknown (FR-00077.4).
        battery[_BATTERY_CURRENT_FAILURES] = battery[_BATTERY_CURRENT_FAILURES] + 1
        # The current is forgotten once it is older than 1000 ms (FR-00077.4).
        if now_ms - battery[_BATTERY_CURRENT_EXPIRES_MS] - 1 & 0x3FFFFFFF < 0x1FFFFFFF:
            battery[_BATTERY_CURRENT_FAILURES] = 5
        if battery[_BATTERY_CURRENT_FAILURES] >= 5:
            battery[_BATTERY_CURRENT_MA] = _UNKNOWN
            battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
            battery[_BATTERY_LEFT_MAH] = _UNKNOWN
            battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
    else:
        # (count / 4095 * reference - offset) * multiplier, rounded to nearest (FR-00077.3).
        count = count * battery[_BATTERY_CURRENT_MULTIPLIER]
        away = battery[_BATTERY_CURRENT_OFFSET] * battery[_BATTERY_CURRENT_MULTIPLIER]
        value = (count % 27300 * 220 - away % 27300 * 273 + 13650) // 27300
        value += count // 27300 * 220 - away // 27300 * 273
        _sum_battery_current(battery, value, now_ms)
        battery[_BATTERY_CURRENT_MA] = value
        battery[_BATTERY_CURRENT_FAILURES] = 0
        battery[_BATTERY_CURRENT_EXPIRES_MS] = now_ms - 1073740824 & 0x3FFFFFFF  # in 1000 ms
        if not battery[_BATTERY_CURRENT_IS_LOGGED]:
            battery[_BATTERY_CURRENT_IS_LOGGED] = 1
            told = 1
    return told


def _sum_battery_current(battery, value, now_ms):
    # A reading stands for the time since the last; more than 1000 ms, or an unknown one, is a gap.
    took = now_ms - battery[_BATTERY_CURRENT_SINCE_MS] & 0x3FFFFFFF
    if took > 1000 or battery[_BATTERY_CURRENT_MA] == _UNKNOWN:
        took = 0
    battery[_BATTERY_CURRENT_SINCE_MS] = now_ms & 0x3FFFFFFF
    took = value * took
    # battery.consumed: 3600000 parts are a step, and what is less is kept (FR-00077.5).
    if battery[_BATTERY_CONSUMED_MAH] == _UNKNOWN:
        battery[_BATTERY_CONSUMED_MAH] = 0
        battery[_BATTERY_CONSUMED_REST] = 1800000
    part = took + battery[_BATTERY_CONSUMED_REST]
    battery[_BATTERY_CONSUMED_REST] = part % 3600000
    part = battery[_BATTERY_CONSUMED_MAH] + part // 3600000
    if part > 1073741823:
        part = 1073741823
    if part < -1073741823:
        part = -1073741823
    battery[_BATTERY_CONSUMED_MAH] = part
    # battery.energy: 100000000000 parts are a step, and what is less is kept (FR-00077.5).
    if battery[_BATTERY_VOLTAGE_MV] != _UNKNOWN:
        if battery[_BATTERY_ENERGY_HJ] == _UNKNOWN:
            battery[_BATTERY_ENERGY_HJ] = 0
            battery[_BATTERY_ENERGY_LOW] = 0
            battery[_BATTERY_ENERGY_MIDDLE] = 0
            battery[_BATTERY_ENERGY_HIGH] = 50000
        part = took % 1000 * battery[_BATTERY_VOLTAGE_MV] + battery[_BATTERY_ENERGY_LOW]
        battery[_BATTERY_ENERGY_LOW] = part % 1000
        part = part // 1000 + battery[_BATTERY_ENERGY_MIDDLE]
        part += took // 1000 % 1000 * battery[_BATTERY_VOLTAGE_MV]
        battery[_BATTERY_ENERGY_MIDDLE] = part % 1000
        part = part // 1000 + battery[_BATTERY_ENERGY_HIGH]
        part += took // 1000000 * battery[_BATTERY_VOLTAGE_MV]
        battery[_BATTERY_ENERGY_HIGH] = part % 100000
        part = battery[_BATTERY_ENERGY_HJ] + part // 100000
        if part > 1073741823:
            part = 1073741823
        if part < -1073741823:
            part = -1073741823
        battery[_BATTERY_ENERGY_HJ] = part
    # battery.remaining: what consumed leaves of BATT_CAPACITY (FR-00068.5).
    part = battery[_BATTERY_BATT_CAPACITY] - battery[_BATTERY_CONSUMED_MAH]
    if part < 0:
        part = 0
    if part > battery[_BATTERY_BATT_CAPACITY]:
        part = battery[_BATTERY_BATT_CAPACITY]
    if not battery[_BATTERY_BATT_CAPACITY]:
        battery[_BATTERY_REMAINING_PCT] = _UNKNOWN
    else:
        part = (part * 100 + battery[_BATTERY_BATT_CAPACITY] // 2) // battery[_BATTERY_BATT_CAPACITY]
        battery[_BATTERY_REMAINING_PCT] = part
    # battery.left: what consumed leaves of BATT_CAPACITY (FR-00077.6).
    part = battery[_BATTERY_BATT_CAPACITY] - battery[_BATTERY_CONSUMED_MAH]
    if part < 0:
        part = 0
    if part > battery[_BATTERY_BATT_CAPACITY]:
        part = battery[_BATTERY_BATT_CAPACITY]
    if not battery[_BATTERY_BATT_CAPACITY]:
        battery[_BATTERY_LEFT_MAH] = _UNKNOWN
    else:
        battery[_BATTERY_LEFT_MAH] = part
    # battery.time_left: left at the mean of current; unknown while nothing is drawn (FR-00077.7).
    part = battery[_BATTERY_TIME_LEFT_MEAN]
    if battery[_BATTERY_CURRENT_MA] == _UNKNOWN:
        part = value * 300
    part += value - (part + 150) // 300
    battery[_BATTERY_TIME_LEFT_MEAN] = part
    part = (part + 150) // 300
    if part <= 0 or battery[_BATTERY_LEFT_MAH] == _UNKNOWN:
        battery[_BATTERY_TIME_LEFT_S] = _UNKNOWN
    else:
        battery[_BATTERY_TIME_LEFT_S] = battery[_BATTERY_LEFT_MAH] * 900 // part
        if battery[_BATTERY_TIME_LEFT_S] > 250000:
            battery[_BATTERY_TIME_LEFT_S] = 250000
        part = battery[_BATTERY_TIME_LEFT_S] * 4 + battery[_BATTERY_LEFT_MAH] * 900 % part * 4 // part
        if part > 1000000:
            part = 1000000
        battery[_BATTERY_TIME_LEFT_S] = part


def battery_current_reading(read_u16, counts, fail):
    """Return what takes a reading by `read_u16`: the mean of 5 samples as a count, FR-00077.1; -1 of a late one."""
    ticks_us = time.ticks_us

    def reading():
        us = ticks_us()
        total = read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        total += read_u16() >> 4
        us = ticks_us() - us & 0x3FFFFFFF  # one variable: with more of them all would lie on the heap
        if us > counts[_LONGEST_US]:
            counts[_LONGEST_US] = us
        counts[_TOTAL_US] += us
        counts[_READINGS] += 1
        if counts[_TOTAL_US] > _LONG:
            counts[_TOTAL_US] >>= 1
            counts[_READINGS] >>= 1
        if us > 2000:
            return fail(us)
        counts[_FAILURES] = 0
        return (total + 2) // 5

    return reading
