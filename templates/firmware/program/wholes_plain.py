"""Whole numbers of floats that arrive, exact and without a float: boards keep each of those on the heap.

Each function has few variables: MicroPython puts those of larger ones on the heap at every call.
"""

from micropython import const

_HIGHEST = const(0x20000000)
_MOST = const(0x1FFFFFFF)


def whole_of_float(high, low, numerator, denominator):
    """Return the whole number nearest to a float of 32 bits times numerator / denominator, a half away from zero.

    `high` and `low` are the halves of its bits. It is finite and, as the result, less than 2 ** 30; the other two are
    less than 2 ** 28.
    """
    low |= (high & 0x7F | 0x80) << 16
    shift = 150 - (high >> 7 & 0xFF)  # how many bits of it stand behind the point
    if shift > 60:
        return 0
    if shift <= 0:
        low = _scaled(low << -shift, 0, numerator, denominator)
    elif shift >= 24:
        low = _scaled(0, _halved(low, shift, numerator), numerator, denominator)
    else:
        low = _scaled(low >> shift, _halved(low & ((1 << shift) - 1), shift, numerator), numerator, denominator)
    return -low if high & 0x8000 else low


def _halved(bits, count, number):
    """Return 2 * number * bits / 2 ** count as a whole number, rounded down; bits are less than 2 ** count."""
    if number < 0x20000:  # in two parts, of which the products have 30 bits
        if count < 24:
            bits <<= 24 - count
            count = 24
        return (bits >> 12) * number + ((bits & 0xFFF) * number >> 12) >> count - 13 if count <= 54 else 0
    whole = last = 0
    while count:
        if bits & 1:
            whole += number
        last = whole & 1
        whole >>= 1
        bits >>= 1
        count -= 1
    return whole << 1 | last


def _scaled(whole, twice, numerator, denominator):
    """Return (whole * numerator + twice / 2) / denominator, rounded to the nearest."""
    left = result = 0
    if whole <= _MOST // numerator:
        left = whole * numerator
        whole = 0
    bit = _HIGHEST if whole else 0
    while bit:  # a long division, since the product has more than 30 bits
        left <<= 1
        if whole & bit:
            left += numerator
        result = (result << 1) + left // denominator
        left %= denominator
        bit >>= 1
    left += twice >> 1
    result += left // denominator
    left %= denominator
    return result + 1 if 2 * left + (twice & 1) >= denominator else result
