"""Takes lines of NMEA 0183 from what arrives, in plain Python; nmea_viper does the same in machine code.

The words: what has been taken of a line, counts of lines, and the fields of the last line in three words each: its
first letter, one more than what stands before the point, and one more than seven digits behind the point; 0 is none.
Fields are numbered as in the standard, 0 is the one with talker and type, which has none.

Each function has few variables: MicroPython puts those of larger ones on the heap at every call.
"""

from micropython import const
from sentences_plain import read

_PHASE = const(0)  # 0: waiting for a dollar
_LENGTH = const(1)
_SUM = const(2)
_SAID = const(3)  # the first digit of the checksum that the line has
_LINES = const(5)
_WRONG = const(6)
_CUT = const(7)
_COUNT = const(8)  # bytes of the piece
_FIELDS = const(6)  # so that field 1 comes next
_WORDS = const(60)
_INSIDE = const(1)
_STAR = const(2)
_DIGIT = const(3)

_LONGEST = const(96)
_TALKERS = (0x4750, 0x474E, 0x474C, 0x4741, 0x4742, 0x4244)  # GP, GN, GL, GA, GB, BD
_COMMA = const(44)
_MINUS = const(45)
_POINT = const(46)


def take(words, values, line, piece, count):
    """Take the first bytes of a piece of what arrives; what whole lines say is put into the values."""
    words[_COUNT] = count
    at = 0
    while at < count:
        if words[_PHASE] == _INSIDE:
            at = _fill(words, line, piece, at)
        if at < count:
            if _is_whole(words, line, piece[at]):
                _read(words, values, line)
            at += 1


def _fill(words, line, piece, at):
    """Take the usual characters of a line, as many as there are; return where others begin."""
    length = words[_LENGTH]
    count = words[_COUNT]
    while at < count and length < _LONGEST:
        byte = piece[at]
        if byte < 43 or byte > 126:  # a dollar, a star, what is no text
            break
        line[length] = byte
        words[_SUM] ^= byte
        length += 1
        at += 1
    words[_LENGTH] = length
    return at


def _is_whole(words, line, byte):
    """Take a character; return whether a line ends with it that has its checksum."""
    phase = words[_PHASE]
    if byte == 36:  # a dollar begins a line
        if phase:
            _count(words, _CUT)
        words[_PHASE] = _INSIDE
        words[_LENGTH] = words[_SUM] = 0
    elif phase == _INSIDE:
        if byte == 42:
            words[_PHASE] = _STAR
        elif words[_LENGTH] == _LONGEST or byte < 32 or byte > 126:
            words[_PHASE] = 0
            _count(words, _CUT)
        else:
            line[words[_LENGTH]] = byte
            words[_LENGTH] += 1
            words[_SUM] ^= byte
    elif phase:
        return _is_right(words, _digit(byte))
    return False


def _is_right(words, digit):
    """Take a digit of the checksum, or what is none; return whether it is the second one, and both are right."""
    phase = words[_PHASE]
    words[_PHASE] = 0
    if digit < 0:
        _count(words, _WRONG)
    elif phase == _STAR:
        words[_PHASE] = _DIGIT
        words[_SAID] = digit
    elif words[_SAID] << 4 | digit == words[_SUM]:
        _count(words, _LINES)
        return True
    else:
        _count(words, _WRONG)
    return False


def _count(words, place):
    words[place] = words[place] + 1 & 0x3FFFFFFF


def _digit(byte):
    """Return a hexadecimal digit; -1 if it is none."""
    if 48 <= byte <= 57:
        return byte - 48
    byte = (byte | 32) - 87
    return byte if 10 <= byte <= 15 else -1


def _read(words, values, line):
    """Read a whole line, if it is of a receiver of satellites."""
    if words[_LENGTH] < 6 or line[5] != _COMMA or line[0] << 8 | line[1] not in _TALKERS:
        return
    _split(words, line)
    read(words, values, (line[2] << 8 | line[3]) << 8 | line[4])


def _split(words, line):
    """Put what stands in the fields into the words."""
    line[words[_LENGTH]] = _COMMA  # so that each field ends with one
    at = 6
    place = _FIELDS + 3
    while place < _WORDS:
        words[place] = words[place + 1] = words[place + 2] = 0
        if at <= words[_LENGTH]:
            if line[at] != _COMMA:
                words[place] = line[at]
            at = _split_whole(words, place + 1, line, at)
            at = _split_part(words, place + 2, line, at)
        place += 3


def _split_whole(words, place, line, at):
    """Read what stands before the point of a field; return where it ends."""
    if line[at] == _MINUS:
        at += 1
    first = at
    number = 0
    while 48 <= line[at] <= 57:
        if at - first < 8:
            number = number * 10 + line[at] - 48
        at += 1
    if 0 < at - first < 9 and (line[at] == _POINT or line[at] == _COMMA):
        words[place] = number + 1
    return at


def _split_part(words, place, line, at):
    """Read what stands behind the point of a field, if there is one; return where the next field begins."""
    number = 1
    if line[at] == _POINT:
        at += 1
        step = 1000000
        while 48 <= line[at] <= 57:
            number += (line[at] - 48) * step
            step //= 10
            at += 1
    if line[at] == _COMMA:
        words[place] = number
    while line[at] != _COMMA:
        at += 1
    return at + 1
