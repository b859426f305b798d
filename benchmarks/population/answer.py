"""An answer to an element of a field, and what it means on the wire: from the documents, not from the generator."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from population.fields import Field

SMALL = 2**30 - 1
"""The largest number in a word of the state."""
STALE_S = 1
"""After how many seconds a value is too old, where the table says so."""


@dataclass(frozen=True)
class Answer:
    """The answer for an element of a field.

    ``kind`` is number, enum, flags, clock, text or fixed. ``written`` is the answer in the table of the message,
    ``quantity`` what state.yaml says of the quantity ``name``, by key. Of a number: 1 ``unit`` is ``wire`` on the wire
    and ``steps`` as it is kept, None where that is a float; ``attribute`` is the name of what is kept, if it has
    another one; ``low`` and ``high`` are the limits in steps, or of a float in units; ``least`` and ``most`` those of
    the table. Of a text ``steps`` is how many bytes are kept, None for a constant. ``listed`` is the length of the
    list that answers the whole array, of which this is one value.
    """

    field: Field
    at: int
    kind: str
    written: str
    name: str = ""
    quantity: tuple[tuple[str, str], ...] = ()
    wire: Fraction = Fraction(1)
    steps: Fraction | None = None
    attribute: str = ""
    low: Fraction | None = None
    high: Fraction | None = None
    least: Fraction | None = None
    most: Fraction | None = None
    rounding: str = "nearest"
    initial: Fraction | None = None
    is_aging: bool = False
    withholds: bool = False
    microseconds: int = 0
    listed: int = 0
    flags: tuple[tuple[str, int], ...] = ()

    @cached_property
    def label(self) -> str:
        """MESSAGE.field, with the number of the element in arrays."""
        index = f"[{self.at}]" if self.field.count and self.field.code != "s" else ""
        return f"{self.field.message}.{self.field.name}{index}"

    @property
    def key(self) -> str:
        """The key of the table."""
        return self.field.name if self.listed else self.label.partition(".")[2]

    @property
    def is_first(self) -> bool:
        """Return whether it is the one of a list that stands for all in the specification."""
        return not self.listed or self.at == 0

    @property
    def hides_all(self) -> bool:
        """Return whether the whole array is unknown while this is: the sentinel speaks for all of it."""
        return bool(self.listed) and self.field.unknown[0] is not None and self.field.unknown[-1] is None

    @cached_property
    def factor(self) -> Fraction:
        """Return the number on the wire for one stored step."""
        assert self.steps is not None
        return self.wire / self.steps

    @cached_property
    def whole_ends(self) -> tuple[int, int]:
        """The same with all limits that are written.

        One of the quantity is rounded as its values are; of one of the table that lies between two steps of the field
        it is the step inside.
        """
        low, high = self.ends
        lows = [-(-end * self.factor // 1) for end in (self.least,) if end is not None]
        highs = [end * self.factor // 1 for end in (self.most,) if end is not None]
        lows += [self.rounded(end) for end in (self.low,) if end is not None]
        highs += [self.rounded(end) for end in (self.high,) if end is not None]
        return int(max(low, *lows)) if lows else int(low), int(min(high, *highs)) if highs else int(high)

    def rounded(self, steps: Fraction) -> int:
        """Return the steps on the wire, rounded as the table says."""
        over, under = steps.numerator * self.factor.numerator, steps.denominator * self.factor.denominator
        if self.rounding == "down":
            return over // under
        if self.rounding == "up":
            return -(-over // under)
        size = abs(over) // under if self.rounding == "toward_zero" else (2 * abs(over) + under) // (2 * under)
        return size if over >= 0 else -size

    @property
    def unknown(self) -> int | float | None:
        """The sentinel of the element."""
        return self.field.unknown[self.at]

    @cached_property
    def ends(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest number that a whole field carries: type, dialect, and no sentinel at an end."""
        field, unknown = self.field, self.unknown
        low, high = (
            (-(1 << field.bits - 1), (1 << field.bits - 1) - 1) if field.code.islower() else (0, (1 << field.bits) - 1)
        )
        low = low if field.low is None else max(low, -(-field.low // 1))
        high = high if field.high is None else min(high, field.high // 1)
        if self.kind != "enum":
            low, high = low + (low == unknown), high - (high == unknown)
        return Fraction(low), Fraction(high)
