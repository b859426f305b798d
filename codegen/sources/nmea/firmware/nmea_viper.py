"""Takes lines of NMEA 0183 in machine code; nmea_plain has the same in Python, and says what is in the words."""

# ptr8 and ptr32 are viper's own names; calls are dear, so few functions do it all; `in` would make a set.
# ruff: noqa: F821, C901, PLR0912, PLR0915, PLR1714

import micropython
from micropython import const
from sentences_viper import read

_PHASE = const(0)
_LENGTH = const(1)
_SUM = const(2)
_SAID = const(3)
_LINES = const(5)
_WRONG = const(6)
_CUT = const(7)
_FIELDS = const(6)
_WORDS = const(60)
_INSIDE = const(1)
_STAR = const(2)
_DIGIT = const(3)

_LONGEST = const(96)


@micropython.viper
def take(words, values, line, piece, count: int):
    """Take the first bytes of a piece of what arrives; what whole lines say is put into the values."""
    word = ptr32(words)
    text = ptr8(line)
    came = ptr8(piece)
    at = 0
    while at < count:
        if word[_PHASE] == _INSIDE:  # the usual characters, as many as there are
            length = word[_LENGTH]
            total = word[_SUM]
            byte = came[at]
            while byte > 42 and byte < 127 and length < _LONGEST:
                text[length] = byte
                total ^= byte
                length += 1
                at += 1
                byte = 0
                if at < count:
                    byte = came[at]
            word[_LENGTH] = length
            word[_SUM] = total
            if at == count:
                return
        byte = came[at]
        at += 1
        phase = word[_PHASE]
        if byte == 36:  # a dollar begins a line
            if phase:
                word[_CUT] = word[_CUT] + 1 & 0x3FFFFFFF
            word[_PHASE] = _INSIDE
            word[_LENGTH] = 0
            word[_SUM] = 0
        elif phase == _INSIDE:
            length = word[_LENGTH]
            if byte == 42:
                word[_PHASE] = _STAR
            elif length == _LONGEST or byte < 32 or byte > 126:
                word[_PHASE] = 0
                word[_CUT] = word[_CUT] + 1 & 0x3FFFFFFF
            else:
                text[length] = byte
                word[_LENGTH] = length + 1
                word[_SUM] = word[_SUM] ^ byte
        elif phase:  # a digit of the checksum
            digit = byte - 48
            if digit > 9:
                digit = (byte | 32) - 87
                if digit < 10:
                    digit = 16
            if phase == _STAR and digit >= 0 and digit < 16:
                word[_SAID] = digit
                word[_PHASE] = _DIGIT
            else:
                word[_PHASE] = 0
                if phase == _DIGIT and digit >= 0 and digit < 16 and word[_SAID] << 4 | digit == word[_SUM]:
                    word[_LINES] = word[_LINES] + 1 & 0x3FFFFFFF
                    _read(words, values, line)
                else:
                    word[_WRONG] = word[_WRONG] + 1 & 0x3FFFFFFF


@micropython.viper
def _read(words, values, line):
    """Read a whole line, if it is of a receiver of satellites."""
    text = ptr8(line)
    if ptr32(words)[_LENGTH] < 6 or text[5] != 44:
        return
    talker = text[0] << 8 | text[1]
    is_known = talker == 0x4750 or talker == 0x474E or talker == 0x474C  # GP, GN, GL
    if not is_known and talker != 0x4741 and talker != 0x4742 and talker != 0x4244:  # GA, GB, BD
        return
    _split(words, line)
    read(words, values, (text[2] << 8 | text[3]) << 8 | text[4])


@micropython.viper
def _split(words, line):
    """Put what stands in the fields into the words."""
    word = ptr32(words)
    text = ptr8(line)
    length = word[_LENGTH]
    text[length] = 44  # so that each field ends with a comma
    at = 6
    place = _FIELDS + 3
    while place < _WORDS:
        letter = 0
        whole = 0
        part = 0
        if at <= length:
            byte = text[at]
            if byte != 44:
                letter = byte
            if byte == 45:
                at += 1
                byte = text[at]
            first = at
            number = 0
            while byte > 47 and byte < 58:
                if at - first < 8:
                    number = number * 10 + byte - 48
                at += 1
                byte = text[at]
            if at > first and at - first < 9 and (byte == 46 or byte == 44):
                whole = number + 1
            number = 1
            if byte == 46:
                at += 1
                byte = text[at]
                step = 1000000
                while byte > 47 and byte < 58:
                    number += (byte - 48) * step
                    step //= 10
                    at += 1
                    byte = text[at]
            if byte == 44:
                part = number
            while byte != 44:
                at += 1
                byte = text[at]
            at += 1
        word[place] = letter
        word[place + 1] = whole
        word[place + 2] = part
        place += 3
