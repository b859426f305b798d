# Generated from templates/codec/frames_viper.py: do not edit.
# Inputs: 101cb6339706a4c6
"""Making and reading frames in machine code, by MicroPython's viper emitter; frames_plain describes what each does.

Looking up an attribute takes as long as the checksum of eight bytes, and so does asking an object where its bytes are.
So the functions of a link are closures, and what they find there of its buffers is their addresses: numbers, which stay
right because MicroPython moves nothing, as long as somebody holds the buffer. Viper checks no bounds: the callers do.
All that is read or written in steps of two or four bytes lies at a multiple of that, which the smaller Cortex-M insist
on.
"""

# Calls are dear and few; ptr8, ptr16 and ptr32 are viper's own names.
# ruff: noqa: C901, F821, PLR0912, PLR0915

from array import array

import micropython
from checksum import TABLE


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
            while not words[0]:
                words = ptr32(int(words) - 4)
            last = ptr8(int(words) + 3)
            while not last[0]:
                last = ptr8(int(last) - 1)
            length = int(last) - int(payload) + 1
            if not length and int(image[4]):
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
        crc ^= data[0]  # the next two bytes are in it already
        left = (end - int(data)) >> 3
        while left:
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[1]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[2]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[3]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[4]
            data = ptr16(int(data) + 8)
            left -= 1
        if (end - int(data)) & 4:
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[1]
            crc = low[crc & 0xFF] ^ high[crc >> 8] ^ data[2]
            data = ptr16(int(data) + 4)
        crc ^= data[0]
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

    Variables of a closure and its arguments are five at most: more would take memory at each call. It names nothing of
    this module, as encode() does not.
    """
    state_at = address(receiver._state)
    keep_address(receiver._state, 19, receiver._buffer)
    kind, length_of = bytes, len  # found here, they are found sooner than among the built-in names

    @micropython.viper
    def put(data):
        state = ptr32(int(state_at))
        left = int(state[17])
        if state[12] or not left:
            if not state[12] and data.__class__ is kind:
                left = int(length_of(data))
            else:
                receiver._put_more(data)
                return
        # Move the rest to the front.
        target = ptr8(int(state[19]) | int(state[20]) << 32)
        source = ptr8(int(target) + int(state[0]))
        kept = int(state[1]) - int(state[0])
        state[0] = 0
        room = kept
        while room:
            target[0] = source[0]
            target = ptr8(int(target) + 1)
            source = ptr8(int(source) + 1)
            room -= 1
        room = int(state[13]) - kept
        left -= int(state[2])
        source = ptr8(data)
        source = ptr8(int(source) + int(state[2]))
        if left > room:
            left = room
            receiver._arrived[0] = data
            state[12] = 1
            state[2] = int(state[2]) + left
        else:
            state[2] = 0
            state[17] = 0
        state[1] = kept + left
        end = int(target) + left
        if not (int(source) | int(target)) & 3:
            # Of 16 bytes the last ones may lie behind it: the buffer has room for them, and the heap consists of such.
            words = ptr32(target)
            others = ptr32(source)
            while int(words) < end:
                words[0] = others[0]
                words[1] = others[1]
                words[2] = others[2]
                words[3] = others[3]
                words = ptr32(int(words) + 16)
                others = ptr32(int(others) + 16)
            return
        while int(target) < end:
            target[0] = source[0]
            target = ptr8(int(target) + 1)
            source = ptr8(int(source) + 1)

    return put


def _rows(messages, own):
    """Return rows in which machine code finds the messages that are used again, and put these into a list.

    A row has the id and 1, the address of the image (2 words) and the place in the list. It is the one that the lowest
    bits of the id name, or else, where others have the same, one behind it. Behind the last one is a row of zeros.
    """
    again = [message for message in messages.values() if message is not False]
    size = 1
    while size < 2 * len(again):
        size *= 2
    rows = array("i", [0] * (4 * (size + len(again))))
    for message in again:
        at = 4 * (message.ID & (size - 1))
        while rows[at]:
            at += 4
        rows[at] = message.ID + 1
        keep_address(rows, at + 1, message._image)
        rows[at + 3] = len(own)
        own.append(message)
    return rows, size - 1


def decoder(receiver):
    """Return the function receive() of a receiver, as frames_plain.decoder does; it holds the receiver."""
    own = [receiver, receiver._messages.get, None]
    rows, mask = _rows(receiver._messages, own)
    own.append(rows)
    state_at = address(receiver._state)
    keep_address(receiver._state, 19, receiver._buffer)
    keep_address(receiver._state, 21, TABLE)
    keep_address(receiver._state, 26, rows)
    receiver._state[28] = mask

    @micropython.viper
    def receive():
        crc: int  # the first variable has a register
        state = ptr32(int(state_at))
        base = int(state[19]) | int(state[20]) << 32
        while True:
            start = ptr8(base + int(state[0]))
            end = base + int(state[1])
            stop = end
            if state[16]:
                left = int(state[16]) - int(state[15])
                if left <= 0 and int(start) < end:
                    return None
                if end > int(start) + left:
                    stop = int(start) + left
            while int(start) < stop and int(start[0]) != 0xFD and int(start[0]) != 0xFE:
                start = ptr8(int(start) + 1)
            at = int(start) - base
            if state[16]:
                state[15] = int(state[15]) + at - int(state[0])
            if int(start) == stop and stop < end:
                state[0] = at
                continue
            if int(start[0]) == 0xFD:
                header = 10
                number = int(start[7]) | (int(start[8]) << 8) | (int(start[9]) << 16)
                signed = int(start[2])
                sender = ptr8(int(start) + 4)
            else:
                header = 6
                number = int(start[5])
                signed = 0
                sender = ptr8(int(start) + 2)
            if int(start) + header > end:
                state[0] = at
                if not state[12]:
                    return None
                own[0]._refill()
                continue

            if signed > 1:
                state[8] = int(state[8]) + 1
                state[0] = at + 1
                if state[16]:
                    state[15] = int(state[15]) + 8
                continue
            row = ptr32((int(state[26]) | int(state[27]) << 32) + ((number & int(state[28])) << 4))
            left = number + 1
            while int(row[0]) != left and row[0]:
                row = ptr32(int(row) + 16)
            if row[0]:
                message = own[row[3]]
            else:
                message = own[1](number)
                if message is own[2]:
                    state[18] = int(state[18]) + 1
                    state[0] = at + 1
                    if state[16]:
                        state[15] = int(state[15]) + 8
                    continue
            length = int(start[1])
            source = ptr8(int(start) + 1)
            stop = int(start) + header + length  # of the payload
            left = stop + 2 + 13 * signed
            if left > end:
                state[0] = at
                if not state[12]:
                    return None
                own[0]._refill()
                continue

            state[0] = left - base
            state[3] = at
            state[4] = at + header
            state[5] = length
            state[6] = number
            state[9] = signed
            if state[16]:
                state[15] = int(state[15]) + header + length
            low = ptr16(int(state[21]) | int(state[22]) << 32)
            high = ptr16(int(low) + 512)
            crc = 0xFFFF
            if int(source) & 1:
                crc = high[(crc ^ source[0]) & 0xFF] ^ 0xFF
                source = ptr8(int(source) + 1)
            pairs = ptr16(source)
            crc ^= pairs[0]  # as above; behind the last byte stands the checksum of the frame
            left = stop - 7
            while int(pairs) < left:
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[1]
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[2]
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[3]
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[4]
                pairs = ptr16(int(pairs) + 8)
            left = stop - 1
            while int(pairs) < left:
                crc = low[crc & 0xFF] ^ high[crc >> 8] ^ pairs[1]
                pairs = ptr16(int(pairs) + 2)
            crc ^= pairs[0]
            source = ptr8(pairs)
            if int(source) < stop:
                crc = high[(crc ^ source[0]) & 0xFF] ^ (crc >> 8)
                source = ptr8(int(source) + 1)
            state[7] = crc

            if row[0] and not state[14]:
                image = ptr8(int(row[1]) | int(row[2]) << 32)
            else:
                message = own[0]._admitted(message)
                if message is own[2]:
                    continue
                image = ptr8(message._image)
            crc = high[(crc ^ image[3]) & 0xFF] ^ (crc >> 8)
            if int(source[0]) | int(source[1]) << 8 != crc:
                own[0]._look_within()
                continue

            # Zeros stand in for a truncated end, newer extensions are left out.
            payload = ptr8(int(image) + 4 * int(image[13]))
            left = int(image[4])
            if length < left:
                words = ptr32(int(payload) + (length & -4))
                end = int(payload) + left
                while int(words) < end:
                    words[0] = 0
                    words = ptr32(int(words) + 4)
                left = length
            target = payload
            end = int(target) + left
            source = ptr8(int(start) + header)
            if not int(source) & 1:
                halves = ptr16(target)
                pairs = ptr16(source)
                stop = end - 7
                while int(halves) < stop:
                    halves[0] = pairs[0]
                    halves[1] = pairs[1]
                    halves[2] = pairs[2]
                    halves[3] = pairs[3]
                    halves = ptr16(int(halves) + 8)
                    pairs = ptr16(int(pairs) + 8)
                target = ptr8(halves)
                source = ptr8(pairs)
            while int(target) < end:
                target[0] = source[0]
                target = ptr8(int(target) + 1)
                source = ptr8(int(source) + 1)
            image[6] = sender[0]
            image[7] = sender[1]
            image[8] = sender[2]
            state[23] = int(sender[1]) << 8 | int(sender[2])
            state[24] = int(payload)
            state[25] = int(payload) >> 32

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
            state[10] = int(state[10]) + 1
            state[11] = int(state[11]) + signed
            return message

    return receive
