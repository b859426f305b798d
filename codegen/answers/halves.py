"""Conditions on a number that is kept in halves of 16 bits, the low one first: viper and plain Python compare those.

A float is compared by its bits: its highest one is the sign, and the others grow with the magnitude.
"""

import math
import struct
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from codegen.answers.limits import Bounds
from codegen.model.scaling import Scaling
from codegen.model.storage import HALF, Storage

_TOP = 1 << HALF - 1
_FULL = (1 << HALF) - 1

Number = int | Fraction


def above(halves: Sequence[str], limit: Number, storage: Storage) -> str:
    """The condition that what the halves say is more than a limit that the storage holds."""
    split = storage.split(float(limit) if storage.is_float else int(limit))
    if not storage.is_float:
        return _more(*_ordered(halves, split, storage))
    top = halves[-1]
    if limit < 0:
        return f"{top} < 0x{_TOP:X} or {_less(halves, split)}"
    return f"{top} < 0x{_TOP:X} and ({_more(halves, split)})"


def below(halves: Sequence[str], limit: Number, storage: Storage) -> str:
    """The condition that what the halves say is less than a limit that the storage holds."""
    split = storage.split(float(limit) if storage.is_float else int(limit))
    if not storage.is_float:
        return _less(*_ordered(halves, split, storage))
    if limit > 0:
        return f"{halves[-1]} >= 0x{_TOP:X} or {_less(halves, split)}"
    return _more(halves, split if limit else (*split[:-1], _TOP))


def equal(halves: Sequence[str], number: Number, storage: Storage) -> str:
    """The condition that the halves say a number; 0 has two signs as a float."""
    split = storage.split(float(number) if storage.is_float else int(number))
    parts = [f"{half} == 0x{value:X}" for half, value in zip(halves, split, strict=True)]
    if storage.is_float and number == 0:
        parts[-1] = f"({halves[-1]} & 0x{_TOP - 1:X}) == 0"
    return " and ".join(reversed(parts))


def float_within(scaling: Scaling, sentinel: float | None, storage: Storage) -> Scaling:
    """The limits as floats of this size that do not pass them; beside a sentinel is the next float, away from 0."""
    low = storage.nearest(scaling.low)
    high = storage.nearest(scaling.high)
    if low < scaling.low:
        low = _stepped(low, storage, up=True)
    if high > scaling.high:
        high = _stepped(high, storage, up=False)
    if sentinel is None or not math.isfinite(sentinel) or not low <= sentinel <= high:
        return replace(scaling, low=low, high=high)
    hole = Fraction(storage.held(sentinel))
    beside = _stepped(hole, storage, up=hole == low or (hole >= 0 and hole != high))
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


def _ordered(halves: Sequence[str], split: Sequence[int], storage: Storage) -> tuple[list[str], list[int]]:
    """The same in the order of the numbers: with a sign, the highest half begins with the smallest ones."""
    if not storage.is_signed:
        return list(halves), list(split)
    return [*halves[:-1], f"({halves[-1]} ^ 0x{_TOP:X})"], [*split[:-1], split[-1] ^ _TOP]


def _more(halves: Sequence[str], limit: Sequence[int]) -> str:
    """That numbers, compared from the highest half on, are more than others."""
    return _compared(halves, limit, ">", _FULL)


def _less(halves: Sequence[str], limit: Sequence[int]) -> str:
    return _compared(halves, limit, "<", 0)


def _compared(halves: Sequence[str], limit: Sequence[int], sign: str, end: int) -> str:
    """Half by half: the first that differs from its limit decides. No half is beyond ``end``."""
    ways, same = [], ""
    for at in reversed(range(len(halves))):
        if limit[at] != end:
            ways.append(f"{same}{halves[at]} {sign} 0x{limit[at]:X}")
        same += f"{halves[at]} == 0x{limit[at]:X} and "
        if all(value == end for value in limit[:at]):
            break
    return " or ".join(ways) or "False"
