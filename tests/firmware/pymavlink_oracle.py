"""Messages, values and frames as pymavlink makes them: what the firmware is compared with."""

import random
import re
import struct
from typing import Any

from pymavlink.dialects.v10 import common as common_1
from pymavlink.dialects.v20 import common as common_2
from pymavlink.generator.mavcrc import x25crc

SYSTEM, COMPONENT = 42, 190
KEY = b"\xfd" * 32

# The plain, the truncated, text, 64 bit integers, doubles, the longest payload, ids above 255, and fields that are
# called like attributes of receivers (TUNNEL.payload, LOGGING_DATA.sequence).
NAMES = (
    "HEARTBEAT",
    "SYS_STATUS",
    "PARAM_VALUE",
    "FILE_TRANSFER_PROTOCOL",
    "TIMESYNC",
    "BATTERY_STATUS",
    "AUTOPILOT_VERSION",
    "DEBUG_VECT",
    "STATUSTEXT",
    "LOGGING_DATA",
    "TUNNEL",
    "WHEEL_DISTANCE",
)
BY_NAME = {message.msgname: message for message in common_2.mavlink_map.values()}

Description = dict[str, Any]
Values = dict[str, Any]


def described(name: str, words: str, message_id: int = 200, base_length: int = 0, extra: int = 7) -> Description:
    """The class attributes of a message with these fields."""
    description = {"NAME": name, "ID": message_id, "CRC_EXTRA": extra, "FIELDS": words}
    length = sum(struct.calcsize(f"<{count or 1}{code}") for code, _, count in layout(description).values())
    return description | {"LENGTH": length, "BASE_LENGTH": base_length or length}


def layout(description: Description) -> dict[str, tuple[str, int, int]]:
    """(struct code, offset, count) of each field, worked out without the codec; count 0 is a scalar."""
    fields = {}
    offset = 0
    for name, count, code in re.findall(r"(\w+):(\d*)(\w)\S*", description["FIELDS"]):
        fields[name] = (code, offset, int(count or 0))
        offset += struct.calcsize(f"<{int(count or 1)}{code}")
    return fields


def describe(name: str) -> Description:
    """The class attributes that messages.py gives a message, without sentinels; as JSON can carry them."""
    message = BY_NAME[name]
    codes = message.native_format.decode()[1:].replace("c", "s")
    fields = zip(message.ordered_fieldnames, message.array_lengths, codes, strict=True)
    words = " ".join(f"{field}:{count or ''}{code}" for field, count, code in fields)
    in_version_1 = common_1.mavlink_map.get(message.id)
    base_length = in_version_1.unpacker.size if in_version_1 else 0
    description = described(name, words, message.id, base_length, message.crc_extra)
    assert description["LENGTH"] == message.unpacker.size
    return description


def random_number(code: str, chance: random.Random) -> int | float:
    """A number that the field carries: often zero, often an extreme. Floats are exact in single precision."""
    if chance.random() < 0.3:
        return 0
    if code in "fd":
        return chance.choice([chance.randrange(-80000, 80000) / 8, 0.0, -1.5, float("nan"), float("inf")])
    bits = 8 * struct.calcsize(code if code not in "qQ" else "<q")
    low = -(1 << bits - 1) if code.islower() else 0
    return chance.choice([low, low + (1 << bits) - 1, chance.randrange(low, low + (1 << bits))])


def random_values(description: Description, chance: random.Random) -> Values:
    """Values of all fields; text is bytes without NUL inside."""
    values: Values = {}
    for name, (code, _, count) in layout(description).items():
        if code == "s":
            values[name] = bytes(chance.randrange(1, 128) for _ in range(chance.randrange(count + 1)))
        elif count:
            # Zeros at the end are what truncation is about.
            used = chance.randrange(count + 1)
            values[name] = [random_number(code, chance) if index < used else 0 for index in range(count)]
        else:
            values[name] = random_number(code, chance)
    return values


def frame(name: str, values: Values, sequence: int, version: int = 2, signed: bool = False) -> bytes:
    """The whole frame, MAVLink 1 with the v10 dialect since pymavlink's v20 would send extension fields."""
    dialect = common_2 if version == 2 else common_1
    sender = dialect.MAVLink(None, srcSystem=SYSTEM, srcComponent=COMPONENT)
    sender.seq = sequence
    if signed:
        prepare_signing(sender, KEY, timestamp=0xFEFD00, link=3)
    message_type = dialect.mavlink_map[BY_NAME[name].id]
    message = message_type(**{field: values[field] for field in message_type.fieldnames})
    return bytes(message.pack(sender))


def prepare_signing(side: Any, key: bytes, timestamp: int, link: int = 0) -> None:
    """Let a MAVLink object of pymavlink sign what it sends and refuse what it receives without a valid signature."""
    side.signing.secret_key = key
    side.signing.link_id = link
    side.signing.timestamp = timestamp
    side.signing.sign_outgoing = True


def raw_frame(message_id: int, payload: bytes, extra: int, flags: int = 0, tail: bytes = b"") -> bytes:
    """A MAVLink 2 frame put together by hand, for what pymavlink does not send; sequence 9."""
    body = bytes([len(payload), flags, 0, 9, SYSTEM, COMPONENT]) + message_id.to_bytes(3, "little") + payload
    return b"\xfd" + body + x25crc(body + bytes([extra])).crc.to_bytes(2, "little") + tail


def raw_frame_1(message_id: int, payload: bytes, extra: int) -> bytes:
    """A MAVLink 1 frame put together by hand; sequence 9."""
    body = bytes([len(payload), 9, SYSTEM, COMPONENT, message_id]) + payload
    return b"\xfe" + body + x25crc(body + bytes([extra])).crc.to_bytes(2, "little")


def packed(description: Description, values: Values) -> bytes:
    """The payload without truncation; fields without a value are zero."""
    wire = bytearray(description["LENGTH"])
    for field, (code, offset, count) in layout(description).items():
        if field in values:
            value = values[field] if count and code != "s" else [values[field]]
            struct.pack_into(f"<{count or 1}{code}", wire, offset, *value)
    return bytes(wire)


def payload(name: str, values: Values, base_only: bool = False) -> bytes:
    """The payload of a message, extension fields zero if only the base fields were sent."""
    description = describe(name)
    wire = packed(description, values)
    length = description["BASE_LENGTH"] if base_only else len(wire)
    return wire[:length] + bytes(len(wire) - length)


def parse(data: bytes) -> list[Any]:
    """The messages that pymavlink finds."""
    return common_2.MAVLink(None).parse_buffer(data) or []


def is_valid(frame: bytes) -> bool:
    """Return whether a whole frame of a message of common.xml has the checksum that pymavlink computes."""
    header, signature = (10, 13 * (frame[2] & 1)) if frame[0] == 0xFD else (6, 0)
    number = int.from_bytes(frame[7:10], "little") if header == 10 else frame[5]
    end = header + frame[1]
    crc = x25crc()
    crc.accumulate(frame[1:end] + bytes([common_2.mavlink_map[number].crc_extra]))
    return len(frame) == end + 2 + signature and frame[end : end + 2] == crc.crc.to_bytes(2, "little")
