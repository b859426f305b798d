"""Reading and writing single fields of a payload, with equal strictness on CPython and MicroPython.

A field is (struct code, offset, count): count 0 is a scalar, code "s" is text of count characters. For people and
tests; what is sent many times a second packs into the payload itself.
"""

import struct

_INFINITY = float("inf")


def read(payload, field):
    """Return a number, a tuple for an array, text up to the first NUL for characters.

    Characters that are not ASCII come as bytes.
    """
    code, offset, count = field
    size = count or 1
    if code == "s":
        text = bytes(payload[offset : offset + size]).split(b"\0")[0]
        return text.decode() if _is_ascii(text) else text
    values = struct.unpack_from(f"<{size}{code}", payload, offset)
    return values if count else values[0]


def write(payload, field, value):
    """Write a number, as many numbers as the array has, or ASCII text or bytes, filled up with NUL.

    ValueError: the field cannot carry the value; the payload stays as it was.
    """
    code, offset, count = field
    size = count or 1
    if code == "s":
        payload[offset : offset + size] = _characters(value, size)
        return
    values = tuple(value) if count else (value,)
    if len(values) != size:
        raise ValueError(f"takes {size} values, not {len(values)}")
    carries = _carries_float if code in "fd" else _carries_integer
    for number in values:
        if not carries(code, number):
            raise ValueError(f"cannot carry {number!r}")
    struct.pack_into(f"<{size}{code}", payload, offset, *values)


def _characters(value, size):
    if isinstance(value, str):
        text = value.encode()
        if not _is_ascii(text):
            raise ValueError(f"cannot carry {value!r}: text is ASCII")
    elif isinstance(value, (bytes, bytearray)):
        text = bytes(value)
    else:
        raise ValueError(f"cannot carry {value!r}: neither text nor bytes")
    if len(text) > size:
        raise ValueError(f"takes up to {size} characters, not {len(text)}")
    return text + bytes(size - len(text))


def _is_ascii(text):
    return all(byte < 0x80 for byte in text)


def _carries_integer(code, value):
    # MicroPython's struct wraps what is too large, and its bool is no kind of int.
    if not isinstance(value, (int, bool)):
        return False
    bits = 8 * struct.calcsize("<" + code)
    if code.islower():
        return -(1 << (bits - 1)) <= value < 1 << (bits - 1)
    return 0 <= value < 1 << bits


def _carries_float(code, value):
    # CPython refuses what is too large, MicroPython makes it infinite.
    if not isinstance(value, (int, float, bool)):
        return False
    try:
        carried = struct.unpack("<" + code, struct.pack("<" + code, float(value)))[0]
    except OverflowError:
        return False
    return abs(carried) != _INFINITY or (isinstance(value, float) and abs(value) == _INFINITY)
