"""Numbers of parameters bytewise: an integer is its own bytes, the lowest first, and zeros fill the rest of the float.

No float is made of these bytes: -1 would be a NaN, of which floats do not keep all bits.
"""

from struct import calcsize, pack_into, unpack_from

import dialect
from micropython import const

_FLOAT = "<f"
_SIGNED = ("<b", "<h", "<i")
_SIZE = const(4)  # bytes of param_value


def put(wire, at, kind, value):
    """Write a value into a payload as a MAV_PARAM_TYPE.

    Beyond what that carries, which code may set, the nearest number that it does goes out.
    """
    code = _code(kind)
    pack_into("<I", wire, at, 0)
    if code != _FLOAT:
        values = 1 << 8 * calcsize(code)
        smallest = -(values >> 1) if code in _SIGNED else 0
        if value <= smallest:
            value = smallest
        elif value >= smallest + values:  # compared as it is: infinity is no integer
            value = smallest + values - 1
        else:
            value = min(round(value), smallest + values - 1)
    pack_into(code, wire, at, value)


def number(wire, at, kind):
    """Return what a payload has as a MAV_PARAM_TYPE; None where anything but zeros follows an integer."""
    code = _code(kind)
    if any(wire[at + calcsize(code) : at + _SIZE]):
        return None
    return unpack_from(code, wire, at)[0]


def _code(kind):
    """Return what struct calls a MAV_PARAM_TYPE."""
    if kind == dialect.MAV_PARAM_TYPE_REAL32:
        return _FLOAT
    if kind == dialect.MAV_PARAM_TYPE_UINT8:
        return "<B"
    if kind == dialect.MAV_PARAM_TYPE_INT8:
        return "<b"
    if kind == dialect.MAV_PARAM_TYPE_UINT16:
        return "<H"
    if kind == dialect.MAV_PARAM_TYPE_INT16:
        return "<h"
    return "<I" if kind == dialect.MAV_PARAM_TYPE_UINT32 else "<i"
