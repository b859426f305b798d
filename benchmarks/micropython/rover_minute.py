# ruff: noqa: T201  what is printed is the answer
"""Starts the rover's program as main.py does, in the heap that the interpreter was given, and lets it run a minute.

It prints the bytes that are in use: by the mocks, then beyond these once the program is imported, and once it has made
its vehicle. Under MicroPython, with the firmware and the mocks on its path.
"""

import gc
import json


def in_use():
    """Return the bytes of the heap that are in use."""
    gc.collect()
    gc.collect()
    return gc.mem_alloc()


start = in_use()

import mock_time  # noqa: E402

mock_time.install()

import mock_asyncio  # noqa: E402  the clock has to be in place before it

mock_asyncio.install()

import asyncio  # noqa: E402
import select  # noqa: E402, F401
import socket  # noqa: E402, F401

import machine  # noqa: E402

# What a board has in its flash is none of the program's.
import network  # noqa: E402, F401

for gpio in (26, 27, 28, 29):  # whichever the program reads
    machine.analog(gpio).source = 2047
mocks = in_use()

import main  # noqa: E402

main.collect_often(True)
Vehicle = main.vehicle_class()
imported = in_use()
vehicle = Vehicle()
main.collect_often(False)
started = in_use()


async def minute():
    """Run the vehicle's tasks for a simulated minute."""
    task = asyncio.create_task(vehicle.run())
    await asyncio.sleep_ms(60000)
    task.cancel()


asyncio.run(minute())
print(json.dumps({"mocks": mocks - start, "imported": imported - mocks, "started": started - mocks}))
