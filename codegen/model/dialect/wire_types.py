"""The element types of the MAVLink wire (little-endian, no padding)."""

from codegen.model.dialect.dialect import Kind, WireType

MAX_ARRAY_LENGTH = 255
"""Most elements of an array: its length is one byte of CRC_EXTRA, and a payload holds 255 bytes."""

VERSION_TYPE = "uint8_t_mavlink_version"
"""A ``uint8_t`` that the sender fills with the version of the dialect."""


def _unsigned(bits: int, code: str) -> WireType:
    return WireType(f"uint{bits}_t", bits // 8, code, Kind.UNSIGNED, 0, (1 << bits) - 1)


def _signed(bits: int, code: str) -> WireType:
    return WireType(f"int{bits}_t", bits // 8, code, Kind.SIGNED, -(1 << (bits - 1)), (1 << (bits - 1)) - 1)


WIRE_TYPES: dict[str, WireType] = {
    wire_type.name: wire_type
    for wire_type in (
        _unsigned(8, "B"),
        _unsigned(16, "H"),
        _unsigned(32, "I"),
        _unsigned(64, "Q"),
        _signed(8, "b"),
        _signed(16, "h"),
        _signed(32, "i"),
        _signed(64, "q"),
        WireType("float", 4, "f", Kind.FLOAT, 0, 0),
        WireType("double", 8, "d", Kind.FLOAT, 0, 0),
        WireType("char", 1, "s", Kind.CHAR, 0, 255),
    )
}
"""Wire type by the name that a ``<field>`` gives it; the version type is a ``uint8_t`` under a second name."""
WIRE_TYPES[VERSION_TYPE] = WIRE_TYPES["uint8_t"]

SPELLINGS: dict[str, str] = {
    **{
        spelling: f"{name}{bits}_t"
        for name in ("uint", "int")
        for bits in (8, 16, 32, 64)
        for spelling in (f"{name[0]}{bits}", f"{name}{bits}", f"{name}{bits}_t")
    },
    "f32": "float",
    "float": "float",
    "f64": "double",
    "double": "double",
}
"""Wire type of a number by the ways in which code spells it: ``u16``, ``uint16``, ``uint16_t``, ``f32``."""
