# Generated from templates/codec/live_fields.py: do not edit.
# Inputs: b287faf9b935f129
"""Live fields: values of a message that change often, in an array of their own beside the payload."""

import struct
from struct import pack_into, unpack_from

from fields import layout_of, missing

# The parts of a code in image: size of a place and code of struct; a uint32 is read as an int32.
_KINDS = ((4, "<i"), (2, "<H"), (2, "<h"), (1, None))
_OTHERS = {1: "<B", 2: "<H", 4: "<i", 9: "<b", 10: "<h", 12: "<i"}


def places(message, names):
    """Return what a message's image has to hold about its live fields, `name` or `name[index]`; see frames_plain.

    All from byte 9 to the start of the payload, and how many values there are.
    """
    fields = layout_of(type(message))  # not kept: most messages with live fields never need it again
    kinds = [[], [], [], []]
    count = 0
    for part in (names,) if isinstance(names, str) else names:
        name, _, element = part.partition("[")
        if name not in fields:
            raise missing(message, name)
        form, offset, elements = fields[name][:3]
        code = form[-1]
        if code not in "BHIbhi":
            raise ValueError(f"{message.NAME}.{name} is no whole number of up to 32 bits")
        size = struct.calcsize("<" + code)
        if "[" in part and not (element[-1:] == "]" and element[:-1].isdigit() and int(element[:-1]) < elements):
            index = element.rstrip("]")
            raise ValueError(f"{message.NAME}.{name} has no element {index}")
        for index in [int(element[:-1])] if element else range(elements or 1):
            at = offset + index * size
            if size > 1 and at % size == 0:
                kind = 0 if size == 4 else 2 if code == "h" else 1
                kinds[kind] += [at // size, count]
            else:
                kinds[3] += [at, count, size | (8 if code.islower() else 0)]
            count += 1
    counts = [len(kind) // (3 if kind is kinds[3] else 2) for kind in kinds]
    entries = kinds[0] + kinds[1] + kinds[2] + kinds[3]
    start = (14 + len(entries) + 4) & -4
    gap = [0] * (start - 15 - len(entries))
    counts.append(start >> 2)
    return bytes(counts + entries + gap) + b"\1", count


def take(message, field):
    """Read the live values of a field from the payload."""
    _each_live(message, field, _take)


def put(message, field):
    """Write the live values of a field into the payload."""
    _each_live(message, field, _put)


def _each_live(message, field, do):
    """Call do(message, code, offset, index) for each live value that stands in a field."""
    image = message._image
    end = field[1] + struct.calcsize(field[0])
    at = 14
    for kind in range(4):
        size, code = _KINDS[kind]
        for _ in range(image[9 + kind]):
            if field[1] <= image[at] * size < end:
                do(message, code or _OTHERS[image[at + 2]], image[at] * size, image[at + 1])
            at += 2 if code else 3


def _put(message, code, offset, index):
    bits = 8 * struct.calcsize(code)
    pack_into(code.upper(), message.wire, offset, message.live[index] & ((1 << bits) - 1))


def _take(message, code, offset, index):
    message.live[index] = unpack_from(code, message.wire, offset)[0]
