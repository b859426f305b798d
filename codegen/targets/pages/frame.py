"""The frame that a message makes of its values, byte by byte: header, payload, what truncation drops, checksum."""

import struct
from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireField
from codegen.model.system import PopulatedMessage, System
from codegen.resolve.dialect.wire import crc_mcrf4xx
from codegen.targets.suite.expected import Wire

SIGNATURE = (("link", 1), ("timestamp", 6), ("signature", 6))
"""The parts of a signed frame of MAVLink 2 after its checksum: names and bytes. Source: MAVLink's guide to signing."""


@dataclass(frozen=True, slots=True)
class Part:
    """One field of a frame's header or trailer, with its bytes on the wire and what they say."""

    name: str
    data: bytes
    meaning: str


@dataclass(frozen=True, slots=True)
class SentFrame:
    """An unsigned frame, the first of its sender: its sequence number is 0.

    ``payload`` is whole; its first ``sent`` bytes go out, the zeros after them do not.
    """

    header: tuple[Part, ...]
    payload: bytes
    sent: int
    checksum: Part

    @property
    def data(self) -> bytes:
        """Every byte that goes out."""
        return b"".join(part.data for part in self.header) + self.payload[: self.sent] + self.checksum.data


def sent_frame(message: PopulatedMessage, values: Mapping[str, Wire], system: System) -> SentFrame:
    """The frame of ``message`` with ``values``, a value by name of each field, as the project's protocol has it."""
    wire = message.wire
    is_v2 = system.spec.project.protocol == 2
    whole = b"".join(packed(field, values[field.name]) for field in wire.fields)
    payload = whole if is_v2 else whole[: wire.base_length]
    sent = max(1, len(payload.rstrip(b"\0"))) if is_v2 else len(payload)
    ids = (
        Part("seq", b"\0", "number of the frame, counted by the link"),
        Part("sys", bytes([system.system_id]), f"system {system.system_id}"),
        Part("comp", bytes([system.component_id]), f"component {system.component_id}"),
    )
    length = Part("len", bytes([sent]), f"length of the payload, {sent}")
    says = f"{wire.name} is message {wire.id}"
    header: tuple[Part, ...]
    if is_v2:
        flags = (
            Part("inc", b"\0", "flags that a receiver must understand (incompatibility); 1 in a signed frame"),
            Part("cmp", b"\0", "flags that a receiver may ignore (compatibility)"),
        )
        number = Part("id", wire.id.to_bytes(3, "little"), says)
        header = (Part("start", b"\xfd", "start of a MAVLink 2 frame"), length, *flags, *ids, number)
    else:
        number = Part("id", bytes([wire.id & 0xFF]), says)
        header = (Part("start", b"\xfe", "start of a MAVLink 1 frame"), length, *ids, number)
    covered = b"".join(part.data for part in header)[1:] + payload[:sent] + bytes([wire.crc_extra])
    words = f"CRC of all after the first byte, and of CRC_EXTRA {wire.crc_extra}"
    return SentFrame(header, payload, sent, Part("CRC", crc_mcrf4xx(covered).to_bytes(2, "little"), words))


def packed(field: WireField, value: Wire) -> bytes:
    """The bytes of a field; text is filled up with zeros."""
    if isinstance(value, str):
        return value.encode()[: field.count].ljust(field.count, b"\0")
    values = value if isinstance(value, list) else [value]
    return struct.pack(f"<{field.count}{field.type.code}", *values)
