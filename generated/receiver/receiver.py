# Generated from templates/codec/receiver.py: do not edit.
# Inputs: 6c2575659c8a4d8a
"""Finding messages in the bytes that arrive. Unsigned messages that are received into objects allocate nothing."""

from array import array

from checksum import TABLE
from frames import decoder, taker

LONGEST_FRAME = 280
_BYTES = (bytes, bytearray, memoryview)


class Receiver:
    """Turns bytes into messages.

    `messages` are classes, a new message of which is made for each that arrives, or messages, which are used again:
    such a message holds what arrived last. Frames stay in a buffer of `size` bytes until they are whole.

    put(data) takes in what arrived, and receive() returns the next message, or None when there is no whole one any
    more: until then it reads `data`. TypeError: these are not bytes.

    Counters: `received` messages, `signed` ones among them; `refused` frames that `signing` did not accept; and places
    that looked like the start of a frame: `unknown`, of another message; `crc_errors`, with a wrong checksum;
    `dropped`, with incompatible flags that this code does not know. Without `signing` signatures are not checked.

    Only a frame that is right hides what is within it: behind the first byte of everything else the search goes on.
    """

    def __init__(self, messages=(), signing=None, size=2 * LONGEST_FRAME):
        if size < LONGEST_FRAME:
            raise ValueError(f"a frame has up to {LONGEST_FRAME} bytes")
        self._signing = signing
        self.refused = 0
        self.crc_errors = 0
        self._classes = {message.ID: message for message in messages if isinstance(message, type)}
        # False is a message of a class.
        self._messages = {message.ID: not isinstance(message, type) and message for message in messages}
        self._buffer = bytearray(size + 15)  # machine code writes 16 bytes at once
        self._state = state = array("i", [0] * 29)  # frames_plain says what it holds
        state[13] = size
        state[14] = 0 if signing is None else 1
        self._make = None
        self._arrived = [None]  # data that did not find room, in a list: storing into a list is faster than here
        self.receive = decoder(self)
        self.put = taker(self)

    @property
    def received(self):
        """Return the number of messages received."""
        return self._state[10]

    @property
    def signed(self):
        """Return the number of received messages with a signature."""
        return self._state[11]

    @property
    def dropped(self):
        """Return the number of places that looked like a frame with incompatible flags unknown to this code."""
        return self._state[8]

    @property
    def unknown(self):
        """Return the number of places that looked like a frame of another message."""
        return self._state[18]

    def expect(self, ids, make):
        """Receive messages with these ids, too, where none is for them yet: make(id) returns one for each frame."""
        self._make = make
        for number in ids:
            if number not in self._messages:
                self._messages[number] = False

    def give_up(self):
        """Look on behind the first byte of a frame that is not whole: its end got lost, or it never was one."""
        state = self._state
        if state[0] < state[1]:
            state[0] += 1

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
            raise TypeError("what arrives is bytes or like them")
        state = self._state
        if state[12]:
            data = bytes(memoryview(self._arrived[0])[state[2] :]) + data
            state[2] = state[12] = 0
        state[17] = len(data)
        if data:
            self.put(data)

    def _refill(self):
        """Take in more of the data that are kept; the caller may have made them shorter."""
        state = self._state
        data = self._arrived[0]
        self._arrived[0] = None
        state[12] = 0
        if not 0 < state[17] <= len(data):
            state[17] = len(data)
        if state[2] < state[17]:
            self.put(data)
        else:
            state[2] = state[17] = 0

    def _admitted(self, message):
        """Return the message that the frame at hand goes into, a new one for False; None passes over the frame."""
        if message is False:
            number = self._state[6]
            kind = self._classes.get(number)
            message = self._make(number) if kind is None else kind(unknown=False)
        return None if self._state[14] and not self._is_admitted(message) else message

    def _look_within(self):
        """Go on behind the first byte: perhaps it is not the start of a frame at all, and a true one begins within."""
        self.crc_errors += 1
        self._state[0] = self._state[3] + 1

    def _is_admitted(self, message):
        state = self._state
        end = state[4] + state[5]
        crc = TABLE[256 + ((state[7] ^ message.CRC_EXTRA) & 0xFF)] ^ state[7] >> 8
        if self._buffer[end] | self._buffer[end + 1] << 8 != crc:
            self._look_within()
            return False
        if self._is_trusted(message, state):
            return True
        self.refused += 1
        state[15] += state[16] >> 2  # to judge a signature takes long
        return False

    def _is_trusted(self, message, state):
        """Return whether the signature is right, or none is asked for; apart, for the stack of MicroPython."""
        if not state[9]:
            return message.ID in self._signing.unsigned
        return self._signing.accepts(memoryview(self._buffer)[state[3] : state[0]])

    def _each(self):
        while True:
            message = self.receive()
            if message is None:
                return
            yield message
