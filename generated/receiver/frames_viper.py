# Generated from templates/codec/frames_viper.py: do not edit.
# Inputs: 110b939ba5cb506f
"""Making and reading frames in machine code, by MicroPython's viper emitter; frames_plain describes what each does.

Viper keeps a function's first three locals in registers: so the CRC, its table and the bytes to read are the first
three arguments. It checks no bounds: the callers do. All that is read or written in steps of two or four bytes lies
at a multiple of that, which the smaller Cortex-M insist on.
"""

# Calls are dear and few; ptr8, ptr16 and ptr32 are viper's own names.
# ruff: noqa: C901, F821, PLR0912, PLR0915, PLR1714, PLR1730

import micropython


@micropython.viper
def write_frame(crc: int, table: ptr16, data: ptr16, image: ptr8, live: ptr32) -> int:
    """Make a frame of a message, as frames_plain.write_frame does."""
    frame = ptr8(data)
    is_v2 = int(frame[2]) == 0xFD
    length = int(image[4])
    if not is_v2:
        length = int(image[5])
        if image[1] | image[2]:
            raise ValueError("MAVLink 1 has no message ids above 255")
    if length > int(frame[0]):
        raise ValueError("the link is too short for this message")

    left = int(image[6])
    places = ptr16(int(image) + 10)
    payload = ptr8(int(image) + ((13 + 2 * left) & -4))
    while left > 0:
        place = places[0]
        value = live[0]
        target = ptr8(int(payload) + (place >> 3))
        target[0] = value
        if place & 3:
            target[1] = value >> 8
            if place & 2:
                target[2] = value >> 16
                target[3] = value >> 24
        places = ptr16(int(places) + 2)
        live = ptr32(int(live) + 4)
        left -= 1

    target = ptr8(int(frame) + 8)
    if is_v2:
        while length > 4 and payload[length - 1] | payload[length - 2] | payload[length - 3] | payload[length - 4] == 0:
            length -= 4
        while length > 1 and payload[length - 1] == 0:
            length -= 1
        frame[9] = image[0]
        frame[10] = image[1]
        frame[11] = image[2]
        target = ptr8(int(frame) + 12)
    else:
        frame[7] = image[0]
    frame[3] = length
    source = ptr32(payload)
    copy = ptr32(target)
    left = length
    while left > 0:
        copy[0] = source[0]
        source = ptr32(int(source) + 4)
        copy = ptr32(int(copy) + 4)
        left -= 4

    # The byte of the length stands at an odd address, everything after it begins at an even one.
    crc = table[256 + ((crc ^ length) & 0xFF)] ^ (crc >> 8)
    left = int(target) + length - (int(frame) + 4)
    data = ptr16(int(data) + 4)
    while left >= 8:
        crc ^= data[0]
        crc = table[crc & 0xFF] ^ table[256 + (crc >> 8)]
        crc ^= data[1]
        crc = table[crc & 0xFF] ^ table[256 + (crc >> 8)]
        crc ^= data[2]
        crc = table[crc & 0xFF] ^ table[256 + (crc >> 8)]
        crc ^= data[3]
        crc = table[crc & 0xFF] ^ table[256 + (crc >> 8)]
        data = ptr16(int(data) + 8)
        left -= 8
    frame = ptr8(data)
    while left > 0:
        crc = table[256 + ((crc ^ frame[0]) & 0xFF)] ^ (crc >> 8)
        frame = ptr8(int(frame) + 1)
        left -= 1
    crc = table[256 + ((crc ^ image[3]) & 0xFF)] ^ (crc >> 8)
    frame[0] = crc
    frame[1] = crc >> 8
    return length


@micropython.viper
def fill(buffer: ptr8, data: ptr8, state: ptr32, length: int, room: int) -> int:
    """Move data into a receiver's buffer, as frames_plain.fill does."""
    source = ptr8(int(buffer) + state[0])
    left = state[1] - state[0]
    state[0] = 0
    state[1] = left
    target = buffer
    while left > 0:
        target[0] = source[0]
        target = ptr8(int(target) + 1)
        source = ptr8(int(source) + 1)
        left -= 1
    count = length - state[2]
    if count > room - state[1]:
        count = room - state[1]
    if count < 0:
        count = 0
    source = ptr8(int(data) + state[2])
    left = count
    while left > 0:
        target[0] = source[0]
        target = ptr8(int(target) + 1)
        source = ptr8(int(source) + 1)
        left -= 1
    state[1] += count
    state[2] += count
    return count


