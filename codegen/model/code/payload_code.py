"""The spelling of functions that read the state and write a payload: answers give the content, this gives the code.

A firmware has each function twice, in machine code and in plain Python. Both are made of the same statements, which
answers give; where they differ, in reading a word and in writing a number, they ask for the spelling.
"""

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING

from codegen.model.answers.scaling import FloatParts
from codegen.model.code.storage import is_small
from codegen.model.dialect.dialect import Kind
from codegen.model.vehicle import Parameter, Quantity

if TYPE_CHECKING:
    from codegen.model.answers.answer import Elements

INDENT = "    "
UNKNOWN = "_UNKNOWN"
"""The value of an unknown word: a constant of the generated module, less than every limit."""


def indented(lines: list[str], levels: int = 1) -> list[str]:
    """The lines, so many levels further in."""
    return [INDENT * levels + line for line in lines]


ELEMENT = "place"
"""The element of a turn, in loops over the elements of a list."""


def each_element(first: int, end: int, lines: list[str]) -> list[str]:
    """The lines for each element from ``first`` to before ``end``."""
    if end - first == 1:
        return [f"{ELEMENT} = {first}", *lines]
    return [
        f"{ELEMENT} = {first}",
        f"while {ELEMENT} < {end}:",
        *indented([*lines, f"{ELEMENT} += 1"]),
    ]


