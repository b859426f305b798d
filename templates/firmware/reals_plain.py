"""Floats of 32 and 64 bits from whole numbers times any factor, in plain Python: nothing is allocated for them.

Numbers are kept in limbs of 15 bits, so that everything stays below 2 ** 30. Each function has few locals: MicroPython
puts those of larger ones on the heap at every call.
"""

# The high ones first: those of the product count from 2 ** 45 down to 1, then come its fractions. Behind them the rest.
_limbs = [0] * 11


def put_real(wire, offset, value, about):
    """Write value * numerator / divisor * 2 ** power as a float, rounded to the nearest one, a half to the even one.

    The value is within 2 ** 30 - 1, either sign. `about` has the numerator, below 2 ** 30; the divisor, below 2 ** 29;
    the exponent as the wire has it while the first limb of the quotient has all its bits; how many bits of the
    quotient are found at once; and the bytes of the float, 4 or 8.
    """
    if value:
        _multiply(-value if value < 0 else value, about[0])
        first = _divide(about[1], about[3])
        _put(wire, offset, about, first)
    else:
        _put_zeros(wire, offset, about[4])
    if value < 0:
        wire[offset + about[4] - 1] |= 0x80


def _put_zeros(wire, offset, size):
    while size:
        size -= 1
        wire[offset + size] = 0


def _put(wire, offset, about, first):
    exponent = about[2] - 15 * first - _align(first)
    if about[4] == 8:
        _put_double(wire, offset, first, exponent)
    else:
        _put_single(wire, offset, first, exponent)


def _multiply(value, numerator):
    low = (value & 0x7FFF) * (numerator & 0x7FFF)
    _limbs[3] = low & 0x7FFF
    high = (value >> 15) * (numerator & 0x7FFF) + (low >> 15)
    low = (value & 0x7FFF) * (numerator >> 15) + (high & 0x7FFF)
    _limbs[2] = low & 0x7FFF
    high = (value >> 15) * (numerator >> 15) + (high >> 15) + (low >> 15)
    _limbs[1] = high & 0x7FFF
    _limbs[0] = high >> 15
    for at in range(4, 10):
        _limbs[at] = 0


def _divide(divisor, bits):
    """Return where the quotient begins; behind its first limb there are four, the last of which tells of a rest."""
    at = 0
    last = 11  # until it is found
    _limbs[10] = 0
    while at < last:
        if _limbs[at] or _limbs[10]:
            _divide_limb(at, divisor, bits)
            if _limbs[at] and last == 11:
                last = at + 5
        at += 1
    if _limbs[10]:
        _limbs[last - 1] |= 1
    return last - 5


def _divide_limb(at, divisor, bits):
    # So many bits leave the limb at its upper end as bits of the quotient enter at its lower one.
    limb = _limbs[at]
    rest = _limbs[10]
    left = 15
    while left:
        left -= bits
        rest = rest << bits | limb >> (15 - bits)
        limb = (limb << bits & 0x7FFF) | rest // divisor
        rest %= divisor
    _limbs[at] = limb
    _limbs[10] = rest


def _align(first):
    """Shift the quotient so that its first limb has all its bits, and return by how much."""
    shift = 0
    while _limbs[first] << shift < 0x4000:
        shift += 1
    for at in range(first, first + 4):
        _limbs[at] = (_limbs[at] << shift | _limbs[at + 1] >> (15 - shift)) & 0x7FFF
    _limbs[first + 4] = _limbs[first + 4] << shift & 0x7FFF
    return shift


def _put_double(wire, offset, first, exponent):
    # 53 bits go out: 15, 15, 15 and 8. The next one is the half; of all others it only counts whether one is set.
    low = _limbs[first + 3]
    if _limbs[first + 4]:
        low |= 1
    value = _limbs[first + 2] << 8 | low >> 7
    if low & 0x7F > 0x40 or low & 0xFF == 0xC0:
        value += 1
    wire[offset] = value & 0xFF
    wire[offset + 1] = value >> 8 & 0xFF
    low = _limbs[first + 1] + (value >> 23)
    wire[offset + 2] = value >> 16 & 0x7F | (low & 1) << 7
    wire[offset + 3] = low >> 1 & 0xFF
    value = _limbs[first] + (low >> 15)
    exponent += value >> 15  # one more where rounding has carried through all of them
    wire[offset + 4] = low >> 9 & 0x3F | (value & 3) << 6
    wire[offset + 5] = value >> 2 & 0xFF
    wire[offset + 6] = value >> 10 & 0xF | (exponent & 0xF) << 4
    wire[offset + 7] = exponent >> 4


def _put_single(wire, offset, first, exponent):
    # 24 bits: 15 and 9.
    low = _limbs[first + 1]
    if _limbs[first + 2] or _limbs[first + 3] or _limbs[first + 4]:
        low |= 1
    value = _limbs[first] << 9 | low >> 6
    if low & 0x3F > 0x20 or low & 0x7F == 0x60:
        value += 1
    exponent += value >> 24
    wire[offset] = value & 0xFF
    wire[offset + 1] = value >> 8 & 0xFF
    wire[offset + 2] = value >> 16 & 0x7F | (exponent & 1) << 7
    wire[offset + 3] = exponent >> 1
