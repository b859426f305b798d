"""Tools for the checks of views: messages, links that make frames of them, and comparisons of numbers.

The receiver is that of two packs with both generations and information; frames are made by its own codec.
"""

import json

import messages
from mavlink import Link

TURN_MS = 1 << 30
SECOND = 1000
LINKS = {source: Link(None, 7, source) for source in (1, 180)}


def status(number=0, **fields):
    """Return BATTERY_STATUS with some fields known."""
    return messages.BatteryStatus().update(id=number, **fields)


def status_v2(number=0, **fields):
    """Return BATTERY_STATUS_V2 with some fields known."""
    return messages.BatteryStatusV2().update(id=number, status_flags=0, **fields)


def info(serial, number=0, **fields):
    """Return SMART_BATTERY_INFO about a pack with a serial number."""
    return messages.SmartBatteryInfo().update(id=number, serial_number=serial, **fields)


def feed(packs, message, now_ms, source=1):
    """Send a message over the wire."""
    assert packs.feed(bytes(LINKS[source].encode(message)), now_ms) == 1


def equals(value, expected, within=1e-5):
    """Compare numbers, which are of single precision on a board."""
    assert value is not None
    assert abs(value - expected) <= within * max(1, abs(expected)), (value, expected)


def outcome(check):
    """Return None if a check passes, else what went wrong."""
    try:
        check()
    except AssertionError as error:
        return repr(error)
    return None


def main(checks):
    """Print what came of the checks."""
    print(json.dumps({check.__name__: outcome(check) for check in checks}))  # noqa: T201