@micropython.viper
def find_frame(crc: int, table: ptr16, data: ptr8, state: ptr32) -> int:
    """Look for the next frame, as frames_plain.find_frame does."""
    base = int(data)
    at = state[0]
    size = state[1]
    while at < size:
        data = ptr8(base + at)
        magic = int(data[0])
        if magic != 0xFD and magic != 0xFE:
            at += 1
            continue
        length = 10
        if magic == 0xFE:
            length = 6
        if at + length > size:
            break
        signed = 0
        if magic == 0xFD:
            signed = int(data[2])
            if signed > 1:
                state[8] += 1
                at += 1
                continue
        payload = at + length
        length += int(data[1])
        if at + length + 2 + 13 * signed > size:
            break
        state[0] = at + length + 2 + 13 * signed
        state[3] = at
        state[4] = payload
        state[5] = int(data[1])
        state[9] = signed
        if magic == 0xFD:
            state[6] = int(data[7]) | (int(data[8]) << 8) | (int(data[9]) << 16)
        else:
            state[6] = int(data[5])
        data = ptr8(int(data) + 1)
        length -= 1
        if int(data) & 1:
            crc = table[256 + ((crc ^ data[0]) & 0xFF)] ^ (crc >> 8)
            data = ptr8(int(data) + 1)
            length -= 1
        while length >= 4:
            crc ^= ptr16(data)[0]
            crc = table[crc & 0xFF] ^ table[256 + (crc >> 8)]
            crc ^= ptr16(data)[1]
            crc = table[crc & 0xFF] ^ table[256 + (crc >> 8)]
            data = ptr8(int(data) + 4)
            length -= 4
        while length > 0:
            crc = table[256 + ((crc ^ data[0]) & 0xFF)] ^ (crc >> 8)
            data = ptr8(int(data) + 1)
            length -= 1
        state[7] = crc
        return 1
    state[0] = at
    return 0


@micropython.viper
def read_frame(table: ptr16, buffer: ptr8, state: ptr32, image: ptr8, live: ptr32) -> int:
    """Take the found frame over into a message, as frames_plain.read_frame does."""
    left = state[5]
    source = ptr8(int(buffer) + state[4])
    crc = state[7]
    crc = table[256 + ((crc ^ image[3]) & 0xFF)] ^ (crc >> 8)
    if int(source[left]) != crc & 0xFF or int(source[left + 1]) != crc >> 8:
        return 0
    header = ptr8(int(buffer) + state[3])
    if int(header[0]) == 0xFD:
        header = ptr8(int(header) + 2)
    image[7] = header[2]
    image[8] = header[3]
    image[9] = header[4]

    count = int(image[6])
    payload = ptr8(int(image) + ((13 + 2 * count) & -4))
    target = payload
    length = int(image[4])
    if left > length:
        left = length
    length -= left
    while left >= 4:
        target[0] = source[0]
        target[1] = source[1]
        target[2] = source[2]
        target[3] = source[3]
        target = ptr8(int(target) + 4)
        source = ptr8(int(source) + 4)
        left -= 4
    while left > 0:
        target[0] = source[0]
        target = ptr8(int(target) + 1)
        source = ptr8(int(source) + 1)
        left -= 1
    while length > 0:
        target[0] = 0
        target = ptr8(int(target) + 1)
        length -= 1

    places = ptr16(int(image) + 10)
    while count > 0:
        place = places[0]
        target = ptr8(int(payload) + (place >> 3))
        value = int(target[0])
        shift = 24
        if place & 3:
            value |= int(target[1]) << 8
            shift = 16
            if place & 2:
                value |= (int(target[2]) << 16) | (int(target[3]) << 24)
                shift = 0
        if place & 4:
            # The sign stands in the highest bit of the field.
            bits = 1 << (31 - shift)
            value = ((value & (bits + bits - 1)) ^ bits) - bits
        live[0] = value
        places = ptr16(int(places) + 2)
        live = ptr32(int(live) + 4)
        count -= 1
    state[10] += 1
    state[11] += state[9]
    return 1
