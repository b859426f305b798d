# ruff: noqa: T201  what is printed is the answer
"""Starts a vehicle's program as main.py does, in the heap that the interpreter was given, and lets it run a minute.

It prints the bytes that are in use: by the mocks, then beyond these once the program is imported, and once it has made
its vehicle. With the argument `rarely` somebody then asks for what few ask for, of which some is loaded only then. With
`held` it ends before the program is imported, and prints what is in use.

Under MicroPython, with the firmware and the mocks on its path.
"""

import gc
import json
import struct
import sys


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

# The modules that a board has in its flash are none of the program's.
import network  # noqa: E402, F401

for gpio in (26, 27, 28, 29):  # whichever the program reads
    machine.analog(gpio).source = 2047
mocks = in_use()
if sys.argv[1:] == ["held"]:
    print(json.dumps({"held": mocks}))
    sys.exit()

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


def ask(message):
    """Let a message arrive, whoever it is for, and what is to be said about it go out."""
    connection = vehicle.connections[0]
    connection.services.handle(message)
    for _ in range(3):
        connection.run(mock_time.ticks_ms())


def command(number, *params):
    """Let a COMMAND_LONG arrive."""
    message = messages.CommandLong(unknown=False)
    struct.pack_into("<7f", message.wire, 0, *(params + (0,) * (7 - len(params))))
    struct.pack_into("<H", message.wire, 28, number)
    ask(message)


def ask_rarely():
    """Ask for all parameters, set one, ask for missions, logs, files, versions, modes, the clock, and for defaults."""
    ask(messages.ParamRequestList(unknown=False))
    for _ in range(60):
        vehicle.connections[0].run(mock_time.ticks_ms())
    setting = messages.ParamSet(unknown=False)
    for value in (3, 1e9):  # accepted, refused
        struct.pack_into("<fBB16s", setting.wire, 0, value, 0, 0, b"SYSID_THISMAV")
        ask(setting)
    for number in (43, 44, 45, 40, 51, 117):
        ask(vehicle.connections[0].services._question(number))
    for number in (512, 511, 510, 520, 519, 401, 245, 246, 31010, 176):
        command(number, 2)
    for name in ("SystemTime", "SetMode", "CommandCancel"):
        kind = getattr(messages, name, None)
        if kind is not None:
            ask(kind(unknown=False))


asyncio.run(minute())
if sys.argv[1:] == ["rarely"]:
    import messages

    ask_rarely()
    assert "fields" not in sys.modules, "names of fields are read"
print(json.dumps({"mocks": mocks - start, "imported": imported - mocks, "started": started - mocks}))
