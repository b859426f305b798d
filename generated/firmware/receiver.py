# Generated from templates/codec/receiver.py: do not edit.
# Inputs: 6fdb1fd4de2a27df
"""Finding messages in the bytes that arrive. Unsigned messages that are received into objects allocate nothing."""

from array import array

from checksum import TABLE, is_entry
from frames import decoder, taker

LONGEST_FRAME = 280
_BYTES = (bytes, bytearray, memoryview)


class Receiver:
    """Turns bytes into messages.

    `messages` are classes, a new message of which is made for each that arrives, or messages, which are used again:
    such a message holds what arrived last. Frames stay in a buffer of `size` bytes until they are whole.

    put(data) takes in what arrived, and receive() returns the next message, or None when there is no whole one any
    more: until then it reads `data`. TypeError: these are not bytes.

    Counters: `received` messages, `signed` ones among them; `refused` frames that `signing` did not accept;
    `unknown` frames of other messages; `crc_errors` and `dropped`: places that looked like a frame, but with a wrong
    checksum or with incompatible flags that this code does not know. Without `signing` signatures are not checked.
    """

    def __init__(self, messages=(), signing=None, size=2 * LONGEST_FRAME):
        if size < LONGEST_FRAME:
            raise ValueError(f"a frame has up to {LONGEST_FRAME} bytes")
        self._signing = signing
        self.refused = 0
        self.unknown = 0
        self.crc_errors = 0
        self._classes = {message.ID: message for message in messages if isinstance(message, type)}
        self._messages = {message.ID: message for message in messages if not isinstance(message, type)}
        self._buffer = bytearray(size)
        self._state = state = array("i", [0] * 15)  # frames_plain says what it holds
        state[13] = size
        state[14] = 0 if signing is None else 1
        self._arrived = [None]  # data that did not find room, in a list: storing into a list is faster than here
        self.receive = decoder(self)
        self.put = taker(self)

    @property
    def received(self):
        """How many messages were received."""
        return self._state[10]

    @property
    def signed(self):
        """How many of them had a signature."""
        return self._state[11]

    @property
    def dropped(self):
        """How many places looked like a frame with incompatible flags that this code does not know."""
        return self._state[8]

    def feed(self, data):
        """Take in what arrived, in pieces of any size, and return an iterator over the messages that it completes.

        Messages that are not taken from the iterator come with the next call. None, which a UART without new bytes
        reads as, is no data. The iterator is an object on the heap: put() and receive() do without.
        """
        self.put(data)
        return self._each()

    def _put_more(self, data):
        """Take in what put() is not made for: more data behind those that are kept, None, and what is no bytes."""
        if data is None:
            return
        if not isinstance(data, _BYTES):
            raise TypeError("what arrives is bytes, a bytearray or a memoryview")
        state = self._state
        kept = b""
        if state[12]:
            kept = bytes(memoryview(self._arrived[0])[state[2] :])
            state[2] = state[12] = 0
        self.put(kept + data)

    def _refill(self):
        """Take in more of the data that are kept; the caller may have made them shorter."""
        state = self._state
        data = self._arrived[0]
        self._arrived[0] = None
        state[12] = 0
        if state[2] < len(data):
            self.put(data)
        else:
            state[2] = 0

    def _admitted(self, message):
        """Return the message that the frame at hand goes into, a new one if need be; None passes over the frame."""
        if message is None:
            message = self._new_message()
        if message is not None and self._state[14] and not self._is_admitted(message):
            return None
        return message

    def _new_message(self):
        """Return a new message for the frame at hand, None for one that is unknown."""
        cls = self._classes.get(self._state[6])
        if cls is not None:
            return cls(unknown=False)
        # The CRC_EXTRA of an unknown message is unknown too: but some entry of the table it has to pick, which shows up
        # 255 of 256 false frames.
        if is_entry(self._entry()):
            self.unknown += 1
        else:
            self._look_within()
        return None

    def _entry(self):
        """Return what CRC_EXTRA has picked from the table, if the checksum of the frame at hand is right.

        CRC_EXTRA is the last byte that the checksum covers.
        """
        state = self._state
        end = state[4] + state[5]
        return self._buffer[end] ^ self._buffer[end + 1] << 8 ^ state[7] >> 8

    def _look_within(self):
        """Go on behind the first byte: perhaps it is not the start of a frame at all, and a true one begins within."""
        self.crc_errors += 1
        self._state[0] = self._state[3] + 1

    def _is_admitted(self, message):
        state = self._state
        if self._entry() != TABLE[256 + ((state[7] ^ message.CRC_EXTRA) & 0xFF)]:
            self._look_within()
            return False
        if state[9]:
            frame = memoryview(self._buffer)[state[3] : state[0]]
            is_admitted = self._signing.accepts(frame)
        else:
            is_admitted = message.ID in self._signing.unsigned
        if not is_admitted:
            self.refused += 1
        return is_admitted

    def _each(self):
        while True:
            message = self.receive()
            if message is None:
                return
            yield message
