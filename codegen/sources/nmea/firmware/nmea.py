"""A receiver of satellites that speaks NMEA 0183 on a UART: GGA, RMC, GSA and VTG, in whole numbers, without the heap.

Only whole lines count, with the checksum that they have; others are counted in `cut` and `wrong`. Fields are numbered
as in the standard, 0 is the one with talker and type.
"""

from array import array

from micropython import const
from polling import UNKNOWN

# Places in `values`: longitude has the halves of a number of 32 bits, the time those of one of 64.
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
_SIZE = const(15)
_NEW_FIX = const(1)
_NEW_SATELLITES = const(2)
_NEW_POSITION = const(12)
_NEW_ALTITUDE = const(16)
_NEW_SPEED = const(32)
_NEW_COURSE = const(64)
_NEW_HDOP = const(128)
_NEW_VDOP = const(256)
_NEW_TIME = const(512)

_PIECE = const(128)  # bytes that are looked at in one turn, so that it stays short
_LONGEST = const(96)  # between the dollar and the star: the standard has 79, some receivers more
_FIELDS = const(24)
_IDLE = const(-1)
_TALKERS = (0x4750, 0x474E, 0x474C, 0x4741, 0x4742, 0x4244)  # GP, GN, GL, GA, GB, BD
_GGA = const(0x474741)
_RMC = const(0x524D43)
_GSA = const(0x475341)
_VTG = const(0x565447)
_COMMA = const(44)
_MINUS = const(45)
_POINT = const(46)
_POWERS = (1, 10, 100, 1000)
_DAYS_BEFORE = (0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334)


