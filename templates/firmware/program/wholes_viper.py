"""Whole numbers of floats that arrive, by MicroPython's viper emitter; wholes_plain says how."""

# Calls are dear: one function does it all; ptr32 is viper's own name.
# ruff: noqa: C901, F821, PLR0912, PLR0915

import micropython


@micropython.viper
def whole_of_float(at: int):
    """Do what wholes_plain does with four words at an address, and put what comes of it into the first of them.

    They are the halves of a float, the high one first, a numerator and a denominator: each argument more takes as long
    as ten statements.
    """
    whole: int  # the first variables have registers
    shift: int
    given = ptr32(at)
    high = int(given[0])
    numerator = int(given[2])
    denominator = int(given[3])
    whole = int(given[1]) | (high & 0x7F | 0x80) << 16
    shift = 150 - (high >> 7 & 0xFF)  # how many bits of it stand behind the point
    if shift > 60:
        given[0] = 0
        return
    # The digits behind the point, times the numerator; `last` is the bit behind that.
    rest = last = 0
    if shift <= 0:
        whole <<= 0 - shift
    else:
        bits = whole
        whole = 0
        if shift < 24:
            whole = bits >> shift
            bits &= (1 << shift) - 1
        if numerator < 0x20000:
            if shift < 24:
                bits <<= 24 - shift
                shift = 24
            if shift <= 54:
                rest = (bits >> 12) * numerator + ((bits & 0xFFF) * numerator >> 12) >> shift - 13
                last = rest & 1
                rest >>= 1
        else:
            while shift:
                if bits & 1:
                    rest += numerator
                last = rest & 1
                rest >>= 1
                bits >>= 1
                shift -= 1
    result = 0
    left = whole * numerator + rest
    if whole | numerator > 0x3FFF and whole > 0x1FFFFFFF // numerator:
        # A long division, since the product has more than 30 bits.
        left = 0
        bit = 0x20000000
        while bit:
            left <<= 1
            if whole & bit:
                left += numerator
            result = (result << 1) + left // denominator
            left = left % denominator
            bit >>= 1
        left += rest
    if denominator > 1:
        result += left // denominator
        left = left % denominator
    else:
        result += left
        left = 0
    if 2 * left + last >= denominator:
        result += 1
    given[0] = 0 - result if high & 0x8000 else result
