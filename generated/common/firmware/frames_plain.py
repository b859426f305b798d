# Generated from templates/codec/frames_plain.py: do not edit.
# Inputs: d05587181b7d678f
"""Making and reading frames in plain Python: for CPython and for ports without native code.

A message's image is what frames need of it, in one buffer: [0] id (3 bytes, little-endian), [3] CRC_EXTRA, [4] length
with and [5] without extensions; [6] sequence number, [7] system and [8] component that it came from; of the live values
[9] how many are words of 4 bytes at a multiple of 4, [10] unsigned and [11] signed half-words at a multiple of 2, and
[12] others; [13] start of the payload / 4. From byte 14 on stands where each live value belongs: for words and
half-words place / size and index in `live`, for the others place, index, and size + 8 if signed. The byte before the
payload is 1, so that who looks for the last byte that is not zero finds one; behind the payload are zeros up to a
multiple of 16 bytes, which is read and copied at once.

A link's frame stands two bytes into its buffer, so that the payload begins at a multiple of 4; the first byte of the
buffer is the longest payload that it holds, the second one the length up to which each has its view. In the 8 bytes in
front of the buffer machine code finds where the table of the checksum is. Of 16 bytes that are copied the last 15 may
lie behind the payload.

A receiver's state is an array: [0] where to look on, [1] end of the received bytes; [12] whether data are kept that
did not find room, and [2] how many of them are taken; [13] size of the buffer, [14] whether signatures count; of the
frame that was found [3] start, [4] payload, [5] length of the payload, [6] message id, [7] checksum without CRC_EXTRA,
[9] whether it is signed; counters of [8] frames with incompatible flags other than that, [10] frames that were read,
[11] signed ones among them, [18] frames of other messages. Who puts in bytes of which only the first ones count sets
[17], how many these are; receive() has to have read all before them. Who wants to be asked for more time sets [16], how
many bytes may be looked at until receive() returns None though there are more, and [15], how many of them were, to 0.
Of the message that was received last [23] is its sender, system << 8 | component, and in machine code [24] the address
of its payload; there [19], [21] and [26] are the addresses of the buffer, of the table and of the rows in which
messages are found by their ids, 64 bits each, and [28] is which bits of an id say where to begin. Behind the received
bytes the buffer has room for 15 more.

Each function has few locals: MicroPython puts those of larger ones on the heap at every call.
"""

from checksum import TABLE


def address(_data):
    """Return 0: only machine code goes to bytes by their address."""
    return 0


def encoder(frame, views, new_view):
    """Return the function encode(message), which puts the live values into the message's payload and makes its frame.

    `frame` is the link's buffer, and `views` has what encode() returns, by the length of the payload: MAVLink 2 leaves
    out zeros at the end of it, but never the first byte; MAVLink 1 sends no extensions. Of a length that may have no
    view yet, it returns new_view(length). ValueError: the message does not go over this link, by its length or, in
    MAVLink 1, by its id.
    """

    def encode(message):
        length = _write_frame(frame, message._image, message.live)
        return new_view(length) if length > frame[1] else views[length]

    return encode


def taker(receiver):
    """Return the function put(data), which takes as much of what arrived into a receiver's buffer as that holds.

    The receiver keeps the rest. Its _put_more() is asked if there already is such a rest, and for all but bytes if
    nobody says how many of them count.
    """

    def put(data):
        if receiver._state[12] or (receiver._state[17] == 0 and type(data) is not bytes):
            receiver._put_more(data)
        else:
            _take_in(receiver, receiver._state, receiver._buffer, data)

    return put


def decoder(receiver):
    """Return the function receive(), which returns the next message of what has arrived at a receiver, or None.

    Zeros stand in for a truncated end, newer extensions than the message's own are left out. The receiver's
    _admitted() is asked where a message has to be made, or signatures count, _look_within() is told of a wrong
    checksum. What looks like a frame of another message is not waited for, nor is it a frame that hides others.
    """

    def receive():
        while _find_frame(receiver, receiver._state, receiver._buffer):
            message = receiver._messages[receiver._state[6]]
            if message is False or receiver._state[14]:
                message = receiver._admitted(message)
            if message is not None:
                if _read_frame(receiver._buffer, receiver._state, message._image, message.live):
                    receiver._state[23] = message._image[7] << 8 | message._image[8]
                    return message
                receiver._look_within()
        return None

    return receive


def _write_frame(data, image, live):
    if data[2] != 0xFD and (image[1] or image[2]):
        raise ValueError("MAVLink 1 has no message ids above 255")
    if image[4 if data[2] == 0xFD else 5] > data[0]:
        raise ValueError("the link is too short for this message")
    _put_live(image, live)
    _put_payload(data, image, 4 * image[13])
    _put_checksum(data, image[3])
    return data[3]


def _put_live(image, live):
    at = 14
    end = at + 2 * image[9]
    while at < end:
        _put(image, at, 4, 4, live)
        at += 2
    end += 2 * (image[10] + image[11])
    while at < end:
        _put(image, at, 2, 2, live)
        at += 2
    end += 3 * image[12]
    while at < end:
        _put(image, at, 1, image[at + 2] & 7, live)
        at += 3


