"""Conditions on a number that is kept in halves of 16 bits, the low one first: viper and plain Python compare those.

A float is compared by its bits: its highest one is the sign, and the others grow with the magnitude.
"""

from collections.abc import Sequence
from fractions import Fraction

from codegen.model.code.storage import HALF, Storage

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


def beyond(halves: Sequence[str], low: Number | None, high: Number | None, storage: Storage) -> str:
    """The condition that what the halves say is less than one limit or more than another; None is no limit.

    Most numbers are far from their limits, and of these the highest half says so at once.
    """
    ways = [] if low is None else [below(halves, low, storage)]
    ways += [] if high is None else [above(halves, high, storage)]
    far = " or ".join(ways)
    near = _near(halves[-1], low, high, storage) if " == " in far else ""
    return f"{near} and ({far})" if near else far


def _near(top: str, low: Number | None, high: Number | None, storage: Storage) -> str:
    """Return a condition true for the highest half of all numbers beyond a limit, and of few others; empty without."""
    if storage.is_float:
        if low is None or high is None or not low <= 0 <= high:
            return ""
        least = min(storage.split(float(limit))[-1] & (_TOP - 1) for limit in (low, high))
        return f"({top} & 0x{_TOP - 1:X}) >= 0x{least:X}"
    if storage.is_signed and low is not None and high is not None and low < 0 <= high:
        # As if there were no sign, what is beyond stands between the largest number and the smallest.
        first, last = (storage.split(int(limit))[-1] for limit in (high, low))
        return f"{top} >= 0x{first:X} and {top} <= 0x{last:X}"
    ways = []
    for limit, sign in ((low, "<="), (high, ">=")):
        if limit is not None:
            (half,), (end,) = _ordered([top], storage.split(int(limit))[-1:], storage)
            ways.append(f"{half} {sign} 0x{end:X}")
    return ways[0] if len(ways) == 1 else f"({' or '.join(ways)})"


def equal(halves: Sequence[str], number: Number, storage: Storage) -> str:
    """The condition that the halves say a number; 0 has two signs as a float."""
    split = storage.split(float(number) if storage.is_float else int(number))
    parts = [f"{half} == 0x{value:X}" for half, value in zip(halves, split, strict=True)]
    if storage.is_float and number == 0:
        parts[-1] = f"({halves[-1]} & 0x{_TOP - 1:X}) == 0"
    return " and ".join(reversed(parts))


def _ordered(halves: Sequence[str], split: Sequence[int], storage: Storage) -> tuple[list[str], list[int]]:
    """The same in the order of the numbers: with a sign, the highest half begins with the smallest ones."""
    if not storage.is_signed:
        return list(halves), list(split)
    return [*halves[:-1], f"({halves[-1]} ^ 0x{_TOP:X})"], [*split[:-1], split[-1] ^ _TOP]


def _more(halves: Sequence[str], limit: Sequence[int]) -> str:
    """Return the condition that numbers, compared from the highest half on, are more than others."""
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
