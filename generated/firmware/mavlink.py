# Generated from templates/firmware/mavlink.py: do not edit.
# Inputs: 8239de74e17e4c75
"""MAVLink 1 and 2: the messages' base class, and the link that makes and reads frames.

Sending allocates nothing once a link exists: its frame is written in place, and a view of every length of it is
made beforehand.
"""

import fields
from crc import START, TABLE, is_entry, update, write_frame

MAGIC_1 = 0xFE
MAGIC_2 = 0xFD
HEADER_1 = 6  # magic, length, sequence, system, component, id
HEADER_2 = 10  # magic, length, incompatible flags, compatible flags, sequence, system, component, id in 3 bytes
CHECKSUM = 2
SIGNATURE = 13
SIGNED = 0x01  # incompatible flag: a signature follows the checksum
LONGEST_PAYLOAD = 255


class Message:
    """One message; messages.py derives a class for each.

    `payload` holds the fields in wire order, without truncation. A field that is not called like something of this
    class can be read as an attribute; attributes do not write, set() does. `system_id`, `component_id` and
    `sequence` tell where a received message comes from.
    """

    NAME = ""
    ID = 0
    CRC_EXTRA = 0
    BASE_LENGTH = 0  # bytes of payload without extension fields: all that MAVLink 1 sends
    LENGTH = 0
    FIELDS = {}  # name: (struct code, offset, count), see fields

    system_id = 0
    component_id = 0
    sequence = 0

    def __init__(self):
        self.payload = bytearray(self.LENGTH)

    def __getattr__(self, name):
        if name in self.FIELDS:
            return self.get(name)
        raise AttributeError(name)

    def get(self, name):
        """Return a field: a number, a tuple for an array, text up to the first NUL for characters.

        Characters that are not ASCII come as bytes. KeyError: there is no such field.
        """
        return fields.read(self.payload, self.FIELDS[name])

    def set(self, name, value):
        """Write a field: a number, as many numbers as the array has, or ASCII text or bytes, filled up with NUL.

        ValueError: the field cannot carry the value, and keeps what it had. KeyError: there is no such field.
        """
        try:
            fields.write(self.payload, self.FIELDS[name], value)
        except ValueError as error:
            raise ValueError(f"{self.NAME}.{name} {error}") from None