class PayloadCode(ABC):
    """The spelling of one function. Values are whole numbers in stored steps, in the variable ``value`` for a time."""

    @abstractmethod
    def read(self, quantity: Quantity, element: str = "") -> str:
        """Return what is stored of a quantity, of one with elements that of the place ``element``: an expression."""

    @abstractmethod
    def is_unknown(self, quantity: Quantity, element: str = "") -> str:
        """Return whether a quantity that is stored, or its value at the place ``element``, is unknown: a condition."""

    @abstractmethod
    def is_known(self, quantity: Quantity, element: str = "") -> str:
        """Return whether a quantity that is stored, or its value at the place ``element``, is known: a condition."""

    @abstractmethod
    def half(self, quantity: Quantity, at: int, element: str = "") -> str:
        """One of the halves in which a quantity is kept, the low one at 0: an expression, 0 to 65535 while it is known.

        Of an unknown one the first is no number of 16 bits. With elements it is that of the place ``element``.
        """

    @abstractmethod
    def clock_half(self, word: str, at: int) -> str:
        """A half of a word of the clocks, as ``half`` has it; they have gone on to now."""

    @abstractmethod
    def is_set(self, quantity: Quantity) -> str:
        """Return whether a boolean that is stored is true: an expression that is 0 where it is not."""

    @abstractmethod
    def limit(self, quantity: Quantity) -> str:
        """The limit of a boolean that follows another quantity: a number, or where instances have their own, a word."""

    @abstractmethod
    def count(self, quantity: Quantity) -> str:
        """Return how many elements a quantity has: a number, or where instances have their own, a word."""

    @abstractmethod
    def number(self, component: str) -> str:
        """The number that messages give the instance, where that is counted on from a parameter."""

    @abstractmethod
    def parameter(self, parameter: Parameter) -> str:
        """Return what a parameter is in steps."""

    @abstractmethod
    def text(self, covers: "Elements", value: str | tuple[str, ...]) -> list[str]:
        """Write a text that is known at build time, or that of the instance, and NULs behind it."""

    @abstractmethod
    def letters(self, covers: "Elements", quantity: Quantity, *, forgotten: bool) -> list[str]:
        """Write a text that is stored, cut at a character where the field is shorter, and NULs behind it.

        The words of an unknown one are those of the empty text, unless it may have been ``forgotten``: of that only the
        first one says so.
        """

    @abstractmethod
    def chip(self, covers: "Elements") -> list[str]:
        """Write the number of the chip in hex, as much of it as the field holds."""

    @abstractmethod
    def condition(self, quantity: Quantity) -> tuple[str, str]:
        """Return what is to be read into ``value``, if anything, and the condition that a boolean is true."""

    @abstractmethod
    def store(
        self,
        covers: "Elements",
        value: int | float | str,
        at: int = 0,
        *,
        element: str = "",
        always: bool = True,
        over: bool = False,
    ) -> list[str]:
        """Write a number, or the value of an expression, into the element ``at`` of those that are covered.

        ``element`` is an expression, counted from there, in a loop over all that are covered: each of them is written.
        ``always``: these statements run at each call. Elements of which that cannot be said are 0 unless written.
        ``over``: one of several ways to write the same bytes, so that its zeros have to be written, too.
        """

    @abstractmethod
    def copy(self, covers: "Elements", halves: list[str], *, signed: bool, element: str = "") -> list[str]:
        """Write the halves of a number, the low one first, into an element of at least as many bytes, or fewer if they
        hold it; ``element`` is as ``store`` has it."""

    @abstractmethod
    def copy_half(self, covers: "Elements", at: int, value: str) -> list[str]:
        """Write the value of an expression into the half ``at`` of an element, or into one of a single byte."""

    @abstractmethod
    def is_written(self, covers: "Elements", value: int) -> str:
        """Return whether an element was written that has this number: a condition."""

    @abstractmethod
    def store_at(self, covers: "Elements", place: str, value: str) -> list[str]:
        """Write the value of an expression into the element ``place``, an expression, counted from the field's first.

        All elements are taken to be written by somebody at each call.
        """

    @abstractmethod
    def put_float(
        self, covers: "Elements", value: str, divisor: int, unknown: float | None, element: str = ""
    ) -> list[str]:
        """Write value / divisor into a float of 32 bits by whole numbers; ``unknown`` is what is stored otherwise.

        ``element`` is as ``store`` has it.
        """

    @abstractmethod
    def put_real(self, covers: "Elements", factor: FloatParts, element: str = "") -> list[str]:
        """Write ``value`` times a factor into a float of any size, by whole numbers of several words.

        ``element`` is as ``store`` has it.
        """

    @abstractmethod
    def flags(self, covers: "Elements", mask: int, conditional: list[tuple[int, Quantity]]) -> list[str]:
        """Write a bitmask into each element: the bits of ``mask``, and each value while its boolean is true."""

    def fill(self, covers: "Elements", value: int | float, first: int = 0) -> list[str]:
        """Write the same number into all elements from ``first`` on: one by one, or many of them in a loop."""
        left = covers.count - first
        if left <= LONGEST_RUN:
            return [line for index in range(first, covers.count) for line in self.store(covers, value, index)]
        if not self.is_plain(covers, value) and repr(value) not in {"0", "0.0"}:
            return each_element(first, covers.count, self.store(covers, value, element=ELEMENT))
        return [
            f"place = {covers.first + first}",
            f"while place < {covers.first + covers.count}:",
            *indented([*self.store_at(covers, "place", str(int(value))), "place += 1"]),
        ]

    @staticmethod
    def is_plain(covers: "Elements", value: float) -> bool:
        """Return whether an element is written with a number as a literal: others go out half by half."""
        return covers.field.type.kind is not Kind.FLOAT and is_small(value)

    def rest(self, covers: "Elements", value: int) -> list[str]:
        """Write the same number into the elements from the place ``place`` on, which nothing else has written."""
        if not self.is_plain(covers, value):
            element = f"({ELEMENT} - {covers.first})" if covers.first else ELEMENT
            return [
                f"while {ELEMENT} < {covers.first + covers.count}:",
                *indented([*self.store(covers, value, element=element), f"{ELEMENT} += 1"]),
            ]
        return [
            f"while place < {covers.first + covers.count}:",
            *indented([*self.store_at(covers, "place", str(value)), "place += 1"]),
        ]


LONGEST_RUN = 16
"""So many elements that get the same value are written one by one: each is two instructions, a turn of a loop more."""
