"""Expressions of numbers on the wire, in plain Python and in machine code."""

from fractions import Fraction

from codegen.model.dialect.dialect import WireField

_GIVEN = 12
"""The place to which machine code writes a number that becomes a whole one."""


class Plain:
    """The spelling in plain Python, where it differs."""

    def half(self, offset: int) -> str:
        """A half of a number on the wire: an expression."""
        return f"(wire[{offset}] | wire[{offset + 1}] << 8)"

    def whole(self, word: str, low: str, factor: Fraction) -> list[str]:
        """Store the whole number that comes of a float, the high half of which is ``value``, times a factor."""
        return [f"{word} = whole_of_float(value, {bare(low)}, {factor.numerator}, {factor.denominator})"]


class Machine(Plain):
    """The spelling in machine code: a half at a multiple of two, as most are, is read at once."""

    def half(self, offset: int) -> str:
        return super().half(offset) if offset % 2 else f"halves[{offset // 2}]"

    def whole(self, word: str, low: str, factor: Fraction) -> list[str]:
        given = ("value", bare(low), factor.numerator, factor.denominator)
        return [
            *(f"counts[{at}] = {each}" for at, each in enumerate(given, _GIVEN)),
            f"whole_of_float(int(counts) + {4 * _GIVEN})",
            f"{word} = counts[{_GIVEN}]",
        ]


def bare(half: str) -> str:
    return half.removeprefix("(").removesuffix(")")


def number_of(field: WireField, offset: int, code: Plain) -> str:
    """The expression of a number of one or two bytes."""
    plain = f"wire[{offset}]" if field.type.size == 1 else code.half(offset)
    if field.type.minimum == 0:
        return bare(plain)
    top = 1 << 8 * field.type.size - 1
    return f"({plain} ^ 0x{top:X}) - 0x{top:X}"
