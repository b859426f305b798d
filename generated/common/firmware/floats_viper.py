# Generated from templates/firmware/floats_viper.py: do not edit.
# Inputs: 6b58c226fe57955f
"""Floats of the wire from whole numbers in machine code, by MicroPython's viper emitter; floats_plain describes them.

The caller sees to it that they lie at multiples of four: viper checks no bounds.
"""

# ptr8, ptr16 and ptr32 are viper's own names; calls cost more than what they would do.
# ruff: noqa: C901, F821, PLR0915

import micropython


@micropython.viper
def put_floats(value: int, floats: ptr8):
    """Make a float of each word that `floats` names: what floats_plain.put_float() writes for it and its divisor.

    `value` is the address of the first word, then what is in a word. `floats` has four bytes for each: 6 bits are the
    place, 26 the divisor; 0 is the end. What is beyond 2 ** 30 - 1 is a float already and stays.
    """
    exponent: int  # the first variable has a register
    at = value
    bit = 1
    sign = bit << 31
    divisor = floats[0] >> 6 | floats[1] << 2 | floats[2] << 10 | floats[3] << 18
    while divisor:
        word = ptr32(at + 4 * (floats[0] & 63))
        value = (word[0] ^ sign) - sign
        top = 0
        if value < 0:
            top = 0x8000
            value = 0 - value
        if value and value < bit << 30:
            # First as many bits as there is room for, so that few are missing behind the division.
            exponent = 151
            if value < 32768:
                value <<= 15
                exponent -= 15
            if value < 4194304:
                value <<= 8
                exponent -= 8
            if value < 67108864:
                value <<= 4
                exponent -= 4
            if value < 268435456:
                value <<= 2
                exponent -= 2
            if divisor != 1:
                rest = value
                value //= divisor
                rest -= value * divisor
                if value < 1048576 and divisor < 1048576:
                    rest <<= 7
                    more = rest // divisor
                    rest -= more * divisor
                    value = (value << 7) | more
                    exponent -= 7
                while value < 33554432:
                    rest <<= 5
                    more = rest // divisor
                    rest -= more * divisor
                    value = (value << 5) | more
                    exponent -= 5
                if rest:
                    value |= 1
            while value >= 67108864:
                value = (value >> 1) | (value & 1)
                exponent += 1
            value = (value + 1 + ((value >> 2) & 1)) >> 2
            half = ptr16(word)
            half[0] = value
            half[1] = top + (exponent << 7) + (value >> 16)
        floats = ptr8(int(floats) + 4)
        divisor = floats[0] >> 6 | floats[1] << 2 | floats[2] << 10 | floats[3] << 18
