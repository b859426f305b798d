"""Reads what lines of NMEA 0183 say, in plain Python; sentences_viper does the same in machine code.

The words are those of nmea_plain. In the values longitude has the halves of a number of 32 bits, the time those of one
of 64.
"""

from micropython import const
from polling import UNKNOWN

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
_NEW = const(14)  # bits of what is new since the last turn, in the order of the outputs, and of the time
_NEW_FIX = const(1)
_NEW_SATELLITES = const(2)
_NEW_POSITION = const(12)
_NEW_ALTITUDE = const(16)
_NEW_SPEED = const(32)
_NEW_COURSE = const(64)
_NEW_HDOP = const(128)
_NEW_VDOP = const(256)
_NEW_TIME = const(512)
_IS_2D = const(4)  # by the last GSA
_FIELDS = const(6)
_MINUS = const(45)

_GGA = const(0x474741)
_RMC = const(0x524D43)
_GSA = const(0x475341)
_VTG = const(0x565447)


def read(words, values, kind):
    """Put what a line says into the values, by its type, if it is one of those that say something here."""
    if kind == _GGA:
        _read_gga(words, values)
    elif kind == _RMC:
        _read_rmc(words, values)
    elif kind == _GSA:
        _read_gsa(words, values)
    elif kind == _VTG:
        _read_vtg(words, values)


