"""Limits of a float that goes to the wire as it is kept: floats of its size, and those beside them."""

import math
import struct
from dataclasses import replace
from fractions import Fraction

from codegen.answers.limits import Bounds
from codegen.model.answers.scaling import Scaling
from codegen.model.code.storage import HALF, Storage

_SMALLEST = {Storage.BINARY32: Fraction(1, 1 << 126), Storage.BINARY64: Fraction(1, 1 << 1022)}
"""The smallest floats above 0 that are normal (IEEE 754)."""


def float_within(scaling: Scaling, sentinel: float | None, storage: Storage) -> Scaling:
    """The limits as floats of this size that do not pass them; beside a sentinel is the next float, away from 0.

    Beside 0 is the smallest that is normal, where that is within: who takes smaller ones for 0 would read the sentinel.
    """
    low = storage.nearest(scaling.low)
    high = storage.nearest(scaling.high)
    if low < scaling.low:
        low = _stepped(low, storage, up=True)
    if high > scaling.high:
        high = _stepped(high, storage, up=False)
    if sentinel is None or not math.isfinite(sentinel) or not low <= sentinel <= high:
        return replace(scaling, low=low, high=high)
    hole = Fraction(storage.held(sentinel))
    up = hole == low or (hole >= 0 and hole != high)
    normal = _SMALLEST[storage] if up else -_SMALLEST[storage]
    beside = normal if hole == 0 and low <= normal <= high else _stepped(hole, storage, up=up)
    return replace(scaling, low=low, high=high, hole=hole, beside=beside)


def float_bounds(bounds: Bounds, storage: Storage) -> Bounds:
    """The bounds as the floats that come nearest to them."""
    return Bounds(*(None if end is None else storage.nearest(end) for end in (bounds.low, bounds.high)))


def next_float(value: Fraction, storage: Storage) -> Fraction:
    """The next larger float."""
    return _stepped(value, storage, up=True)


def _stepped(value: Fraction, storage: Storage, *, up: bool) -> Fraction:
    bits = sum(half << HALF * at for at, half in enumerate(storage.split(float(value))))
    away = up == (value >= 0)
    if value == 0:
        bits = 1 if up else 1 | 1 << HALF * storage.halves - 1
    else:
        bits += 1 if away else -1
    data = bits.to_bytes(storage.halves * 2, "little")
    found: float = struct.unpack(f"<{storage.value}", data)[0]
    assert math.isfinite(found)
    return Fraction(found)
