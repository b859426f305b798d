# ruff: noqa: T201  what is printed is the answer
"""Imports a vehicle's program and makes its vehicle, as rover_minute.py does, and prints what heap each module takes.

Of a module that is what it adds itself: others that it is the first to import are counted on their own. Under
MicroPython, with the firmware and the mocks on its path.
"""

import builtins
import gc
import json
import sys

import mock_time

mock_time.install()

import mock_asyncio  # noqa: E402  the clock has to be in place before it

mock_asyncio.install()

import asyncio  # noqa: E402, F401
import select  # noqa: E402, F401
import socket  # noqa: E402, F401

import machine  # noqa: E402
import micropython  # noqa: E402
import network  # noqa: E402, F401

for gpio in (26, 27, 28, 29):  # whichever the program reads
    machine.analog(gpio).source = 2047

imported = builtins.__import__
taken = []  # pairs of a module and its bytes
within = [0]  # bytes of the modules that each import has led to, the innermost last


def in_use():
    """Return the bytes of the heap that are in use."""
    gc.collect()
    gc.collect()
    return gc.mem_alloc()


def import_counted(name, *about):
    """Import a module as ever, and count what a new one takes."""
    if name in sys.modules:
        return imported(name, *about)
    before = in_use()
    within.append(0)
    try:
        return imported(name, *about)
    finally:
        added = in_use() - before
        taken.append((name, added - within.pop()))
        within[-1] += added


micropython.qstr_info()  # which prints how many bytes all names take, and once more at the end
builtins.__import__ = import_counted

import main  # noqa: E402

Vehicle = main.vehicle_class()
before_vehicle = in_use()
vehicle = Vehicle()
taken.append(("Vehicle()", in_use() - before_vehicle))
micropython.qstr_info()
print(json.dumps(taken))
