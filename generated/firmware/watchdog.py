# Generated from specs/vehicle.yaml, dialect common: do not edit.
# Inputs: ab31c14dcbb9b504
"""The board's watchdog: it resets the board where the main loop stands still. It begins with the loop, not before."""

import asyncio

import machine
from guard import Guard
from micropython import const

TIMEOUT_MS = 2000  # FR-00071.5
_LOOK_MS = const(500)
_LATE_US = const(2000000)  # of a job of the main loop
_FORGIVEN = ("control", "measure")  # the user's code: that it fails is told, and the loop goes on
_CAUSES = {3: "a restart", 1: "power on"}


def reset_reason():
    """Return what the last reset came from, as a text with its severity."""
    if machine.reset_cause() == machine.WDT_RESET and machine.mem32[0x400D801C] == 0x6AB73121:
        return "warning: The watchdog has reset the board: the main loop stood still"
    return "Started after " + _CAUSES.get(machine.reset_cause(), "a reset")


def start(log):
    """Start the watchdog, and return what feeds it; None, with a text, where the board refuses."""
    guard = Guard()
    with guard:
        return machine.WDT(timeout=TIMEOUT_MS).feed
    log("error: there is no watchdog:", repr(guard.error))
    return None


async def watch(vehicle, feed):
    """Feed it as long as all jobs of the main loop have their turns, and none of the program's own fails each time."""
    stalled = None
    while True:
        await asyncio.sleep_ms(_LOOK_MS)
        before = stalled
        stalled = vehicle.scheduler.stalled(_LATE_US, _FORGIVEN)
        if stalled is None:
            feed()
        elif before is None:
            vehicle.texts("error: The watchdog is about to reset the board:", stalled, "stands still or fails")
            vehicle.halt_motors()


def hold():
    """Let nothing reset the board while somebody is at its prompt; with the next start of the program that ends."""
    machine.mem32[0x400DB000] = 0x40000000
    machine.mem32[0x400D801C] = 0
