# ruff: noqa: T201  what is printed is the answer
"""Starts a vehicle's program as main.py does, and prints the bytes beyond the mocks that are in use then."""

import gc
import json

import mock_time

mock_time.install()

import mock_asyncio  # noqa: E402

mock_asyncio.install()

import asyncio  # noqa: E402, F401
import select  # noqa: E402, F401
import socket  # noqa: E402, F401

# The modules that a board has in its flash are none of the program's.
import machine  # noqa: E402, F401
import network  # noqa: E402, F401


def in_use():
    """Return the bytes of the heap that are in use."""
    gc.collect()
    gc.collect()
    return gc.mem_alloc()


mocks = in_use()

import main  # noqa: E402

main.collect_often(True)
Vehicle = main.vehicle_class()
imported = in_use() - mocks
vehicle = Vehicle()
main.collect_often(False)
print(json.dumps({"imported": imported, "started": in_use() - mocks}))
