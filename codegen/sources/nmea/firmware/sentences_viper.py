"""Reads what lines of NMEA 0183 say, in machine code; sentences_plain has the same in Python."""

# ptr32 is viper's own name; calls are dear, so few functions do it all; `in` would make a set.
# ruff: noqa: F821, C901, PLR0912, PLR1714

import micropython
from micropython import const

_FIX = const(0)
_SATELLITES = const(1)
_LATITUDE = const(2)
_LONGITUDE = const(3)
_ALTITUDE = const(5)
_SPEED = const(6)
_COURSE = const(7)
_HDOP = const(8)
_VDOP = const(9)
_TIME = const(10)
_NEW = const(14)
_NEW_FIX = const(1)
_NEW_SATELLITES = const(2)
_NEW_POSITION = const(12)
_NEW_ALTITUDE = const(16)
_NEW_SPEED = const(32)
_NEW_COURSE = const(64)
_NEW_HDOP = const(128)
_NEW_VDOP = const(256)
_NEW_TIME = const(512)
_IS_2D = const(4)
_FIELDS = const(6)

_GGA = const(0x474741)
_RMC = const(0x524D43)
_GSA = const(0x475341)
_VTG = const(0x565447)
_UNKNOWN = const(-0x3FFFFFFF - 1)


@micropython.viper
def read(words, values, kind: int):
    """Put what a line says into the values, by its type, if it is one of those that say something here."""
    if kind == _GGA:
        _read_gga(words, values)
    elif kind == _RMC:
        _read_rmc(words, values)
    elif kind == _GSA:
        _read_gsa(words, values)
    elif kind == _VTG:
        _read_vtg(words, values)


