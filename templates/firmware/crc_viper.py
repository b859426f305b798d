"""The checksum and the frame around a payload in machine code, made by MicroPython's viper emitter.

Does exactly what crc_plain does. Viper keeps a function's first three locals in registers: so the CRC, its table and
the bytes to read are the first three arguments. It checks no bounds: the callers do.
"""

# ruff: noqa: F821 - ptr8 and ptr16 are viper's own names

import micropython


@micropython.viper
def update(crc: int, table: ptr16, data: ptr8, start: int, end: int) -> int:
    """Return `crc` carried on over data[start:end]."""
    data = ptr8(int(data) + start)
    left = end - start
    while left >= 4:
        crc = table[(crc ^ data[0]) & 0xFF] ^ (crc >> 8)
        crc = table[(crc ^ data[1]) & 0xFF] ^ (crc >> 8)
        crc = table[(crc ^ data[2]) & 0xFF] ^ (crc >> 8)
        crc = table[(crc ^ data[3]) & 0xFF] ^ (crc >> 8)
        data = ptr8(int(data) + 4)
        left -= 4
    while left > 0:
        crc = table[(crc ^ data[0]) & 0xFF] ^ (crc >> 8)
        data = ptr8(int(data) + 1)
        left -= 1
    return crc


@micropython.viper
def write_frame(
    crc: int,
    table: ptr16,
    payload: ptr8,
    frame: ptr8,
    header: int,
    length: int,
    sequence: int,
    message_id: int,
    extra: int,
) -> int:
    """Write what changes from frame to frame, as crc_plain.write_frame does."""
    if header == 10:
        while length > 1 and payload[length - 1] == 0:
            length -= 1
        frame[4] = sequence
        frame[7] = message_id
        frame[8] = message_id >> 8
        frame[9] = message_id >> 16
    else:
        frame[2] = sequence
        frame[5] = message_id
    frame[1] = length
    index = 1
    while index < header:
        crc = table[(crc ^ frame[index]) & 0xFF] ^ (crc >> 8)
        index += 1
    target = ptr8(int(frame) + header)
    left = length
    while left >= 4:
        target[0] = payload[0]
        crc = table[(crc ^ payload[0]) & 0xFF] ^ (crc >> 8)
        target[1] = payload[1]
        crc = table[(crc ^ payload[1]) & 0xFF] ^ (crc >> 8)
        target[2] = payload[2]
        crc = table[(crc ^ payload[2]) & 0xFF] ^ (crc >> 8)
        target[3] = payload[3]
        crc = table[(crc ^ payload[3]) & 0xFF] ^ (crc >> 8)
        payload = ptr8(int(payload) + 4)
        target = ptr8(int(target) + 4)
        left -= 4
    while left > 0:
        target[0] = payload[0]
        crc = table[(crc ^ payload[0]) & 0xFF] ^ (crc >> 8)
        payload = ptr8(int(payload) + 1)
        target = ptr8(int(target) + 1)
        left -= 1
    crc = table[(crc ^ extra) & 0xFF] ^ (crc >> 8)
    target[0] = crc
    target[1] = crc >> 8
    return length
