# Generated from templates/codec/frames_viper.py: do not edit.
# Inputs: 2a7c0b032d293efe
"""Making and reading frames in machine code, by MicroPython's viper emitter; frames_plain describes what each does.

Looking up an attribute takes as long as the checksum of eight bytes, and so does asking an object where its bytes are.
So the functions of a link are closures, and what they find there of its buffers is their addresses: numbers, which stay
right because MicroPython moves nothing, as long as somebody holds the buffer. Viper checks no bounds: the callers do.
All that is read or written in steps of two or four bytes lies at a multiple of that, which the smaller Cortex-M insist
on.
"""

# Calls are dear and few; ptr8, ptr16 and ptr32 are viper's own names.
# ruff: noqa: C901, F821, PLR0912, PLR0915

import micropython
from checksum import TABLE

_bytes, _bytearray = bytes, bytearray
_BYTES = (bytes, bytearray, memoryview)


@micropython.viper
def address(data: ptr8) -> int:
    """Return where the bytes of a buffer are. It stays right as long as somebody holds the buffer."""
    return int(data)


@micropython.viper
def keep_address(words: ptr32, place: int, data: ptr8):
    """Write the address of a buffer into two words; on 32 bits nothing of it stands in the second that harms."""
    words[place] = int(data)
    words[place + 1] = int(data) >> 32


def _refuse(words):
    raise ValueError(words)


def encoder(frame, views, new_view):
    """Return the function encode(message) of a link, as frames_plain.encoder does; the views hold the frame.

    It names nothing of this module: a function that does takes 240 instructions more at each call. It has four names
    from here: a function with five is called by way of the heap.
    """
    frame_at = address(frame)
    refuse = _refuse

    @micropython.viper
    def encode(message):
        image = ptr8(message._image)
        frame = ptr8(int(frame_at))
        is_v2 = int(frame[2]) == 0xFD
        length = int(image[4])
        if not is_v2:
            length = int(image[5])
            if image[1] | image[2]:
                refuse("MAVLink 1 has no message ids above 255")
        if length > int(frame[0]):
            refuse("the link is too short for this message")

        payload = ptr8(int(image) + 4 * int(image[13]))
        words = ptr32(payload)
        # Places in the payload, and of the values for them, come in pairs.
        place = ptr8(int(image) + 14)
        end = int(place) + 2 * int(image[9])
        live = words
        if image[9] | image[10] | image[11] | image[12]:
            live = ptr32(message.live)
        while int(place) < end:
            words[place[0]] = live[place[1]]
            place = ptr8(int(place) + 2)
        end += 2 * (int(image[10]) + int(image[11]))
        halves = ptr16(payload)
        while int(place) < end:
            halves[place[0]] = live[place[1]]
            place = ptr8(int(place) + 2)
        end += 3 * int(image[12])
        while int(place) < end:
            value = live[place[1]]
            target = ptr8(int(payload) + int(place[0]))
            target[0] = value
            left = (int(place[2]) & 7) - 1
            while left:
                value >>= 8
                target = ptr8(int(target) + 1)
                target[0] = value
                left -= 1
            place = ptr8(int(place) + 3)

        if is_v2:
            # Before the payload stands a 1, so that both loops end.
            words = ptr32(int(payload) + ((length - 1) & -4))
            while words[0] == 0:
                words = ptr32(int(words) - 4)
            last = ptr8(int(words) + 3)
            while last[0] == 0:
                last = ptr8(int(last) - 1)
            length = int(last) - int(payload) + 1
            if length == 0 and int(image[4]):
                length = 1
            frame[9] = image[0]
            frame[10] = image[1]
            frame[11] = image[2]
            target = ptr8(int(frame) + 12)
            words = ptr32(payload)
        else:
            frame[7] = image[0]
            target = ptr8(int(frame) + 8)
        frame[3] = length
        end = int(target) + length
        copy = ptr32(target)
        while int(copy) < end:
            copy[0] = words[0]
            copy[1] = words[1]
            copy[2] = words[2]
            copy[3] = words[3]
            words = ptr32(int(words) + 16)
            copy = ptr32(int(copy) + 16)

        # The byte of the length stands at an odd address, everything after it begins at an even one.
        words = ptr32(int(frame) - 8)
        low = ptr16(words[0] | words[1] << 32)
        high = ptr16(int(low) + 512)
        crc = high[0xFF ^ length] ^ 0xFF
        data = ptr16(int(frame) + 4)
        left = (end - int(data)) >> 3
        while left:
            crc ^= data[0]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[1]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[2]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[3]
            crc = low[crc & 0xFF] ^ high[crc >> 8]
            data = ptr16(int(data) + 8)
            left -= 1
        if (end - int(data)) & 4:
            crc ^= data[0]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[1]
            crc = low[crc & 0xFF] ^ high[crc >> 8]
            data = ptr16(int(data) + 4)
        last = ptr8(data)
        while int(last) < end:
            crc = high[(crc ^ last[0]) & 0xFF] ^ (crc >> 8)
            last = ptr8(int(last) + 1)
        crc = high[(crc ^ image[3]) & 0xFF] ^ (crc >> 8)
        last[0] = crc
        last[1] = crc >> 8
        if length > int(frame[1]):
            return new_view(length)
        return views[length]

    return encode