class Nmea:
    """The receiver; `opened` is a function that opens its UART."""

    def __init__(self, opened):
        self.values = array("i", [UNKNOWN] * _SIZE)
        self.lines = 0  # taken, counted up to 2 ** 30 as the others
        self.wrong = 0
        self.cut = 0
        self.waiting = None
        self._opened = opened
        self._uart = None
        self._piece = bytearray(_PIECE)
        self._line = bytearray(_LONGEST)
        self._starts = bytearray(_FIELDS)
        self._length = _IDLE
        self._ended = 0  # characters since the star, and it
        self._sum = 0
        self._said = 0  # the checksum that the line has
        self._fields = 0
        self._is_2d = False  # by the last GSA
        self._degrees = 0  # of the angle that was read last
        self._minutes = 0
        self._is_negative = False

    def begin(self):
        """Open the UART."""
        self._uart = self._opened()
        self.waiting = self._uart.any
        self._length = _IDLE

    def poll(self, _now_ms):
        """Take what waits, as much as a turn has time for; return whether a line said something."""
        self.values[_NEW] = 0
        count = self._uart.readinto(self._piece)
        if not count:
            return False
        piece = self._piece
        at = 0
        while at < count:
            if self._length != _IDLE and not self._ended:
                at = self._fill(at, count)
            if at < count:
                self._take(piece[at])
                at += 1
        return self.values[_NEW] != 0

    def _fill(self, at, count):
        """Take the usual characters of a line, as many as there are; return where others begin."""
        piece, line, length, total = self._piece, self._line, self._length, self._sum
        while at < count and length < _LONGEST:
            byte = piece[at]
            if byte < 43 or byte > 126:  # a dollar, a star, what is no text
                break
            line[length] = byte
            total ^= byte
            length += 1
            at += 1
        self._length = length
        self._sum = total
        return at

    def _take(self, byte):
        """Take a character of a line."""
        length = self._length
        if byte == 36:  # a dollar begins a line
            if length != _IDLE:
                self.cut = self.cut + 1 & 0x3FFFFFFF
            self._length = self._ended = self._sum = self._said = 0
        elif length == _IDLE:
            return
        elif self._ended:
            self._end(byte)
        elif byte == 42:
            self._ended = 1
        elif length == _LONGEST or byte < 32 or byte > 126:
            self._length = _IDLE
            self.cut = self.cut + 1 & 0x3FFFFFFF
        else:
            self._line[length] = byte
            self._sum ^= byte
            self._length = length + 1

    def _end(self, byte):
        """Take a digit of the checksum; with the second one the line is whole."""
        digit = byte - 48 if 48 <= byte <= 57 else (byte | 32) - 87
        self._said = self._said << 4 | (digit & 15)
        self._ended += 1
        if not 0 <= digit <= 15:
            self._said = -1
        elif self._ended < 3:
            return
        if self._said == self._sum:
            self.lines = self.lines + 1 & 0x3FFFFFFF
            self._read()
        else:
            self.wrong = self.wrong + 1 & 0x3FFFFFFF
        self._length = _IDLE

    def _read(self):
        """Read a whole line, if it is one of those that say something here."""
        line = self._line
        if self._length < 6 or line[5] != _COMMA or line[0] << 8 | line[1] not in _TALKERS:
            return
        self._split()
        kind = (line[2] << 8 | line[3]) << 8 | line[4]
        if kind == _GGA:
            self._read_gga()
        elif kind == _RMC:
            self._read_rmc()
        elif kind == _GSA:
            self._read_gsa()
        elif kind == _VTG:
            self._read_vtg()

    def _split(self):
        """Find where the fields begin."""
        line = self._line
        self._fields = 1
        self._starts[0] = 0
        at = 0
        while at < self._length and self._fields < _FIELDS:
            if line[at] == _COMMA:
                self._starts[self._fields] = at + 1
                self._fields += 1
            at += 1

    def _read_gga(self):
        """Fix, position, satellites, dilution, height."""
        quality = self._number(6, 0)
        fix = 1
        if quality == 2:
            fix = 4
        elif quality == 4:
            fix = 6
        elif quality == 5:
            fix = 5
        elif quality in (1, 3, 9):
            fix = 2 if self._is_2d else 3
        self._put(_FIX, fix, _NEW_FIX)
        self._put(_SATELLITES, self._number(7, 0), _NEW_SATELLITES)
        self._put(_HDOP, self._number(8, 2), _NEW_HDOP)
        if fix == 1:
            self._lose_position()
            return
        self._put_position(2)
        self._put(_ALTITUDE, self._number(9, 3) if fix != 2 else UNKNOWN, _NEW_ALTITUDE)

    def _read_rmc(self):
        """Whether there is a fix at all, position, speed, course, time."""
        mode = self._letter(12)
        if self._letter(2) != 65 or mode in (78, 69):  # A is active; of modes N is none, E estimated
            self._lose_position()
            self._put(_FIX, 1, _NEW_FIX)
            self._put(_SPEED, UNKNOWN, _NEW_SPEED)
            self._put(_COURSE, UNKNOWN, _NEW_COURSE)
            return
        self._put_position(3)
        self._put_motion(7, 8)
        self._put_time()

    def _read_gsa(self):
        """Whether the fix has a height, and the dilution."""
        fix = self._number(2, 0)
        self._is_2d = fix == 2
        if fix == 1:
            self._put(_FIX, 1, _NEW_FIX)
            self._lose_position()
        elif fix == 2:
            self._put(_ALTITUDE, UNKNOWN, _NEW_ALTITUDE)
        self._put(_HDOP, self._number(16, 2), _NEW_HDOP)
        self._put(_VDOP, self._number(17, 2), _NEW_VDOP)

    def _read_vtg(self):
        """Speed and course."""
        mode = self._letter(9)
        if mode in (78, 69):
            self._put(_SPEED, UNKNOWN, _NEW_SPEED)
            self._put(_COURSE, UNKNOWN, _NEW_COURSE)
        else:
            self._put_motion(5, 1)

    def _put(self, place, value, new):
        self.values[place] = value
        self.values[_NEW] |= new

    def _lose_position(self):
        self.values[_LATITUDE] = UNKNOWN
        self.values[_LONGITUDE] = UNKNOWN
        self._put(_ALTITUDE, UNKNOWN, _NEW_ALTITUDE | _NEW_POSITION)

    def _put_motion(self, knots, course):
        """Speed from knots to cm/s, and the course, of which 360 degrees are 0."""
        value = self._number(knots, 3)
        if not 0 <= value < 2000000:
            value = UNKNOWN
        self._put(_SPEED, UNKNOWN if value == UNKNOWN else (value * 463 + 4500) // 9000, _NEW_SPEED)
        value = self._number(course, 2)
        self._put(_COURSE, 0 if value == 36000 else value, _NEW_COURSE)

    def _put_position(self, field):
        """Latitude from a field on, and longitude, in 1e-7 degrees: either both are known or none is."""
        values = self.values
        values[_LATITUDE] = values[_LONGITUDE] = UNKNOWN
        values[_NEW] |= _NEW_POSITION
        if not self._read_angle(field + 2, 180, 69, 87):
            return
        self._put_longitude()
        if self._read_angle(field, 90, 78, 83):
            latitude = self._degrees * 10000000 + self._minutes
            values[_LATITUDE] = -latitude if self._is_negative else latitude
        else:
            values[_LONGITUDE] = UNKNOWN

    def _put_longitude(self):
        low = self._degrees * 38528 + (self._minutes & 0xFFFF)
        high = self._degrees * 152 + (self._minutes >> 16) + (low >> 16)  # 1e7 is 152 * 65536 + 38528
        low &= 0xFFFF
        if self._is_negative:
            high = -high - 1 if low else -high
            low = -low & 0xFFFF
        self.values[_LONGITUDE] = low
        self.values[_LONGITUDE + 1] = high & 0xFFFF

    def _read_angle(self, field, most, positive, negative):
        """Read degrees and minutes, which become steps of 1e-7 degrees; return whether they can be."""
        value = self._whole(field)
        part = self._part(field, 7)
        if (
            value == UNKNOWN
            or part == UNKNOWN
            or value > most * 100
            or value % 100 > 59
            or (value == most * 100 and part)
        ):
            return False
        side = self._letter(field + 1)
        self._is_negative = side == negative
        self._degrees = value // 100
        self._minutes = (value % 100 * 10000000 + part + 30) // 60
        return self._is_negative or side == positive

    def _put_time(self):
        """Time and date of RMC as microseconds since 1970, in halves; nothing where they cannot be."""
        clock = self._whole(1)
        part = self._part(1, 3)
        date = self._whole(9)
        if clock < 0 or part < 0 or date < 0 or clock >= 240000 or date > 319999:
            return
        seconds = clock % 100
        minute = clock // 100 % 100
        days = _days(date // 10000, date // 100 % 100, date % 100)
        if days < 0 or seconds > 60 or minute > 59:  # 60 is a leap second
            return
        minutes = days * 1440 + clock // 10000 * 60 + minute
        self.values[_TIME] = minutes & 0xFFFF
        self.values[_TIME + 1] = minutes >> 16
        self.values[_TIME + 2] = self.values[_TIME + 3] = 0
        self._times(60, seconds)
        self._times(1000, part)
        self._times(1000, 0)
        self.values[_NEW] |= _NEW_TIME

    def _times(self, factor, more):
        """Multiply the time, and add to it."""
        values = self.values
        at = _TIME
        while at < _TIME + 4:
            more += values[at] * factor
            values[at] = more & 0xFFFF
            more >>= 16
            at += 1

    def _letter(self, field):
        """Return the first character of a field, 0 where it is empty or not there."""
        at = self._starts[field] if field < self._fields else self._length
        byte = self._line[at] if at < self._length else 0
        return 0 if byte == _COMMA else byte

    def _number(self, field, decimals):
        """Return a number in steps of so many decimals, of which more are left out; UNKNOWN where there is none."""
        whole = self._whole(field)
        part = self._part(field, decimals)
        if whole == UNKNOWN or part == UNKNOWN or whole > 9999999 // _POWERS[decimals] * 10:
            return UNKNOWN
        value = whole * _POWERS[decimals] + part
        return -value if self._letter(field) == _MINUS else value

    def _whole(self, field):
        """Return what stands before the point, without the sign; UNKNOWN where that is no number."""
        if field >= self._fields:
            return UNKNOWN
        at = self._starts[field]
        if self._letter(field) == _MINUS:
            at += 1
        return self._digits(at, self._point(field))

    def _part(self, field, decimals):
        """Return so many digits behind the point; 0 where there is none, UNKNOWN where these are no digits."""
        if field >= self._fields:
            return UNKNOWN
        at = self._point(field) + 1
        end = self._end_of(field)
        if at >= end:
            return 0
        if end - at > decimals:
            end = at + decimals
        value = self._digits(at, end) if decimals else 0
        while value > 0 and end - at < decimals:
            value *= 10
            at -= 1
        return value

    def _digits(self, at, end):
        """Return a number without a sign; UNKNOWN where it is empty, too long, or none."""
        if not 0 < end - at < 9:
            return UNKNOWN
        value = 0
        while at < end:
            digit = self._line[at] - 48
            if not 0 <= digit <= 9:
                return UNKNOWN
            value = value * 10 + digit
            at += 1
        return value

    def _point(self, field):
        """Return where the point of a field is, or where the field ends."""
        at = self._starts[field]
        end = self._end_of(field)
        while at < end and self._line[at] != _POINT:
            at += 1
        return at

    def _end_of(self, field):
        return self._starts[field + 1] - 1 if field + 1 < self._fields else self._length


def _days(day, month, year):
    """Return the days from 1970 to a date of 1980 to 2079, by two digits of the year; -1 where there is no such day."""
    year += 2000 if year < 80 else 1900
    if not 1 <= month <= 12 or day < 1:
        return -1
    is_leap = year % 4 == 0  # 2000 was one
    length = 31 if month in (1, 3, 5, 7, 8, 10, 12) else 28 + is_leap if month == 2 else 30
    if day > length:
        return -1
    before = (year - 1969) // 4  # leap days of the years before
    return (year - 1970) * 365 + before + _DAYS_BEFORE[month - 1] + (1 if is_leap and month > 2 else 0) + day - 1
