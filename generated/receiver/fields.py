# Generated from templates/codec/fields.py: do not edit.
# Inputs: d0edd4bd141e9e01
"""Single fields of a message by name, with equal strictness on CPython and MicroPython: for set-up, people and tests.

A class states its fields in wire order as words `name:code` or `name:<count>code`, with struct's codes ("s" is text of
`count` characters), and behind "=" what means unknown: `=V` in the field or in any element, `=V:` in element 0 for the
whole array, `=V1,,V3` element by element.
"""

import struct

_INFINITY = float("inf")


def layout(message):
    """Return {name: (code, offset, count, sentinels)} of a message, made at the first use of its class.

    Count 0 is a scalar; sentinels has one value or None for each element and is empty without any; one None more than
    elements means that the first speaks for the whole array.
    """
    cls = type(message)
    if cls.__dict__.get("_layout") is None:
        cls._layout = _laid_out(cls.FIELDS)
    return cls._layout


def _laid_out(fields):
    found = {}
    offset = 0
    for word in fields.split():
        name, form = word.split(":", 1)
        form, _, unknown = form.partition("=")
        count = int(form[:-1] or 0)
        found[name] = (form[-1], offset, count, _sentinels(unknown, count, form[-1] in "fd"))
        offset += (count or 1) * struct.calcsize("<" + form[-1])
    return found


def names(message):
    """Return the names of the fields in wire order."""
    return [word.split(":")[0] for word in message.FIELDS.split()]


def text(message):
    """Return the message as people read it: its name and its fields in wire order."""
    return message.NAME + "(" + ", ".join(f"{name}={get(message, name)!r}" for name in names(message)) + ")"


def get(message, name):
    """Return a field, None for what is unknown; Message.get() describes it."""
    field = layout(message)[name]
    _put_live(message)
    return known(message.wire, field)


def raw(message, name):
    """Return a field as it stands on the wire."""
    field = layout(message)[name]
    _put_live(message)
    return read(message.wire, field)


def set(message, name, value):  # noqa: A001  what a message calls it too
    """Write a field; Message.set() describes it."""
    field = layout(message)[name]
    _put_live(message)
    try:
        write(message.wire, field, value)
    except ValueError as error:
        raise ValueError(f"{message.NAME}.{name} {error}") from None
    _take_live(message)


def forget(message):
    """Make every field unknown that can be."""
    for field in layout(message).values():
        if field[3]:
            write(message.wire, field, None)
    _take_live(message)


def read(payload, field):
    """Return a number, a tuple for an array, text up to the first NUL for characters; bytes if they are not ASCII."""
    code, offset, count, _ = field
    size = count or 1
    if code == "s":
        text = bytes(payload[offset : offset + size]).split(b"\0")[0]
        return text.decode() if _is_ascii(text) else text
    values = struct.unpack_from(f"<{size}{code}", payload, offset)
    return values if count else values[0]


def known(payload, field):
    """Return what read() does, with None for what is unknown."""
    value = read(payload, field)
    code, _, count, sentinels = field
    if code == "s" or not sentinels:
        return value
    if not count:
        return None if _is(value, sentinels[0]) else value
    if len(sentinels) > count:
        return None if _is(value[0], sentinels[0]) else value
    return tuple([None if _is(element, sentinels[index]) else element for index, element in enumerate(value)])


def write(payload, field, value):
    """Write a number, as many numbers as the array has, or ASCII text or bytes, filled up with NUL; None is unknown.

    ValueError: the field cannot carry the value; the payload stays as it was.
    """
    code, offset, count, sentinels = field
    size = count or 1
    if value is None:
        if not sentinels:
            raise ValueError("has no value for unknown")
        value = [sentinel or 0 for sentinel in sentinels[:size]]
        value = bytes(value) if code == "s" else value if count else value[0]
    if code == "s":
        payload[offset : offset + size] = _characters(value, size)
        return
    values = _elements(value) if count else [value]
    if len(values) != size:
        raise ValueError(f"takes {size} values, not {len(values)}")
    carries = _carries_float if code in "fd" else _carries_integer
    for index in range(size):
        if values[index] is None and len(sentinels) == size:
            values[index] = sentinels[index]
        if not carries(code, values[index]):
            raise ValueError(f"cannot carry {values[index]!r}")
    struct.pack_into(f"<{size}{code}", payload, offset, *values)


def _elements(value):
    try:
        return list(value)
    except TypeError:
        raise ValueError(f"is an array and cannot be {value!r}") from None


def places(message, names):
    """Return the places of live fields, `name` or `name[index]`, one for each element.

    A place is offset * 8, + 4 if the element is signed, + half its bytes, rounded down.
    """
    found = []
    fields = _laid_out(message.FIELDS)  # not kept: most messages with live fields never need it again
    for part in names:
        name, _, element = part.partition("[")
        code, offset, count, _ = fields[name]
        if code not in "BHIbhi":
            raise ValueError(f"{message.NAME}.{name} is no whole number of up to 32 bits")
        size = struct.calcsize("<" + code)
        if "[" in part and not (element[-1:] == "]" and element[:-1].isdigit() and int(element[:-1]) < count):
            index = element.rstrip("]")
            raise ValueError(f"{message.NAME}.{name} has no element {index}")
        for index in [int(element[:-1])] if element else range(count or 1):
            found.append((offset + index * size) << 3 | (4 if code.islower() else 0) | size >> 1)
    return found


def _put_live(message):
    """Write the live values into the payload, as a frame that is encoded does."""
    for index, value in enumerate(message._live):
        code, offset = _live(message, index)
        bits = 8 * struct.calcsize(code)
        wrapped = ((value + (1 << (bits - 1))) & ((1 << bits) - 1)) - (1 << (bits - 1))
        struct.pack_into(code.lower(), message.wire, offset, wrapped)


def _take_live(message):
    """Read the live values from the payload, as a frame that is received does."""
    for index in range(len(message._live)):
        code, offset = _live(message, index)
        message._live[index] = struct.unpack_from(code.replace("I", "i"), message.wire, offset)[0]


def _live(message, index):
    image = message._image
    place = image[10 + 2 * index] | image[11 + 2 * index] << 8
    return "<" + "BHI-bhi"[place & 7], place >> 3


def _sentinels(text, count, is_float):
    if not text:
        return ()
    number = float if is_float else int
    if text[-1] == ":":
        return (number(text[:-1]),) + (None,) * count
    if "," in text:
        values = [number(part) if part else None for part in text.split(",")]
        return tuple(values + [None] * (count - len(values)))
    return (number(text),) * (count or 1)


def _is(value, sentinel):
    return value == sentinel or (sentinel is not None and value != value and sentinel != sentinel)  # noqa: PLR0124  NaN


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