def taker(receiver):
    """Return the function put(data) of a receiver, as frames_plain.taker does; it holds the receiver.

    Variables of a closure and its arguments are five at most: more would take memory at each call.
    """
    state_at = address(receiver._state)
    keep_address(receiver._state, 19, receiver._buffer)
    kind_of, length_of = type, len  # found here, they are found sooner than among the built-in names

    @micropython.viper
    def put(data):
        state = ptr32(int(state_at))
        left = int(state[17])
        if state[12] or left == 0:
            kind = kind_of(data)
            if state[12] or (kind is not _bytes and kind is not _bytearray and kind not in _BYTES):
                receiver._put_more(data)
                return
            left = int(length_of(data))
        # What is left goes to the front.
        target = ptr8(int(state[19]) | int(state[20]) << 32)
        source = ptr8(int(target) + int(state[0]))
        room = int(state[1]) - int(state[0])
        state[0] = 0
        state[1] = room
        while room:
            target[0] = source[0]
            target = ptr8(int(target) + 1)
            source = ptr8(int(source) + 1)
            room -= 1
        room = int(state[13]) - int(state[1])
        left -= int(state[2])
        source = ptr8(data)
        source = ptr8(int(source) + int(state[2]))
        if left > room:
            left = room
            receiver._arrived[0] = data
            state[12] = 1
            state[2] += left
        else:
            state[2] = 0
            state[17] = 0
        state[1] += left
        if (int(source) | int(target)) & 3 == 0:
            # The last word may be a part of one: the buffer ends with a whole one, and so does what is on the heap.
            words = ptr32(target)
            while left > 4:
                words[0] = ptr32(source)[0]
                words[1] = ptr32(source)[1]
                words = ptr32(int(words) + 8)
                source = ptr8(int(source) + 8)
                left -= 8
            if left > 0:
                words[0] = ptr32(source)[0]
            return
        while left:
            target[0] = source[0]
            target = ptr8(int(target) + 1)
            source = ptr8(int(source) + 1)
            left -= 1

    return put


