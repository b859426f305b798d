"""Prints as JSON the values that the firmware sends and the receiver reads: `multiplied.py generated-folder`."""

import json
import sys
import time
from pathlib import Path

GENERATED = Path(sys.argv[1])
time.ticks_ms = lambda: 0
time.ticks_us = lambda: 0
time.ticks_diff = lambda later, earlier: later - earlier
sys.path[:0] = [str(GENERATED / "mocks"), str(GENERATED / "firmware")]

import state as state_module  # noqa: E402
import telemetry  # noqa: E402
from mavlink import Link  # noqa: E402


class Sink:
    """Takes every frame."""

    def write(self, frame: bytes) -> int:
        """Say that all of it was sent."""
        return len(frame)


state = state_module.SystemState(log=lambda *_: None)
link = Link(Sink())
sent = []
for hdop, bearing in ((None, 0), (0, 0), (1, 120), (2, 240), (655, 360), (700, 1)):
    state.gps.hdop = hdop
    state.gps.bearing = bearing
    frames = [
        bytes(link.encode(getattr(telemetry, f"build_{name}")(state))).hex()
        for name in ("gps_raw_int", "gps_status", "hil_gps")
    ]
    sent.append({"hdop": hdop, "bearing": bearing, "frames": frames})

for name in (
    "mavlink",
    "messages",
    "message_fields",
    "fields",
    "live_fields",
    "message",
    "frames",
    "dialect",
    "state",
    "telemetry",
):
    sys.modules.pop(name, None)
sys.path[1:2] = [str(GENERATED / "receiver")]
from gpses import Gpses  # noqa: E402

for one in sent:
    receiver = Gpses()
    receiver.feed(bytes.fromhex(one["frames"][2]), 0)
    (view,) = receiver.views()
    one["read"] = [view.eph, view.hdop]
print(json.dumps(sent))  # noqa: T201