class Link:
    """One end of a MAVLink connection over `stream`, which needs a method write(bytes) only.

    `messages` are the classes that feed() decodes. A link keeps a view for each length of payload up to `longest`,
    on a 32 bit board 20 bytes each.

    Counters: `tx_errors` frames that the stream did not take whole; `received` messages; `signed` frames with a
    signature, which is not checked; `unknown` frames of other messages; `crc_errors` and `dropped`: places that
    looked like a frame, but with a wrong checksum or with incompatible flags that this code does not know.
    """

    def __init__(self, stream, system_id=1, component_id=1, version=2, messages=(), longest=LONGEST_PAYLOAD):
        if not 1 <= system_id <= 255 or not 1 <= component_id <= 255:
            raise ValueError("a source has a system id and a component id from 1 to 255")
        if version not in (1, 2):
            raise ValueError("MAVLink has the versions 1 and 2")
        if not 1 <= longest <= LONGEST_PAYLOAD:
            raise ValueError("a payload has 1 to 255 bytes")
        self.stream = stream
        self.system_id = system_id
        self.component_id = component_id
        self.version = version
        self.sequence = 0
        self.tx_errors = 0
        self.received = 0
        self.signed = 0
        self.unknown = 0
        self.crc_errors = 0
        self.dropped = 0
        self._longest = longest
        self._header = HEADER_2 if version == 2 else HEADER_1
        self._frame = bytearray(self._header + longest + CHECKSUM)
        self._frame[0] = MAGIC_2 if version == 2 else MAGIC_1
        self._frame[5 if version == 2 else 3] = system_id
        self._frame[6 if version == 2 else 4] = component_id
        whole = memoryview(self._frame)
        self._views = [whole[: self._header + length + CHECKSUM] for length in range(longest + 1)]
        self._classes = {message.ID: message for message in messages}
        self._pending = bytearray()
        self._at = 0  # what precedes it in _pending is done with

    def encode(self, message):
        """Return the whole frame with the current sequence number; the view is valid until the next frame.

        ValueError: the message does not go over this link, by its length or by an id above 255 in MAVLink 1.
        """
        header = self._header
        payload = message.payload
        length = message.LENGTH if header == HEADER_2 else message.BASE_LENGTH
        # write_frame() in machine code does not notice when it leaves a buffer.
        if length > self._longest or length > len(payload):
            raise ValueError(f"{message.NAME}: the link or the payload is shorter than {length} bytes")
        if message.ID > 0xFF and header == HEADER_1:
            raise ValueError(f"{message.NAME}: MAVLink 1 has no message ids above 255")
        return self._views[
            write_frame(
                START, TABLE, payload, self._frame, header, length, self.sequence, message.ID, message.CRC_EXTRA
            )
        ]

    def send(self, message):
        """Write the message's frame to the stream, once; return how many bytes it took.

        Less than the frame, None or an OSError is no reason to stop the vehicle: it counts as one of `tx_errors`.
        The sequence number goes on all the same, so that the receiver notices the loss.
        """
        frame = self.encode(message)
        self.sequence = (self.sequence + 1) & 0xFF
        try:
            written = self.stream.write(frame) or 0
        except OSError:
            written = 0
        if written != len(frame):
            self.tx_errors += 1
        return written

    def feed(self, data):
        """Take in what arrived, in pieces of any size, and return an iterator over the messages that it completes.

        Messages that are not taken from the iterator come with the next call. None, which a UART without new bytes
        reads as, is no data.
        """
        if data:
            self._pending += data
        return self._decode()

    def _decode(self):
        while True:
            message = self._next_message()
            if message is None:
                return
            yield message

    def _next_message(self):
        """Return the first message in the pending bytes, or None if they hold no whole frame any more."""
        data = self._pending
        size = len(data)
        at = self._at
        while at < size:
            if data[at] == MAGIC_2:
                header = HEADER_2
            elif data[at] == MAGIC_1:
                header = HEADER_1
            else:
                at += 1
                continue
            if at + header > size:
                break
            flags = data[at + 2] if header == HEADER_2 else 0
            if flags & ~SIGNED:
                self.dropped += 1
                at += 1
                continue
            payload_end = at + header + data[at + 1]
            end = payload_end + CHECKSUM + (SIGNATURE if flags else 0)
            if end > size:
                break
            message_class = self._classes.get(_message_id(data, at))
            if not _is_intact(data, at, payload_end, message_class):
                # Perhaps not the start of a frame at all, and a true one begins within.
                self.crc_errors += 1
                at += 1
                continue
            start = at
            at = end
            if flags:
                self.signed += 1
            if message_class is None:
                self.unknown += 1
                continue
            self.received += 1
            self._at = at
            return _read_message(message_class, data, start, start + header, payload_end)
        self._pending = data[at:]
        self._at = 0
        return None


def _message_id(data, at):
    if data[at] == MAGIC_2:
        return data[at + 7] | (data[at + 8] << 8) | (data[at + 9] << 16)
    return data[at + 5]


def _is_intact(data, at, payload_end, message_class):
    """Tell whether the checksum of the frame at `at` is right.

    The last byte that it covers is CRC_EXTRA, which picks an entry of the table. It is not known for an unknown
    message, but then the entry has at least to be one: that shows up 255 of 256 false frames.
    """
    value = update(START, TABLE, data, at + 1, payload_end)
    entry = data[payload_end] ^ (data[payload_end + 1] << 8) ^ (value >> 8)
    if message_class is None:
        return is_entry(entry)
    return entry == TABLE[(value ^ message_class.CRC_EXTRA) & 0xFF]


def _read_message(message_class, data, at, payload, payload_end):
    """Build a message; zeros stand in for a truncated end, newer extensions than ours are left out."""
    message = message_class()
    length = min(payload_end - payload, message.LENGTH)
    message.payload[:length] = data[payload : payload + length]
    source = at + (4 if data[at] == MAGIC_2 else 2)
    message.sequence = data[source]
    message.system_id = data[source + 1]
    message.component_id = data[source + 2]
    return message
