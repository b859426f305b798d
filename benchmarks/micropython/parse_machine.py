# ruff: noqa: C901  a state machine by hand is one loop with a branch for each state
"""Receiving BATTERY_STATUS by hand: a state machine in bytecode, a step of the CRC for each byte, struct.unpack.

It does what such code does, no more: MAVLink 2 without signatures, one message, everything in local variables.
Arguments: file with the frames, passes, rounds per pass.
"""

import struct
import sys

from micropython import const
from stopwatch import answer

passes, count = map(int, sys.argv[2:4])
with open(sys.argv[1], "rb") as file:
    data = file.read()

FORMAT = "<iih10HhBBBbiB4HBI"
# MicroPython puts such numbers into the code, so that nothing is looked up in the loop.
_MESSAGE_ID = const(147)
_CRC_EXTRA = const(154)
_LENGTH = const(54)
_IDLE = const(0)
_HEADER = const(1)
_PAYLOAD = const(2)
_LOW = const(3)
_HIGH = const(4)


class Parser:
    """Keeps the state from one piece of data to the next, and calls `handler` with the fields of each message."""

    def __init__(self, handler):
        self.handler = handler
        self.state = _IDLE
        self.crc = 0
        self.at = 0
        self.header = bytearray(9)
        self.payload = bytearray(255)

    def feed(self, data):
        """Take in bytes."""
        state = self.state
        crc = self.crc
        at = self.at
        header = self.header
        payload = self.payload
        for byte in data:
            if state == _PAYLOAD:
                payload[at] = byte
                at += 1
                if at == header[0]:
                    state = _LOW
            elif state == _IDLE:
                if byte == 0xFD:
                    state = _HEADER
                    crc = 0xFFFF
                    at = 0
                continue
            elif state == _HEADER:
                header[at] = byte
                at += 1
                if at == 9:
                    at = 0
                    state = _PAYLOAD if header[0] else _LOW
            elif state == _LOW:
                step = _CRC_EXTRA ^ (crc & 0xFF)
                step = (step ^ (step << 4)) & 0xFF
                crc = (crc >> 8) ^ (step << 8) ^ (step << 3) ^ (step >> 4)
                state = _HIGH if byte == crc & 0xFF else _IDLE
                continue
            else:
                if byte == crc >> 8 and header[6] | header[7] << 8 | header[8] << 16 == _MESSAGE_ID:
                    for index in range(header[0], _LENGTH):
                        payload[index] = 0
                    self.handler(struct.unpack_from(FORMAT, payload))
                state = _IDLE
                continue
            step = byte ^ (crc & 0xFF)
            step = (step ^ (step << 4)) & 0xFF
            crc = (crc >> 8) ^ (step << 8) ^ (step << 3) ^ (step >> 4)
        self.state = state
        self.crc = crc
        self.at = at


def ignore(fields):
    """Take a message and do nothing with it."""


def received(first, count):
    """Receive all frames `count` times."""
    for _ in range(first, first + count):
        parser.feed(data)


shown = []
Parser(lambda fields: shown.append(list(fields[:4]) + [fields[13], fields[17]])).feed(data)  # noqa: RUF005
parser = Parser(ignore)
answer(received, count, passes, shown)
