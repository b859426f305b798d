"""The module `time` with a clock that stands still at 0; see counting.py."""

from time import sleep_ms, sleep_us, ticks_add, ticks_diff  # noqa: F401

from micropython import opt_level  # a function in C that returns 0

ticks_ms = ticks_us = opt_level