def decoder(receiver):
    """Return the function receive() of a receiver, as frames_plain.decoder does; it holds the receiver."""
    state_at = address(receiver._state)
    keep_address(receiver._state, 19, receiver._buffer)
    keep_address(receiver._state, 21, TABLE)
    known = receiver._messages.get
    none, made = None, False  # viper compares an object with objects only

    @micropython.viper
    def receive():
        state = ptr32(int(state_at))
        base = int(state[19]) | int(state[20]) << 32
        low = ptr16(int(state[21]) | int(state[22]) << 32)
        high = ptr16(int(low) + 512)
        while True:
            at = int(state[0])
            size = int(state[1])
            if state[16]:
                left = int(state[16]) - int(state[15])
                if left <= 0 and at < size:
                    return None
                if size > at + left:  # noqa: PLR1730  viper has no min()
                    size = at + left
            start = ptr8(base)
            header = 0
            while at < size and header == 0:
                start = ptr8(base + at)
                if int(start[0]) == 0xFD:
                    header = 10
                elif int(start[0]) == 0xFE:
                    header = 6
                else:
                    at += 1
            if state[16]:
                state[15] += at - int(state[0])
            state[0] = at
            size = int(state[1])
            if at + header > size or header == 0:
                if header == 0 and at < size:
                    continue
                if state[12] == 0:
                    return None
                receiver._refill()
                continue

            number = int(start[5])
            signed = 0
            if header == 10:
                number = int(start[7]) | (int(start[8]) << 8) | (int(start[9]) << 16)
                signed = int(start[2])
                if signed > 1:
                    state[8] += 1
                    state[0] = at + 1
                    if state[16]:
                        state[15] += 8
                    continue
            message = known(number)
            if message is none:
                state[18] += 1
                state[0] = at + 1
                if state[16]:
                    state[15] += 8
                continue
            length = int(start[1])
            whole = header + length + 2 + 13 * signed
            if at + whole > size:
                if state[12] == 0:
                    return None
                receiver._refill()
                continue

            state[0] = at + whole
            state[3] = at
            state[4] = at + header
            state[5] = length
            state[6] = number
            state[9] = signed
            if state[16]:
                state[15] += header + length
            crc = 0xFFFF
            left = header + length - 1
            source = ptr8(int(start) + 1)
            if int(source) & 1:
                crc = high[(crc ^ source[0]) & 0xFF] ^ (crc >> 8)
                source = ptr8(int(source) + 1)
                left -= 1
            pairs = ptr16(source)
            while left > 7:
                crc ^= pairs[0]
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[1]
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[2]
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[3]
                crc = low[crc & 0xFF] ^ high[crc >> 8]
                pairs = ptr16(int(pairs) + 8)
                left -= 8
            while left > 1:
                crc ^= pairs[0]
                crc = low[crc & 0xFF] ^ high[crc >> 8]
                pairs = ptr16(int(pairs) + 2)
                left -= 2
            source = ptr8(pairs)
            if left:
                crc = high[(crc ^ source[0]) & 0xFF] ^ (crc >> 8)
                source = ptr8(int(source) + 1)
            state[7] = crc

            if state[14] or message is made:
                message = receiver._admitted(message)
                if message is none:
                    continue
            image = ptr8(message._image)
            crc = high[(crc ^ image[3]) & 0xFF] ^ (crc >> 8)
            if int(source[0]) != crc & 0xFF or int(source[1]) != crc >> 8:
                receiver._look_within()
                continue

            # Zeros stand in for a truncated end, newer extensions are left out.
            payload = ptr8(int(image) + 4 * int(image[13]))
            left = int(image[4])
            if length < left:
                words = ptr32(int(payload) + (length & -4))
                count = ((left + 3) >> 2) - (length >> 2)
                while count:
                    words[0] = 0
                    words = ptr32(int(words) + 4)
                    count -= 1
                left = length
            source = ptr8(int(start) + header)
            target = payload
            if int(source) & 1 == 0:
                halves = ptr16(target)
                pairs = ptr16(source)
                while left > 7:
                    halves[0] = pairs[0]
                    halves[1] = pairs[1]
                    halves[2] = pairs[2]
                    halves[3] = pairs[3]
                    halves = ptr16(int(halves) + 8)
                    pairs = ptr16(int(pairs) + 8)
                    left -= 8
                target = ptr8(halves)
                source = ptr8(pairs)
            while left:
                target[0] = source[0]
                target = ptr8(int(target) + 1)
                source = ptr8(int(source) + 1)
                left -= 1
            if header == 10:
                start = ptr8(int(start) + 2)
            image[6] = start[2]
            image[7] = start[3]
            image[8] = start[4]

            if image[9] | image[10] | image[11] | image[12]:
                live = ptr32(message.live)
                place = ptr8(int(image) + 14)
                words = ptr32(payload)
                left = int(image[9])
                while left:
                    live[place[1]] = words[place[0]]
                    place = ptr8(int(place) + 2)
                    left -= 1
                halves = ptr16(payload)
                left = int(image[10])
                while left:
                    live[place[1]] = halves[place[0]]
                    place = ptr8(int(place) + 2)
                    left -= 1
                left = int(image[11])
                while left:
                    live[place[1]] = (int(halves[place[0]]) ^ 0x8000) - 0x8000
                    place = ptr8(int(place) + 2)
                    left -= 1
                left = int(image[12])
                while left:
                    source = ptr8(int(payload) + int(place[0]))
                    size = int(place[2]) & 7
                    value = 0
                    bits = 0
                    while size:
                        value |= int(source[0]) << bits
                        bits += 8
                        source = ptr8(int(source) + 1)
                        size -= 1
                    if int(place[2]) & 8 and bits < 32:
                        # The sign stands in the highest bit of the field.
                        bits = 1 << (bits - 1)
                        value = (value ^ bits) - bits
                    live[place[1]] = value
                    place = ptr8(int(place) + 3)
                    left -= 1
            state[10] += 1
            state[11] += signed
            return message

    return receive
