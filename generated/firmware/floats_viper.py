# Generated from templates/firmware/floats_viper.py: do not edit.
# Inputs: 44bfaf5af7e8ba59
"""Floats of the wire from whole numbers in machine code, by MicroPython's viper emitter; floats_plain describes it.

The caller sees to it that there are four bytes at the address: viper checks no bounds.
"""

# ptr8 is viper's own name; min() and chained assignments cost calls and objects.
# ruff: noqa: F821

import micropython


@micropython.viper
def put_float(at: int, value: int, divisor: int):
    """Write value / divisor as a float of 32 bits at an address, as floats_plain.put_float does into a buffer."""
    target = ptr8(at)
    sign = 0
    if value < 0:
        sign = 0x80
        value = 0 - value
    exponent = 0
    if value:
        rest = value % divisor
        value //= divisor
        exponent = 152
        if divisor <= 32768:
            while value < 32768:
                rest <<= 15
                value = (value << 15) | (rest // divisor)
                rest %= divisor
                exponent -= 15
        while value < 33554432:
            rest <<= 5
            value = (value << 5) | (rest // divisor)
            rest %= divisor
            exponent -= 5
        if rest:
            value |= 1
        while value >= 67108864:
            value = (value >> 1) | (value & 1)
            exponent += 1
        value = (value + 1 + ((value >> 2) & 1)) >> 2
        exponent += value >> 24
    target[0] = value
    target[1] = value >> 8
    target[2] = ((value >> 16) & 0x7F) | (exponent << 7)
    target[3] = sign | (exponent >> 1)
