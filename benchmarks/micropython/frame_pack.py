"""The usual way to make a frame by hand in MicroPython: struct.pack, header + payload, a loop for the CRC.

It does what such code does, no more: no limits, no sentinels. The zeros at the end go away by rstrip(), the fastest
way. Every frame leaves garbage behind: looking for free memory among it and collecting it takes as long as the rest.
Arguments: loop or table, which is a CRC that looks up byte by byte, for 512 bytes of memory; steady, or fresh, with a
collection before each pass that does not count, so that a short pass has only what the code itself takes; then passes,
frames per pass, and what the frame has, see frame.py.
"""

import gc
import struct
import sys
from array import array

from stopwatch import answer

passes, count, system, component, number, function, kind = map(int, sys.argv[3:10])
VALUES = tuple(map(int, sys.argv[10:15]))
CRC_EXTRA = 154
MESSAGE_ID = 147
FORMAT = "<iih10HhBBBbiB4HBI"


def crc_loop(data):
    """CRC-16/MCRF4XX, the eight bits of a byte at once."""
    crc = 0xFFFF
    for byte in data:
        byte ^= crc & 0xFF  # noqa: PLW2901
        byte = (byte ^ (byte << 4)) & 0xFF  # noqa: PLW2901
        crc = (crc >> 8) ^ (byte << 8) ^ (byte << 3) ^ (byte >> 4)
    return crc


def _entry(byte):
    byte = (byte ^ (byte << 4)) & 0xFF
    return (byte << 8) ^ (byte << 3) ^ (byte >> 4)


TABLE = array("H", [_entry(byte) for byte in range(256)])


def crc_table(data):
    """The same with a table."""
    table = TABLE
    crc = 0xFFFF
    for byte in data:
        crc = table[(crc ^ byte) & 0xFF] ^ (crc >> 8)
    return crc


crc_of = crc_table if sys.argv[1] == "table" else crc_loop


def battery_status(sequence, consumed, energy, temperature, voltages, current, remaining):
    """Return the frame."""
    values = (consumed, energy, temperature) + voltages + (current, number, function, kind, remaining)  # noqa: RUF005
    payload = struct.pack(FORMAT, *values, 0, 0, 0, 0, 0, 0, 0, 0).rstrip(b"\0") or b"\0"
    header = bytes(
        (len(payload), 0, 0, sequence, system, component, MESSAGE_ID & 0xFF, MESSAGE_ID >> 8 & 0xFF, MESSAGE_ID >> 16)
    )
    body = header + payload
    return b"\xfd" + body + struct.pack("<H", crc_of(body + bytes((CRC_EXTRA,))))


def frames(first, count):
    """Make `count` frames; the charge counts on from `first`. Return the last frame."""
    temperature, millivolts, current, energy, remaining = VALUES
    voltages = (millivolts,) + (65535,) * 9
    frame = None
    for consumed in range(first, first + count):
        frame = battery_status(0, consumed, energy, temperature, voltages, current, remaining)
    return frame


prepare = gc.collect if sys.argv[2] == "fresh" else None
answer(frames, count, passes, [frames(first, 1).hex() for first in (1234, 98765)], prepare)
