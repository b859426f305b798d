"""Fields of type double, on boards whose floats have 32 bits, too.

Such a board reads a double as the nearest of its floats, and of what is beyond all of them its struct makes infinity.
Here these doubles, which are whole numbers, come as such, exactly; and a whole number goes out as the nearest double,
not as the nearest float of the board. ratio() and set_ratio() carry every double exactly.
"""

import struct

_INFINITY = float("inf")
_EXPONENTS = 0x7FF  # of what is not finite
_HAS_DOUBLES = struct.unpack("<d", b"\0\0\0\0\0\0\xf0\x47")[0] != _INFINITY  # 2 ** 128, which no float of 32 bits is


def ratio(message, name, element=0):
    """Return a double of a message as two whole numbers, numerator and denominator, in lowest terms.

    ValueError: what stands in the field is not finite, or the field has no such double. KeyError: there is no such
    field.
    """
    bits = struct.unpack_from("<Q", message.wire, _place(message, name, element))[0]
    if bits >> 52 & _EXPONENTS == _EXPONENTS:
        raise ValueError(f"{message.NAME}.{name} is not finite")
    number, exponent = _parts(bits)
    while number and not number & 1 and exponent < 0:
        number >>= 1
        exponent += 1
    if not number:
        exponent = 0
    return (number << exponent, 1) if exponent > 0 else (number, 1 << -exponent)


def set_ratio(message, name, numerator, denominator=1, element=0):
    """Write the double that is nearest to a fraction of whole numbers, of two the even one; -0.0 is none of these.

    ValueError: it is beyond a double, or the field has no such double. KeyError: there is no such field.
    """
    at = _place(message, name, element)
    if denominator < 0:
        numerator, denominator = -numerator, -denominator
    try:
        bits = _nearest(numerator, denominator)
    except (OverflowError, ZeroDivisionError):
        raise ValueError(f"{message.NAME}.{name} cannot carry {numerator} / {denominator}") from None
    struct.pack_into("<Q", message.wire, at, bits)


def _exact_unpack_from(form, data, at=0):
    """Do what struct's unpack_from() does, with whole numbers for doubles that no float of the board is near."""
    values = struct.unpack_from(form, data, at)
    if form[-1] == "d" and (_INFINITY in values or -_INFINITY in values):
        return tuple([_finite(values[index], data, at + 8 * index) for index in range(len(values))])
    return values


def pack_into(form, data, at, *values):
    """Do what struct's pack_into() does, with the nearest double for a whole number; OverflowError: there is none.

    MicroPython does not round whole numbers of more than 53 bits to the nearest where it has doubles, either.
    """
    struct.pack_into(form, data, at, *values)
    if form[-1] == "d":
        for index in range(len(values)):
            if type(values[index]) is int:
                struct.pack_into("<Q", data, at + 8 * index, _nearest(values[index], 1))


unpack_from = struct.unpack_from if _HAS_DOUBLES else _exact_unpack_from


def _place(message, name, element):
    """Return where a double stands in the payload."""
    from fields import layout, missing  # noqa: PLC0415  that module imports this one

    fields = layout(type(message))
    if name not in fields:
        raise missing(message, name)
    form, offset, count = fields[name][:3]
    if form[-1] != "d" or not 0 <= element < (count or 1):
        what = "double" if form[-1] != "d" else f"element {element}"
        raise ValueError(f"{message.NAME}.{name} has no {what}")
    return offset + 8 * element


def _finite(value, data, at):
    """Return a value that was read as infinite, or the whole number that the double is."""
    bits = struct.unpack_from("<Q", data, at)[0] if abs(value) == _INFINITY else _EXPONENTS << 52
    if bits >> 52 & _EXPONENTS == _EXPONENTS:
        return value
    number, exponent = _parts(bits)
    return number << exponent


def _parts(bits):
    """Return the whole number that a finite double is, times 2 to the power of the second."""
    exponent = bits >> 52 & _EXPONENTS
    number = bits & (1 << 52) - 1
    if exponent:
        number |= 1 << 52
    return (-number if bits >> 63 else number), (exponent or 1) - 1075


def _nearest(numerator, denominator):
    """Return the bits of the double that is nearest to a fraction."""
    sign = 1 << 63 if numerator < 0 else 0
    numerator = abs(numerator)
    if not numerator:
        return 0 // denominator
    # The quotient has 53 bits, or one more, and less of a denormal number.
    exponent = max(_length(numerator) - _length(denominator) - 53, -1074)
    quotient = _shifted(numerator, denominator, exponent)[0]
    if quotient >> 53:
        exponent += 1
    quotient, rest, divisor = _shifted(numerator, denominator, exponent)
    if 2 * rest > divisor or (2 * rest == divisor and quotient & 1):
        quotient += 1
    # The highest bit of a normal number, and one that rounding has carried, count up the exponent.
    bits = (exponent + 1074 << 52) + quotient
    if bits >= _EXPONENTS << 52:
        raise OverflowError("beyond a double")
    return sign | bits


def _shifted(numerator, denominator, exponent):
    """Return quotient and rest of a fraction by 2 to a power, and what it was divided by."""
    if exponent > 0:
        denominator <<= exponent
    else:
        numerator <<= -exponent
    return numerator // denominator, numerator % denominator, denominator


def _length(number):
    """Return how many bits a number has."""
    length = 0
    while number >> 64:
        number >>= 64
        length += 64
    while number:
        number >>= 1
        length += 1
    return length
