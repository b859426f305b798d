# Generated from specs/codegen.yaml, specs/messages/battery_status.yaml, specs/messages/heartbeat.yaml,
#   specs/messages/sys_status.yaml, specs/parameters.yaml, specs/streams.yaml: do not edit.
# Inputs: 66a05cd7d335e0b4
"""Sends each message at the rate of its stream."""

import time

import messages
import telemetry
from mavlink import Link

SYSTEM_ID = 1
COMPONENT_ID = 1  # MAV_COMP_ID_AUTOPILOT1
VERSION = 2
LONGEST = 54  # bytes of the longest payload; a link keeps a view of each length


def open_link(stream):
    """Return a link with the ids and the MAVLink version of this vehicle."""
    return Link(stream, SYSTEM_ID, COMPONENT_ID, VERSION, messages.ALL, LONGEST)


class Streams:
    """The streams of one link, all due at once when they start."""

    def __init__(self, state, link):
        self._state = state
        self._link = link
        now_ms = time.ticks_ms()
        self._due_ms = [now_ms for _ in range(3)]

    def run(self, now_ms):
        """Send what is due; call it in every pass of the main loop with time.ticks_ms()."""
        state = self._state
        link = self._link

        # HEARTBEAT: 1 Hz (FR-00068.8)
        if self._is_due(0, now_ms, 1000):
            link.send(telemetry.build_heartbeat(state))

        # STATUS: 1 Hz (FR-00068.9)
        if self._is_due(1, now_ms, 1000):
            link.send(telemetry.build_sys_status(state))

        # EXTRA1: SR0_EXTRA1 sets the rate (FR-00068.2)
        steps = state.parameters.sr0_extra1
        if steps <= 0:
            self._due_ms[2] = now_ms
        elif self._is_due(2, now_ms, 1000 // steps):
            link.send(telemetry.build_battery_status(state))

    def _is_due(self, stream, now_ms, period_ms):
        due_ms = self._due_ms[stream]
        if time.ticks_diff(now_ms, due_ms) < 0:
            return False
        due_ms = time.ticks_add(due_ms, period_ms)
        if time.ticks_diff(now_ms, due_ms) >= 0:  # a pass came too late: no burst to catch up
            due_ms = time.ticks_add(now_ms, period_ms)
        self._due_ms[stream] = due_ms
        return True