def _number(words, field, power):
    """Return a number in steps of 1 / power, to the nearest, a half away from 0; UNKNOWN where there is none."""
    field = _FIELDS + 3 * field
    whole = words[field + 1] - 1
    part = words[field + 2] - 1
    if whole < 0 or part < 0 or whole > 9999999 // power * 10:
        return UNKNOWN
    step = 10000000 // power
    whole = whole * power + (part + step // 2) // step
    return -whole if words[field] == _MINUS else whole


def _read_gga(words, values):
    """Fix, position, satellites, dilution, height."""
    quality = _number(words, 6, 1)
    fix = 1
    if quality == 2:
        fix = 4
    elif quality == 4:
        fix = 6
    elif quality == 5:
        fix = 5
    elif quality in (1, 3, 9):
        fix = 2 if words[_IS_2D] else 3
    values[_FIX] = fix
    values[_SATELLITES] = _number(words, 7, 1)
    values[_HDOP] = _number(words, 8, 100)
    values[_NEW] |= _NEW_FIX | _NEW_SATELLITES | _NEW_HDOP | _NEW_ALTITUDE
    if fix == 1:
        _lose_position(values)
        return
    _put_position(words, values, 2)
    values[_ALTITUDE] = _number(words, 9, 1000) if fix != 2 else UNKNOWN


def _read_rmc(words, values):
    """Read whether there is a fix at all, position, speed, course, time."""
    if words[_FIELDS + 6] == 65 and words[_FIELDS + 36] not in (78, 69):  # active; of modes none, estimated
        _put_position(words, values, 3)
        _put_motion(words, values, 7, 8)
        _put_time(words, values)
    else:
        values[_FIX] = 1
        values[_NEW] |= _NEW_FIX
        _lose_position(values)
        _lose_motion(values)


def _read_gsa(words, values):
    """Read whether the fix has a height, and the dilution."""
    fix = _number(words, 2, 1)
    words[_IS_2D] = 1 if fix == 2 else 0
    if fix == 1:
        values[_FIX] = 1
        values[_NEW] |= _NEW_FIX
        _lose_position(values)
    elif fix == 2:
        values[_ALTITUDE] = UNKNOWN
        values[_NEW] |= _NEW_ALTITUDE
    values[_HDOP] = _number(words, 16, 100)
    values[_VDOP] = _number(words, 17, 100)
    values[_NEW] |= _NEW_HDOP | _NEW_VDOP


def _read_vtg(words, values):
    """Speed and course."""
    if words[_FIELDS + 27] in (78, 69):
        _lose_motion(values)
    else:
        _put_motion(words, values, 5, 1)


def _lose_position(values):
    values[_LATITUDE] = values[_LONGITUDE] = values[_ALTITUDE] = UNKNOWN
    values[_NEW] |= _NEW_POSITION | _NEW_ALTITUDE


def _lose_motion(values):
    values[_SPEED] = values[_COURSE] = UNKNOWN
    values[_NEW] |= _NEW_SPEED | _NEW_COURSE


def _put_motion(words, values, knots, course):
    """Speed from knots to cm/s, and the course, of which 360 degrees are 0."""
    values[_NEW] |= _NEW_SPEED | _NEW_COURSE
    values[_SPEED] = _speed(words, _FIELDS + 3 * knots)
    course = _number(words, course, 100)
    values[_COURSE] = 0 if course == 36000 else course


def _speed(words, place):
    """Return knots as the nearest cm/s, 463 / 9 each, in numbers that stay small; UNKNOWN where there are none."""
    whole = words[place + 1] - 1
    part = words[place + 2] - 1
    if part < 0 or not 0 <= whole < 2000:
        return UNKNOWN
    part = (part // 5000 * 463 + part % 5000 * 463 // 5000) // 1000  # in eighteenths
    whole = (whole * 926 + part + 9) // 18
    return UNKNOWN if whole and words[place] == _MINUS else whole


def _put_position(words, values, field):
    """Latitude from a field on, and longitude, in 1e-7 degrees: either both are known or none is."""
    values[_LATITUDE] = values[_LONGITUDE] = UNKNOWN
    values[_NEW] |= _NEW_POSITION
    field = _FIELDS + 3 * field
    if words[field + 3] not in (78, 83) or words[field + 9] not in (69, 87):
        return
    if _minutes(words, field, 90) < 0 or _minutes(words, field + 6, 180) < 0:
        return
    angle = (words[field + 1] - 1) // 100 * 10000000 + _minutes(words, field, 90)
    values[_LATITUDE] = -angle if words[field + 3] == 83 else angle
    _put_longitude(values, (words[field + 7] - 1) // 100, _minutes(words, field + 6, 180))
    if words[field + 9] == 87:
        _turn_west(values)


def _put_longitude(values, degrees, minutes):
    """Put the halves of a number that may have more than 30 bits."""
    low = degrees * 38528 + (minutes & 0xFFFF)
    values[_LONGITUDE] = low & 0xFFFF
    values[_LONGITUDE + 1] = degrees * 152 + (minutes >> 16) + (low >> 16)  # 1e7 is 152 * 65536 + 38528


def _turn_west(values):
    low = values[_LONGITUDE]
    high = values[_LONGITUDE + 1]
    values[_LONGITUDE] = -low & 0xFFFF
    values[_LONGITUDE + 1] = (-high - 1 if low else -high) & 0xFFFF


def _minutes(words, place, most):
    """Return the minutes of an angle of so many degrees at most, in 1e-7 degrees; -1 where it is none."""
    whole = words[place + 1] - 1
    part = words[place + 2] - 1
    most *= 100
    if whole < 0 or part < 0 or whole > most or whole % 100 > 59 or (whole == most and part):
        return -1
    if words[place] == _MINUS:
        return -1
    return (whole % 100 * 10000000 + part + 30) // 60


def _put_time(words, values):
    """Time and date of RMC as microseconds since 1970, in halves; nothing where they cannot be."""
    clock = words[_FIELDS + 4] - 1
    date = words[_FIELDS + 28] - 1
    if clock < 0 or date < 0 or not words[_FIELDS + 5] or clock >= 240000:
        return
    if words[_FIELDS + 3] == _MINUS or words[_FIELDS + 27] == _MINUS:
        return
    days = _days(date // 10000, date // 100 % 100, date % 100)
    if days < 0 or clock // 100 % 100 > 59 or clock % 100 > 60:  # 60 is a leap second
        return
    days = days * 1440 + clock // 10000 * 60 + clock // 100 % 100
    values[_TIME] = days & 0xFFFF
    values[_TIME + 1] = days >> 16
    values[_TIME + 2] = values[_TIME + 3] = 0
    _times(values, 60, clock % 100)
    _times(values, 1000, (words[_FIELDS + 5] - 1) // 10000)
    _times(values, 1000, 0)
    values[_NEW] |= _NEW_TIME


def _times(values, factor, more):
    """Multiply the time, and add to it."""
    at = _TIME
    while at < _TIME + 4:
        more += values[at] * factor
        values[at] = more & 0xFFFF
        more >>= 16
        at += 1


def _days(day, month, year):
    """Return the days from 1970 to a date of 1980 to 2079, by two digits of the year; -1 where there is no such day."""
    if not 1 <= month <= 12 or day < 1:
        return -1
    # Years begin with March here: lengths of months follow from a line, and a leap day is the last one of a year.
    if year < 80:
        year += 100
    if month < 3:
        year -= 1
    month = (month + 9) % 12
    before = (month * 306 + 5) // 10
    length = ((month + 1) * 306 + 5) // 10 - before
    if month == 11:
        length = 29 if year % 4 == 3 else 28  # 2000 had one
    return year * 365 + year // 4 + before + day - 25509 if day <= length else -1
