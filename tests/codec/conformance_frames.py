"""Frames of a message: those that pymavlink packs and decodes, and raw ones with any payload."""

import random
from typing import Any

from conformance_oracle import Dialect, Message
from conformance_values import Values, all_zero, field_json, random_values, stated_values
from pymavlink.generator.mavcrc import x25crc

SYSTEM, COMPONENT = 42, 190
KEY = b"\x21" * 32


class Side:
    """pymavlink's MAVLink objects of both versions."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self.v2 = dialect.v2.MAVLink(None, srcSystem=SYSTEM, srcComponent=COMPONENT)
        self.v1 = dialect.v1.MAVLink(None, srcSystem=SYSTEM, srcComponent=COMPONENT)
        self.other = dialect.v2.MAVLink(None)

    def frame(self, message: Message, version: int, values: Values, sequence: int) -> bytes:
        """Return the frame that pymavlink sends; MAVLink 1 by its own module, as that for 2 would send extensions."""
        stated = stated_values(message, values)
        if version == 2:
            self.v2.seq = sequence
            return bytes(message.in_v2(*stated).pack(self.v2))
        self.v1.seq = sequence
        base = [value for value, item in zip(stated, message.fields, strict=True) if not item.is_extension]
        return bytes(message.in_v1(*base).pack(self.v1))

    def framed(self, message: Message, payload: bytes, chance: random.Random) -> bytes:
        """Return the frame that pymavlink makes of a payload, from any sender."""
        self.other.seq, self.other.srcSystem, self.other.srcComponent = chance.randbytes(3)
        blank = message.in_v2(*stated_values(message, all_zero(message)))
        return bytes(blank._pack(self.other, message.in_v2.crc_extra, payload))

    def whole(self, message: Message, payload: bytes, chance: random.Random) -> bytes:
        """A frame of MAVLink 2 with a payload that is not truncated, which pymavlink only receives."""
        return raw_frame(message.id, payload, message.in_v2.crc_extra, chance)

    def heard(self, stream: bytes) -> list[list[Any]]:
        """The messages of the dialect that pymavlink finds in a stream, as conform.py tells them."""
        listener = self.dialect.v2.MAVLink(None)
        listener.robust_parsing = True
        by_name = {message.name: message for message in self.dialect.messages}
        found = [item for item in listener.parse_buffer(stream) or [] if item.get_type() in by_name]
        return [arrived(by_name[item.get_type()], bytes(item.get_msgbuf())) for item in found]

    def decoded(self, message: Message, frame: bytes) -> list[Any]:
        """The values that pymavlink reads from a frame, as conform.py reads them."""
        found = self.other.decode(bytearray(frame))
        assert found.get_type() == message.name
        values = []
        for item in message.fields:
            value = getattr(found, item.name)
            if item.code == "s":
                text = getattr(found, f"_{item.name}_raw").split(b"\0")[0]
                value = text.decode() if text.isascii() else [text.hex()]
            else:
                value = field_json(item, value)
            values.append(value)
        return values


def checksum(body: bytes, extra: int) -> bytes:
    """The checksum of a frame without its first byte, by pymavlink."""
    return int(x25crc(body + bytes([extra])).crc).to_bytes(2, "little")


def raw_frame(number: int, payload: bytes, extra: int, chance: random.Random, flags: int = 0) -> bytes:
    """A frame of MAVLink 2 put together by hand."""
    head = bytes([len(payload), flags, 0, chance.randrange(256), SYSTEM, COMPONENT])
    body = head + number.to_bytes(3, "little") + payload
    return b"\xfd" + body + checksum(body, extra)


def raw_frame_1(number: int, payload: bytes, extra: int, chance: random.Random) -> bytes:
    """A frame of MAVLink 1 put together by hand."""
    body = bytes([len(payload), chance.randrange(256), SYSTEM, COMPONENT, number]) + payload
    return b"\xfe" + body + checksum(body, extra)


def signed_frame(side: Side, message: Message, chance: random.Random) -> bytes:
    """A frame with a signature, which nobody checks here."""
    sender = side.dialect.v2.MAVLink(None, srcSystem=SYSTEM, srcComponent=COMPONENT)
    sender.seq = chance.randrange(256)
    sender.signing.secret_key, sender.signing.sign_outgoing = KEY, True
    return bytes(message.in_v2(*stated_values(message, random_values(message, chance))).pack(sender))


def arrived(message: Message, frame: bytes) -> list[Any]:
    """Return conform.py's description of a frame in a stream: name, payload with all its zeros, its source."""
    start, source = (10, (5, 6, 4)) if frame[0] == 0xFD else (6, (3, 4, 2))
    payload = frame[start : start + frame[1]]
    return [message.name, payload.ljust(message.length, b"\0").hex(), [frame[place] for place in source]]