@micropython.viper
def _number(words, field: int, power: int) -> int:
    """Return a number in steps of 1 / power, to the nearest, a half away from 0; unknown where there is none."""
    at = ptr32(int(ptr32(words)) + (_FIELDS + 3 * field) * 4)
    whole = at[1] - 1
    part = at[2] - 1
    if whole < 0 or part < 0 or whole > 9999999 // power * 10:
        return _UNKNOWN
    step = 10000000 // power
    number = whole * power + (part + step // 2) // step
    return 0 - number if at[0] == 45 else number


@micropython.viper
def _read_gga(words, values):
    """Fix, position, satellites, dilution, height."""
    value = ptr32(values)
    quality = int(_number(words, 6, 1))
    fix = 1
    if quality == 2:
        fix = 4
    elif quality == 4:
        fix = 6
    elif quality == 5:
        fix = 5
    elif quality == 1 or quality == 3 or quality == 9:
        fix = 3
        if ptr32(words)[_IS_2D]:
            fix = 2
    value[_FIX] = fix
    value[_SATELLITES] = int(_number(words, 7, 1))
    value[_HDOP] = int(_number(words, 8, 100))
    value[_ALTITUDE] = _UNKNOWN
    value[_NEW] = value[_NEW] | _NEW_FIX | _NEW_SATELLITES | _NEW_HDOP | _NEW_ALTITUDE
    if fix == 1:
        _lose_position(values)
        return
    _put_position(words, values, 2)
    if fix != 2:
        value[_ALTITUDE] = int(_number(words, 9, 1000))


@micropython.viper
def _read_rmc(words, values):
    """Read whether there is a fix at all, position, speed, course, time."""
    word = ptr32(words)
    mode = word[_FIELDS + 36]
    if word[_FIELDS + 6] == 65 and mode != 78 and mode != 69:  # A is active; of modes N is none, E estimated
        _put_position(words, values, 3)
        _put_motion(words, values, 7, 8)
        _put_time(words, values)
    else:
        value = ptr32(values)
        value[_FIX] = 1
        value[_NEW] = value[_NEW] | _NEW_FIX
        _lose_position(values)
        _lose_motion(values)


@micropython.viper
def _read_gsa(words, values):
    """Read whether the fix has a height, and the dilution."""
    value = ptr32(values)
    fix = int(_number(words, 2, 1))
    ptr32(words)[_IS_2D] = 0
    if fix == 1:
        value[_FIX] = 1
        value[_NEW] = value[_NEW] | _NEW_FIX
        _lose_position(values)
    elif fix == 2:
        ptr32(words)[_IS_2D] = 1
        value[_ALTITUDE] = _UNKNOWN
        value[_NEW] = value[_NEW] | _NEW_ALTITUDE
    value[_HDOP] = int(_number(words, 16, 100))
    value[_VDOP] = int(_number(words, 17, 100))
    value[_NEW] = value[_NEW] | _NEW_HDOP | _NEW_VDOP


@micropython.viper
def _read_vtg(words, values):
    """Speed and course."""
    mode = ptr32(words)[_FIELDS + 27]
    if mode == 78 or mode == 69:
        _lose_motion(values)
    else:
        _put_motion(words, values, 5, 1)


@micropython.viper
def _lose_position(values):
    value = ptr32(values)
    value[_LATITUDE] = _UNKNOWN
    value[_LONGITUDE] = _UNKNOWN
    value[_ALTITUDE] = _UNKNOWN
    value[_NEW] = value[_NEW] | _NEW_POSITION | _NEW_ALTITUDE


@micropython.viper
def _lose_motion(values):
    value = ptr32(values)
    value[_SPEED] = _UNKNOWN
    value[_COURSE] = _UNKNOWN
    value[_NEW] = value[_NEW] | _NEW_SPEED | _NEW_COURSE


@micropython.viper
def _put_motion(words, values, knots: int, course: int):
    """Speed from knots to cm/s, and the course, of which 360 degrees are 0."""
    value = ptr32(values)
    value[_NEW] = value[_NEW] | _NEW_SPEED | _NEW_COURSE
    value[_SPEED] = _UNKNOWN
    at = ptr32(int(ptr32(words)) + (_FIELDS + 3 * knots) * 4)
    number = at[1] - 1
    part = at[2] - 1
    if number >= 0 and part >= 0 and number < 2000:  # a knot is 463 / 9 cm/s: in eighteenths, which stay small
        number = (number * 926 + (part // 5000 * 463 + part % 5000 * 463 // 5000) // 1000 + 9) // 18
        if number == 0 or at[0] != 45:
            value[_SPEED] = number
    number = int(_number(words, course, 100))
    value[_COURSE] = number
    if number == 36000:
        value[_COURSE] = 0


@micropython.viper
def _put_position(words, values, field: int):
    """Latitude from a field on, and longitude, in 1e-7 degrees: either both are known or none is."""
    value = ptr32(values)
    value[_LATITUDE] = _UNKNOWN
    value[_LONGITUDE] = _UNKNOWN
    value[_NEW] = value[_NEW] | _NEW_POSITION
    at = ptr32(int(ptr32(words)) + (_FIELDS + 3 * field) * 4)
    north = at[3]
    east = at[9]
    if (north != 78 and north != 83) or (east != 69 and east != 87):
        return
    minutes = int(_minutes(words, field, 90))
    more = int(_minutes(words, field + 2, 180))
    if minutes < 0 or more < 0:
        return
    angle = (at[1] - 1) // 100 * 10000000 + minutes
    if north == 83:
        angle = 0 - angle
    value[_LATITUDE] = angle
    angle = (at[7] - 1) // 100 * 10000000 + more
    if east == 87:
        angle = 0 - angle
    value[_LONGITUDE] = angle & 0xFFFF
    value[_LONGITUDE + 1] = angle >> 16 & 0xFFFF


@micropython.viper
def _minutes(words, field: int, most: int) -> int:
    """Return the minutes of an angle of so many degrees at most, in 1e-7 degrees; -1 where it is none."""
    at = ptr32(int(ptr32(words)) + (_FIELDS + 3 * field) * 4)
    whole = at[1] - 1
    part = at[2] - 1
    most *= 100
    if at[0] == 45 or whole < 0 or part < 0 or whole > most or whole % 100 > 59 or (whole == most and part):
        return -1
    return (whole % 100 * 10000000 + part + 30) // 60


@micropython.viper
def _put_time(words, values):
    """Time and date of RMC as microseconds since 1970, in halves; nothing where they cannot be."""
    word = ptr32(words)
    clock = word[_FIELDS + 4] - 1
    date = word[_FIELDS + 28] - 1
    if word[_FIELDS + 3] == 45 or clock < 0 or word[_FIELDS + 5] == 0 or clock >= 240000:
        return
    if word[_FIELDS + 27] == 45 or date < 0:
        return
    minute = clock // 100 % 100
    if minute > 59 or clock % 100 > 60:  # 60 is a leap second
        return
    day = date // 10000
    month = date // 100 % 100
    year = date % 100
    if day == 0 or month == 0 or month > 12:
        return
    # Years begin with March here: lengths of months follow from a line, and a leap day is the last one of a year.
    month = (month + 9) % 12
    before = (month * 306 + 5) // 10
    length = ((month + 1) * 306 + 5) // 10 - before
    if year < 80:
        year += 100
    if month > 9:
        year -= 1
    if month == 11:
        length = 28
        if year % 4 == 3:  # 2000 had one
            length = 29
    if day > length:
        return
    minute += (year * 365 + year // 4 + before + day - 25509) * 1440 + clock // 10000 * 60
    time = ptr32(int(ptr32(values)) + _TIME * 4)
    time[0] = minute & 0xFFFF
    time[1] = minute >> 16
    time[2] = 0
    time[3] = 0
    step = 0
    while step < 3:  # to seconds, milliseconds, microseconds
        factor = 1000
        more = 0
        if step == 0:
            factor = 60
            more = clock % 100
        elif step == 1:
            more = (word[_FIELDS + 5] - 1) // 10000
        at = 0
        while at < 4:
            more += time[at] * factor
            time[at] = more & 0xFFFF
            more >>= 16
            at += 1
        step += 1
    value = ptr32(values)
    value[_NEW] = value[_NEW] | _NEW_TIME
