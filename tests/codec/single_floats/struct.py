"""Stands in for the struct of a board whose floats have 32 bits: doubles are read and written by way of such a float.

This interpreter, whose floats have 64 bits, finds it in place of its own module, which is called ustruct, too.
"""

import ustruct
from ustruct import calcsize

__all__ = ("calcsize", "pack", "pack_into", "unpack", "unpack_from")


def _as_single(form, values):
    if "d" not in form:
        return values
    return ustruct.unpack("<%df" % len(values), ustruct.pack("<%df" % len(values), *values))  # noqa: UP031


def unpack_from(form, data, at=0):
    """Do what the board's does."""
    return _as_single(form, ustruct.unpack_from(form, data, at))


def unpack(form, data):
    """Do what the board's does."""
    return unpack_from(form, data)


def pack_into(form, data, at, *values):
    """Do what the board's does."""
    ustruct.pack_into(form, data, at, *_as_single(form, values))


def pack(form, *values):
    """Do what the board's does."""
    return ustruct.pack(form, *_as_single(form, values))
