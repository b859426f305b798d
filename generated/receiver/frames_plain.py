# Generated from templates/codec/frames_plain.py: do not edit.
# Inputs: c08088e0cdbc30ee
"""Making and reading frames in plain Python: for CPython and for ports without native code.

A message's image is what frames need of it, in one buffer: id (3 bytes, little-endian), CRC_EXTRA, length with and
without extensions, number of live values, and the sequence number, system and component that it came from; from byte 10
the places of the live values, two bytes each (offset * 8 + 4 if signed + size // 2); then, at the next multiple of 4,
the payload.

A link's frame stands two bytes into its buffer, so that the payload begins at a multiple of 4; the first byte of the
buffer is the longest payload that it holds.

A receiver's state is an array: [0] where to look on, [1] end of the received bytes, [2] how many of the data at hand
are taken; of the frame that was found [3] start, [4] payload, [5] length of the payload, [6] message id, [7] checksum
without CRC_EXTRA, [9] whether it is signed; counters of [8] frames with incompatible flags other than that, [10] frames
that were read, [11] signed ones among them.

Each function has few locals: MicroPython puts those of larger ones on the heap at every call.
"""


def write_frame(crc, table, data, image, live):
    """Put the live values into the payload and write its frame into the link's buffer `data`.

    Returns the length of the payload: MAVLink 2 leaves out zeros at the end of it, but never the first byte; MAVLink 1
    sends no extensions. ValueError: the message does not go over this link, by its length or, in MAVLink 1, by its id.
    """
    if data[2] != 0xFD and (image[1] or image[2]):
        raise ValueError("MAVLink 1 has no message ids above 255")
    if image[4 if data[2] == 0xFD else 5] > data[0]:
        raise ValueError("the link is too short for this message")
    _put_live(image, live, 0)
    _put_payload(data, image, _payload(image))
    _put_checksum(crc, table, data, image[3])
    return data[3]


def fill(buffer, data, state, length, room):
    """Move what is left to the buffer's start and add as much of data[:length] as `room` bytes hold.

    Returns how many bytes were added.
    """
    length -= state[2]
    room -= state[1] - state[0]
    if length > room:
        length = room
    if length < 0:
        length = 0
    _move(buffer, state)
    return _append(buffer, data, state, length)


def find_frame(crc, table, data, state):
    """Look for the next whole frame and describe it in `state`; return whether there is one."""
    while state[0] < state[1]:
        if data[state[0]] != 0xFD and data[state[0]] != 0xFE:
            state[0] += 1
            continue
        _describe(state, data, state[0], 10 if data[state[0]] == 0xFD else 6)
        if state[9] > 1:
            state[8] += 1
            state[0] += 1
            continue
        if state[4] + state[5] + 2 + 13 * state[9] > state[1]:
            return 0
        state[0] = state[4] + state[5]
        state[7] = _checksum(crc, table, data, state[3] + 1, state[0])
        state[0] += 2 + 13 * state[9]
        return 1
    return 0


def read_frame(table, buffer, state, image, live):
    """Take the found frame over into a message and its live values; return whether its checksum was right.

    Zeros stand in for a truncated end, newer extensions than the message's own are left out.
    """
    if not _is_intact(table, buffer, state, image[3]):
        return 0
    _take_source(image, buffer, state[3])
    _take_payload(image, _payload(image), buffer, state)
    _take_live(image, live, 0)
    state[10] += 1
    state[11] += state[9]
    return 1


def _move(buffer, state):
    _copy(buffer, 0, buffer, state[0], state[1] - state[0])
    state[1] -= state[0]
    state[0] = 0


def _append(buffer, data, state, count):
    _copy(buffer, state[1], data, state[2], count)
    state[1] += count
    state[2] += count
    return count


def _payload(image):
    return (13 + 2 * image[6]) & -4


def _place(image, index):
    return image[10 + 2 * index] | (image[11 + 2 * index] << 8)


def _put_live(image, live, index):
    while index < image[6]:
        _put(image, _payload(image) + (_place(image, index) >> 3), _place(image, index) & 3, live[index])
        index += 1


def _put(image, at, size, value):
    image[at] = value & 0xFF
    if size:
        image[at + 1] = (value >> 8) & 0xFF
        if size == 2:
            image[at + 2] = (value >> 16) & 0xFF
            image[at + 3] = (value >> 24) & 0xFF


def _put_payload(data, image, payload):
    if data[2] == 0xFD:
        data[3] = image[4]
        while data[3] > 1 and image[payload + data[3] - 1] == 0:
            data[3] -= 1
        _copy(data, 9, image, 0, 3)
        _copy(data, 12, image, payload, data[3])
    else:
        data[3] = image[5]
        data[7] = image[0]
        _copy(data, 8, image, payload, data[3])


def _put_checksum(crc, table, data, extra):
    end = data[3] + (12 if data[2] == 0xFD else 8)
    crc = _checksum(crc, table, data, 3, end)
    crc = table[256 + ((crc ^ extra) & 0xFF)] ^ (crc >> 8)
    data[end] = crc & 0xFF
    data[end + 1] = crc >> 8


def _describe(state, data, at, header):
    state[3] = at
    state[4] = at + header
    if at + header > state[1]:
        state[5] = state[9] = 0
        return
    state[5] = data[at + 1]
    if header == 6:
        state[6] = data[at + 5]
        state[9] = 0
    else:
        state[6] = data[at + 7] | (data[at + 8] << 8) | (data[at + 9] << 16)
        state[9] = data[at + 2]


def _is_intact(table, buffer, state, extra):
    crc = state[7]
    crc = table[256 + ((crc ^ extra) & 0xFF)] ^ (crc >> 8)
    end = state[4] + state[5]
    return buffer[end] == crc & 0xFF and buffer[end + 1] == crc >> 8


def _take_source(image, buffer, at):
    _copy(image, 7, buffer, at + (4 if buffer[at] == 0xFD else 2), 3)


def _take_payload(image, payload, buffer, state):
    length = image[4]
    if state[5] < length:
        _clear(image, payload + state[5], payload + length)
        length = state[5]
    _copy(image, payload, buffer, state[4], length)


def _take_live(image, live, index):
    while index < image[6]:
        live[index] = _value(image, _payload(image) + (_place(image, index) >> 3), _place(image, index))
        index += 1


def _value(image, at, place):
    value = image[at]
    sign = 0x80
    if place & 3:
        value |= image[at + 1] << 8
        sign = 0x8000
        if place & 2:
            # The highest byte brings the sign: so nothing grows beyond 32 bits.
            sign = image[at + 3]
            return value | (image[at + 2] << 16) | ((sign - 256 if sign & 0x80 else sign) << 24)
    return (value ^ sign) - sign if place & 4 else value


def _copy(target, at, source, start, count):
    count += start
    while start < count:
        target[at] = source[start]
        at += 1
        start += 1


def _clear(target, at, end):
    while at < end:
        target[at] = 0
        at += 1


def _checksum(crc, table, data, at, end):
    while at < end:
        crc = table[256 + ((crc ^ data[at]) & 0xFF)] ^ (crc >> 8)
        at += 1
    return crc
