"""Whole numbers of floats that arrive, by MicroPython's viper emitter; wholes_plain says how."""

import micropython


@micropython.viper
def whole_of_float(high: int, low: int, numerator: int, denominator: int) -> int:
    """Return the whole number nearest to a float of 32 bits times numerator / denominator, as wholes_plain does."""
    whole = low | (high & 0x7F | 0x80) << 16
    shift = 150 - (high >> 7 & 0xFF)  # how many bits of it stand behind the point
    if shift > 60:
        return 0
    # What stands behind the point, times the numerator; `last` is the bit behind that.
    rest = last = 0
    if shift <= 0:
        whole <<= 0 - shift
    else:
        bits = whole
        whole = whole >> shift if shift < 24 else 0
        while shift:
            if bits & 1:
                rest += numerator
            last = rest & 1
            rest >>= 1
            bits >>= 1
            shift -= 1
    left = result = 0
    bit = 0x20000000
    while bit:
        left <<= 1
        if whole & bit:
            left += numerator
        result = (result << 1) + left // denominator
        left = left % denominator
        bit >>= 1
    left += rest
    result += left // denominator
    left = left % denominator
    if 2 * left + last >= denominator:
        result += 1
    return 0 - result if high & 0x8000 else result
