# Generated from templates/firmware/floats_plain.py: do not edit.
# Inputs: e6add14d4d61af82
"""Floats of the wire from whole numbers, in plain Python: no float is made, so MicroPython allocates nothing.

Everything stays below 2 ** 30. Boards have floats of 32 bits, with which a value of more than 24 bits would be rounded
twice, before its division and after it: here it is rounded once.

Each function has few locals: MicroPython puts those of larger ones on the heap at every call.
"""


def put_float(wire, offset, value, divisor):
    """Write value / divisor as a float of 32 bits, little-endian, rounded to the nearest one, a half to the even one.

    The value is within 2 ** 30 - 1, either sign, the divisor at most 2 ** 25: each quotient but 0 is a normal number.
    """
    if value:
        _put_quotient(wire, offset, -value if value < 0 else value, divisor)
    else:
        wire[offset] = wire[offset + 1] = wire[offset + 2] = wire[offset + 3] = 0
    if value < 0:
        wire[offset + 3] |= 0x80


def _put_quotient(wire, offset, value, divisor):
    # Long division by so many bits at a time as keep the shifted rest, and the quotient, below 2 ** 30.
    rest = value % divisor
    value //= divisor
    exponent = 150  # as the wire has it, of 24 bits the last of which counts 1
    while value < 1 << 15 and divisor <= 1 << 15:
        rest <<= 15
        value = (value << 15) | (rest // divisor)
        rest %= divisor
        exponent -= 15
    while value < 1 << 25:
        rest <<= 5
        value = (value << 5) | (rest // divisor)
        rest %= divisor
        exponent -= 5
    _put_rounded(wire, offset, value | 1 if rest else value, exponent)


def _put_rounded(wire, offset, value, exponent):
    # 26 to 30 bits. 24 go out, the next one is the half; of all others it only counts whether one is set.
    while value >= 1 << 26:
        value = (value >> 1) | (value & 1)
        exponent += 1
    value = (value + 1 + ((value >> 2) & 1)) >> 2
    exponent += 2 + (value >> 24)  # one more where rounding has carried up to a 25th bit
    wire[offset] = value & 0xFF
    wire[offset + 1] = (value >> 8) & 0xFF
    wire[offset + 2] = ((value >> 16) & 0x7F) | ((exponent & 1) << 7)
    wire[offset + 3] = exponent >> 1
