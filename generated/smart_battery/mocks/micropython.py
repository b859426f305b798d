# Generated from templates/mocks/micropython.py: do not edit.
# Inputs: be7203dcc48215ab
"""MicroPython's module of this name, as far as the firmware uses it, for CPython: functions stay what they are.

MicroPython has its own and never reads this file.
"""


def native(function):
    """Make no machine code."""
    return function


def kbd_intr(_character):
    """Leave the keyboard of the host as it is."""
