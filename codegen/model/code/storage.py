"""The storage of one number in words of the state: in one word, in halves of 16 bits, or as the bits of a float.

A word of 32 bits holds a small integer, which MicroPython reads without allocating on every port. What needs more is
kept in halves, one to a word and the low one first: machine code and plain Python copy them to the wire as they are.
While a value is unknown, its first word is -2 ** 30, which no half is.
"""

import struct
from enum import Enum
from fractions import Fraction
from math import isfinite

from codegen.model.dialect.dialect import Kind, WireType

SMALL_INT_MAX = 2**30 - 1
"""Largest integer that MicroPython keeps without allocating on 32-bit ports: they have 31 bits, with the sign."""
HALF = 16
"""Bits of a half."""


class Storage(Enum):
    """The ways in which a number is kept, each with the ``struct`` code of what its halves say."""

    SMALL = ""
    INT32 = "i"
    UINT32 = "I"
    INT64 = "q"
    UINT64 = "Q"
    BINARY32 = "f"
    BINARY64 = "d"

    @property
    def halves(self) -> int:
        """Return how many halves there are; 0 for a small integer in one word."""
        return struct.calcsize(f"<{self.value}") // 2

    @property
    def words(self) -> int:
        """Return how many words of the state it takes."""
        return self.halves or 1

    @property
    def is_float(self) -> bool:
        """Return whether the halves are those of an IEEE 754 number."""
        return self in (Storage.BINARY32, Storage.BINARY64)

    @property
    def is_signed(self) -> bool:
        """Return whether the highest bit of an integer is its sign."""
        return self in (Storage.SMALL, Storage.INT32, Storage.INT64)

    @property
    def limits(self) -> tuple[int | Fraction, int | Fraction]:
        """The smallest and the largest number; of floats the finite ones."""
        if self is Storage.SMALL:
            return -SMALL_INT_MAX, SMALL_INT_MAX
        if self.is_float:
            largest = Fraction(_largest_float(self.value))
            return -largest, largest
        bits = HALF * self.halves
        return (-(1 << bits - 1), (1 << bits - 1) - 1) if self.is_signed else (0, (1 << bits) - 1)

    def held(self, value: float) -> int | float:
        """The number that is kept: that itself, or the nearest float of this size."""
        if not self.is_float:
            return int(value)
        rounded: float = struct.unpack(f"<{self.value}", struct.pack(f"<{self.value}", value))[0]
        return rounded

    def nearest(self, value: Fraction) -> Fraction:
        """Return the float that comes nearest to a value; for one beyond all the last of them."""
        low, high = self.limits
        return Fraction(self.held(float(max(low, min(high, value)))))

    def split(self, value: float) -> tuple[int, ...]:
        """The halves of a number, the low one first."""
        data = struct.pack(f"<{self.value}", float(value) if self.is_float else int(value))
        return struct.unpack(f"<{self.halves}H", data)


def _largest_float(code: str) -> float:
    data = b"\xff\xff\x7f\x7f" if code == "f" else b"\xff" * 6 + b"\xef\x7f"
    largest: float = struct.unpack(f"<{code}", data)[0]
    return largest


def is_small(number: float) -> bool:
    """Return whether a board's small integers hold a number: in machine code a larger literal is an object, no number.

    Compiled it is the address of that, and from a source the module cannot be imported at all.
    """
    return number == int(number) and -SMALL_INT_MAX - 1 <= number <= SMALL_INT_MAX if isfinite(number) else False


def storage_of(low: int, high: int) -> Storage | None:
    """The smallest way to keep all whole numbers from ``low`` to ``high``; None where none holds them."""
    for storage in (Storage.SMALL, Storage.INT32, Storage.UINT32, Storage.INT64, Storage.UINT64):
        smallest, largest = storage.limits
        if smallest <= low and high <= largest:
            return storage
    return None


def float_storage(wire_types: set[WireType]) -> Storage | None:
    """Return how to keep what goes out in fields of these types, all of them floats and of one size; else None."""
    sizes = {wire_type.size for wire_type in wire_types if wire_type.kind is Kind.FLOAT}
    if len(sizes) != 1 or any(wire_type.kind is not Kind.FLOAT for wire_type in wire_types):
        return None
    return Storage.BINARY32 if sizes == {4} else Storage.BINARY64
