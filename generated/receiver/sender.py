# Generated from templates/codec/sender.py: do not edit.
# Inputs: 02a23eab1ca77294
"""Making frames and writing them to a stream. Nothing here allocates once a sender exists."""

from struct import pack_into

from checksum import TABLE
from frames import address, encoder

LONGEST_PAYLOAD = 255
_len = len  # found here, it is found sooner than among the built-in names


class Sender:
    """Sends messages over `stream`, which needs a method write(bytes) only.

    encode(message) returns the whole frame with the current sequence number; the view is valid until the next frame.
    ValueError: the message does not go over this link, by its length or by an id above 255 in MAVLink 1.

    A sender keeps a view for each length of payload up to `longest`, on a 32 bit board 16 bytes each. Of a sender that
    is told the `lengths` that go out, pairs of the first and the last of a range, the first pair from 0 on, others are
    made when they are needed. `signing` is None, or what signs each frame: see signing.Signing. `tx_errors` counts
    frames that the stream did not take whole.
    """

    def __init__(
        self, stream, system_id=1, component_id=1, version=2, longest=LONGEST_PAYLOAD, signing=None, lengths=None
    ):
        if not 1 <= system_id <= 255 or not 1 <= component_id <= 255:
            raise ValueError("a source has ids from 1 to 255")
        if version not in (1, 2):
            raise ValueError("MAVLink has the versions 1 and 2")
        if not 1 <= longest <= LONGEST_PAYLOAD:
            raise ValueError("a payload has 1 to 255 bytes")
        if signing and version == 1:
            raise ValueError("MAVLink 1 has no signatures")
        self.stream = stream
        self._signing = signing
        self.tx_errors = 0
        header = 10 if version == 2 else 6
        extra = header + (15 if signing else 2)
        # The frame begins at the third byte, so that its payload is aligned; before it stands the longest payload.
        # In front of it stands where the table of the checksum is, for who makes the frame of a payload itself.
        buffer = bytearray(8 + 2 + extra + longest + 15)
        pack_into("<Q", buffer, 0, address(TABLE))
        self._frame = frame = memoryview(buffer)[8:]
        self._sequence_at = 6 if version == 2 else 4
        frame[0] = longest
        frame[2] = 0xFD if version == 2 else 0xFE
        frame[4] = 1 if signing else 0
        frame[self._sequence_at + 1] = system_id
        frame[self._sequence_at + 2] = component_id
        views = [None] * (longest + 1)  # a list that is as long from the start keeps no more room than it needs
        # The place of the payload, and the frame by its length, for messages that write there themselves. The buffer of
        # a link that sends MAVLink 1, or signs, is not for that: there is one that holds nothing.
        self._none = None if version == 2 and not signing else bytes(1)
        self.room = (address(self._none or frame) + 12, views)
        lengths = lengths or ((0, longest),)
        frame[1] = lengths[0][1]
        for first, last in lengths:
            for length in range(first, last + 1):
                self._new_view(length)
        encode = encoder(frame, views, self._new_view)
        self.encode = _signed(encode, signing) if signing else encode
        # An attribute of its own is found much sooner than a method of a class that others are derived from.
        self.send_frame = _frame_sender(self, frame, self._sequence_at)

    @property
    def version(self):
        """MAVLink version that is sent."""
        return 2 if self._frame[2] == 0xFD else 1

    @property
    def signing(self):
        """Return the Signing of the frames, or None; a link has it from the start."""
        return self._signing

    @property
    def sequence(self):
        """Sequence number of the next frame."""
        return self._frame[self._sequence_at]

    @sequence.setter
    def sequence(self, value):
        self._frame[self._sequence_at] = value & 0xFF

    def send(self, message):
        """Write the message's frame to the stream, once; return how many bytes it took.

        Less than the frame, None or an OSError is no reason to stop the vehicle: it counts as one of `tx_errors`.
        The sequence number goes on all the same, so that the receiver notices the loss.
        """
        return self.send_frame(self.encode(message))

    def _new_view(self, length):
        """Return the view of a length, made now where there is none."""
        views = self.room[1]
        if views[length] is None:
            extra = (12 if self._frame[2] == 0xFD else 8) + (13 if self._signing else 0)
            views[length] = self._frame[2 : 2 + extra + length]
        return views[length]


def _frame_sender(sender, buffer, at):
    """Return send_frame(frame), which writes a frame that was made just now, as send() does with a message's."""
    write = _writer(sender)

    def send_frame(frame):
        written = write(frame)
        buffer[at] = (buffer[at] + 1) & 0xFF
        if written != _len(frame):
            sender.tx_errors += 1
        return written

    return send_frame


def _writer(sender):  # apart, since the variables of a larger function that catches something lie on the heap
    def write(frame):
        try:
            return sender.stream.write(frame) or 0
        except OSError:
            return 0

    return write


def _signed(encode, signing):
    def encode_signed(message):
        view = encode(message)
        signing.sign(view)
        return view

    return encode_signed