def _put(image, at, unit, size, live):
    value = live[image[at + 1]]
    at = 4 * image[13] + unit * image[at]
    while size:
        image[at] = value & 0xFF
        value >>= 8
        at += 1
        size -= 1


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


def _put_checksum(data, extra):
    end = data[3] + (12 if data[2] == 0xFD else 8)
    crc = _checksum(TABLE, data, 3, end)
    crc = TABLE[256 + ((crc ^ extra) & 0xFF)] ^ (crc >> 8)
    data[end] = crc & 0xFF
    data[end + 1] = crc >> 8


def _find_frame(receiver, state, buffer):
    """Look for the next whole frame, taking in what is kept when there is none, and describe it in the state."""
    while True:
        while state[0] < state[1]:
            if state[16] and state[15] >= state[16]:
                return False
            if buffer[state[0]] != 0xFD and buffer[state[0]] != 0xFE:
                _pass_over(state, 1)
                continue
            _describe(state, buffer, state[0], 10 if buffer[state[0]] == 0xFD else 6)
            if state[4] > state[1]:
                break
            if _is_other(state, receiver._messages):
                _pass_over(state, 8)
                continue
            if state[4] + state[5] + 2 + 13 * state[9] > state[1]:
                break
            state[0] = state[4] + state[5]
            state[7] = _checksum(TABLE, buffer, state[3] + 1, state[0])
            _count(state)
            state[0] += 2 + 13 * state[9]
            return True
        if not state[12]:
            return False
        receiver._refill()


def _is_other(state, messages):
    """Count a frame that is not for this receiver; return whether it is one."""
    if state[9] > 1:
        state[8] += 1
        return True
    if state[6] not in messages:
        state[18] += 1
        return True
    return False


def _count(state):
    if state[16]:
        state[15] += state[0] - state[3]


def _pass_over(state, work):
    """Look on behind a byte; `work` is how many bytes that counts as."""
    state[0] += 1
    if state[16]:
        state[15] += work


def _take_in(receiver, state, buffer, data):
    """Take in data behind what is left, which goes to the front."""
    _move(buffer, state)
    if _left(data, state) > state[13] - state[1]:
        receiver._arrived[0] = data
        state[12] = 1
        _append(buffer, data, state, state[13] - state[1])
    else:
        _append(buffer, data, state, _left(data, state))
        state[2] = state[17] = 0


def _left(data, state):
    return (state[17] or len(data)) - state[2]


def _move(buffer, state):
    _copy(buffer, 0, buffer, state[0], state[1] - state[0])
    state[1] -= state[0]
    state[0] = 0


def _append(buffer, data, state, count):
    _copy(buffer, state[1], data, state[2], count)
    state[1] += count
    state[2] += count


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


def _read_frame(buffer, state, image, live):
    if not _is_intact(buffer, state, image[3]):
        return False
    _take_source(image, buffer, state[3])
    _take_payload(image, 4 * image[13], buffer, state)
    _take_live(image, live)
    state[10] += 1
    state[11] += state[9]
    return True


def _take_source(image, buffer, at):
    _copy(image, 6, buffer, at + (4 if buffer[at] == 0xFD else 2), 3)


def _is_intact(buffer, state, extra):
    crc = state[7]
    crc = TABLE[256 + ((crc ^ extra) & 0xFF)] ^ (crc >> 8)
    end = state[4] + state[5]
    return buffer[end] == crc & 0xFF and buffer[end + 1] == crc >> 8


def _take_payload(image, payload, buffer, state):
    length = image[4]
    if state[5] < length:
        _clear(image, payload + state[5], payload + length)
        length = state[5]
    _copy(image, payload, buffer, state[4], length)


def _take_live(image, live):
    at = 14
    end = at + 2 * image[9]
    while at < end:
        _take(image, at, 4, 12, live)
        at += 2
    end += 2 * image[10]
    while at < end:
        _take(image, at, 2, 2, live)
        at += 2
    end += 2 * image[11]
    while at < end:
        _take(image, at, 2, 10, live)
        at += 2
    end += 3 * image[12]
    while at < end:
        _take(image, at, 1, image[at + 2], live)
        at += 3


def _take(image, at, unit, form, live):
    live[image[at + 1]] = _value(image, 4 * image[13] + unit * image[at], form)


def _value(image, at, form):
    end = at + (form & 7) - 1
    # The highest byte brings the sign, that of 4 bytes always: so nothing grows beyond 32 bits.
    value = image[end]
    if form & 12 and value & 0x80:
        value -= 256
    while end > at:
        end -= 1
        value = value << 8 | image[end]
    return value


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


def _checksum(table, data, at, end):
    crc = 0xFFFF
    while at < end:
        crc = table[256 + ((crc ^ data[at]) & 0xFF)] ^ (crc >> 8)
        at += 1
    return crc
