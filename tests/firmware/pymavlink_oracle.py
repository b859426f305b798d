"""Messages, values and frames as pymavlink makes them: what the firmware is compared with."""

import random
import struct
from typing import Any

from pymavlink.dialects.v10 import common as common_1
from pymavlink.dialects.v20 import common as common_2
from pymavlink.generator.mavcrc import x25crc

SYSTEM, COMPONENT = 42, 190

# The plain, the truncated, text, 64 bit integers, doubles, the longest payload, ids above 255, and fields that are
# called like attributes of Message (TUNNEL.payload, LOGGING_DATA.sequence).
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


def describe(name: str) -> Description:
    """The class attributes that messages.py gives a message, as JSON can carry them."""
    message = BY_NAME[name]
    fields: dict[str, tuple[str, int, int]] = {}
    offset = 0
    codes = message.native_format.decode()[1:].replace("c", "s")
    for field, code, count in zip(message.ordered_fieldnames, codes, message.array_lengths, strict=True):
        fields[field] = (code, offset, count)
        offset += struct.calcsize(f"<{count or 1}{code}")
    assert offset == message.unpacker.size
    base = common_1.mavlink_map[message.id].unpacker.size if message.id in common_1.mavlink_map else offset
    return {
        "NAME": name,
        "ID": message.id,
        "CRC_EXTRA": message.crc_extra,
        "BASE_LENGTH": base,
        "LENGTH": offset,
        "FIELDS": fields,
    }


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
    for name, (code, _, count) in description["FIELDS"].items():
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
        sender.signing.secret_key = b"\xfd" * 32
        sender.signing.link_id = 3
        sender.signing.timestamp = 0xFEFD00
        sender.signing.sign_outgoing = True
    message_type = dialect.mavlink_map[BY_NAME[name].id]
    message = message_type(**{field: values[field] for field in message_type.fieldnames})
    return bytes(message.pack(sender))


def raw_frame(message_id: int, payload: bytes, extra: int, flags: int = 0, tail: bytes = b"") -> bytes:
    """A MAVLink 2 frame put together by hand, for what pymavlink does not send; sequence 9."""
    body = bytes([len(payload), flags, 0, 9, SYSTEM, COMPONENT]) + message_id.to_bytes(3, "little") + payload
    return b"\xfd" + body + x25crc(body + bytes([extra])).crc.to_bytes(2, "little") + tail


def payload(name: str, values: Values, base_only: bool = False) -> bytes:
    """The payload without truncation, extension fields zero if only the base fields were sent."""
    description = describe(name)
    packed = bytearray(description["LENGTH"])
    for field, (code, offset, count) in description["FIELDS"].items():
        value = values[field] if count and code != "s" else [values[field]]
        struct.pack_into(f"<{count or 1}{code}", packed, offset, *value)
    if base_only:
        packed[description["BASE_LENGTH"] :] = bytes(description["LENGTH"] - description["BASE_LENGTH"])
    return bytes(packed)


def parse(data: bytes) -> list[Any]:
    """The messages that pymavlink finds."""
    return common_2.MAVLink(None).parse_buffer(data) or []
