"""Starts the program as the board does, in whatever heap the interpreter was given, and lets it run a minute."""

import mock_time

mock_time.install()

import mock_asyncio  # noqa: E402  the clock has to be in place before it

mock_asyncio.install()

import asyncio  # noqa: E402

import machine  # noqa: E402
from vehicle import Vehicle  # noqa: E402

for gpio in (26, 27, 28, 29):  # whichever the program reads; facts of the suite would take heap of the program's
    machine.analog(gpio).source = 2047


async def minute():
    """Run the vehicle's tasks for a simulated minute."""
    task = asyncio.create_task(Vehicle().run())
    await asyncio.sleep_ms(60000)
    task.cancel()


asyncio.run(minute())
print("ran")
