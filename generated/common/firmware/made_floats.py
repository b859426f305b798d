# Generated from templates/firmware/made_floats.py: do not edit.
# Inputs: 32242bdcbdfde2db
"""Floats that have to be made before they go out, for which MicroPython allocates."""

from struct import pack_into


def make_float(code, wire, offset, value, numerator, denominator):
    """Write value * numerator / denominator as a float that is made for it, by struct's code."""
    pack_into(code, wire, offset, value * numerator / denominator)
