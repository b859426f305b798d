"""The same as reals_plain in machine code, by MicroPython's viper emitter; that module describes it."""

# ptr8, ptr16 and ptr32 are viper's own names; calls cost more than what they would do.
# ruff: noqa: C901, F821, PLR0912, PLR0915

from array import array

import micropython

_limbs = array("i", [0] * 10)


@micropython.viper
def put_real(at: int, value: int, about: ptr8):
    """Write the float for a value at an address: what reals_plain.put_real() writes.

    `about` has the numerator and the divisor in four bytes each, the exponent in two, the two counts in one each.
    """
    wire = ptr8(at)
    size = about[11]
    if value == 0:
        while size:
            size -= 1
            wire[size] = 0
        return
    limbs = ptr32(_limbs)
    sign = 0
    if value < 0:
        sign = 0x80
        value = 0 - value
    # The product.
    low_factor = about[0] | (about[1] & 0x7F) << 8
    high_factor = about[1] >> 7 | about[2] << 1 | about[3] << 9
    low = (value & 0x7FFF) * low_factor
    limbs[3] = low & 0x7FFF
    high = (value >> 15) * low_factor + (low >> 15)
    low = (value & 0x7FFF) * high_factor + (high & 0x7FFF)
    limbs[2] = low & 0x7FFF
    high = (value >> 15) * high_factor + (high >> 15) + (low >> 15)
    limbs[1] = high & 0x7FFF
    limbs[0] = high >> 15
    # The quotient.
    divisor = about[4] | about[5] << 8 | about[6] << 16 | about[7] << 24
    bits = about[10]
    rest = 0
    first = 0
    last = 11  # until it is found
    while first < last:
        value = 0
        if first < 4:
            value = limbs[first]
        if value or rest:
            left = 15
            while left:
                left -= bits
                rest = rest << bits | value >> (15 - bits)
                low = rest // divisor
                value = (value << bits & 0x7FFF) | low
                rest -= low * divisor
        limbs[first] = value
        first += 1
        if value and last == 11:
            last = first + 4
    first = last - 5
    limbs = ptr32(int(limbs) + 4 * first)
    exponent = (about[8] | about[9] << 8) - 15 * first
    if rest:
        limbs[4] = limbs[4] | 1
    # Its first limb gets all its bits.
    bits = 0
    while limbs[0] << bits < 0x4000:
        bits += 1
    exponent -= bits
    left = 0
    while left < 4:
        limbs[left] = (limbs[left] << bits | limbs[left + 1] >> (15 - bits)) & 0x7FFF
        left += 1
    rest = limbs[4] << bits & 0x7FFF
    if size == 8:
        low = limbs[3]
        if rest:
            low |= 1
        value = limbs[2] << 8 | low >> 7
        if low & 0x7F > 0x40 or low & 0xFF == 0xC0:
            value += 1
        low = limbs[1] + (value >> 23)
        high = limbs[0] + (low >> 15)
        exponent += high >> 15
        wire[0] = value
        wire[1] = value >> 8
        wire[2] = (value >> 16 & 0x7F) | (low & 1) << 7
        wire[3] = low >> 1
        wire[4] = (low >> 9 & 0x3F) | (high & 3) << 6
        wire[5] = high >> 2
        wire[6] = (high >> 10 & 0xF) | (exponent & 0xF) << 4
        wire[7] = sign | exponent >> 4
        return
    low = limbs[1]
    if limbs[2] | limbs[3] | rest:
        low |= 1
    value = limbs[0] << 9 | low >> 6
    if low & 0x3F > 0x20 or low & 0x7F == 0x60:
        value += 1
    exponent += value >> 24
    wire[0] = value
    wire[1] = value >> 8
    wire[2] = (value >> 16 & 0x7F) | (exponent & 1) << 7
    wire[3] = sign | exponent >> 1
