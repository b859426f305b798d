# Generated from templates/mocks/micropython.py: do not edit.
# Inputs: 8de31f6f40b1a9d9
"""MicroPython's module of this name, as far as the firmware uses it, for CPython: functions stay what they are.

MicroPython has its own and never reads this file.
"""


def const(value):
    """Return a constant as it is: MicroPython puts it where it is used."""
    return value


def native(function):
    """Make no machine code."""
    return function


def kbd_intr(_character):
    """Leave the keyboard of the host as it is."""
