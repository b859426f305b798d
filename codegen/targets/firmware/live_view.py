"""What a builder writes on every build, as its template prints it."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class LiveView:
    """A field that is written on every build: into the message's live values, or packed into its payload.

    ``index`` is the place among the live values; None for fields that are packed with ``code`` at ``offset``, because
    they are longer than the values that a message keeps. A float field has a ``ratio``, what the value is multiplied
    and divided with, where it is written without making a float, and a ``divisor``, the text of the same, where one has
    to be made; its ``stand_in`` takes the place of None in steps.
    """

    comment: str
    source: str
    index: int | None
    code: str
    offset: int
    unknown: str | None
    unknown_comment: str
    before: tuple[str, str] | None
    scale: tuple[str, int, int] | None
    low: str
    high: str
    hole: str | None
    beside: str
    stand_in: str | None = None
    divisor: str | None = None
    ratio: tuple[int, int] | None = None

    @property
    def is_float(self) -> bool:
        """Whether the field is a float, which has its limits before it is divided."""
        return self.divisor is not None or self.ratio is not None

    @property
    def packs(self) -> bool:
        """Whether struct packs the value, or what stands for an unknown one."""
        return self.index is None and (self.ratio is None or self.unknown is not None)


@dataclass(frozen=True, slots=True)
class SpillView:
    """An array field over which one value is spread on every build, from the live value ``index`` on."""

    comment: str
    source: str
    index: int
    cells: int
    function: str
    stand_in: str | None
    low: int
    high: int
    before: tuple[str, str] | None
    scale: tuple[str, int, int] | None
    cell_high: int
    unused: int


@dataclass(frozen=True, slots=True)
class ExpressionView:
    """A live value that is an expression: a bitmask some bits of which depend on the state, or a number."""

    comment: tuple[str, ...]
    index: int
    expression: str

    @property
    def lines(self) -> tuple[str, ...]:
        """The expression as it is printed."""
        return _lines(f"live[{self.index}]", self.expression)


def _lines(target: str, expression: str) -> tuple[str, ...]:
    """The expression that a target gets, or, where the line gets long, a line for each of its terms."""
    if len(f"    {target} = {expression}") <= 120:
        return (expression,)
    first, *others = expression.split(" | ")
    return ("(", f"    {first}", *(f"    | {term}" for term in others), ")")


@dataclass(frozen=True, slots=True)
class FlagByteView:
    """A byte of a bitmask of 32 bits or more: as one number it would be too large for a board's small integers."""

    comment: tuple[str, ...]
    offset: int
    expression: str

    @property
    def lines(self) -> tuple[str, ...]:
        """The expression as it is printed."""
        return _lines(f"wire[{self.offset}]", self.expression)


@dataclass(frozen=True, slots=True)
class EachView:
    """Elements that take one value each of a list, on every build; ``function`` writes them, from ``index`` on.

    ``room`` is given where they go out together or not at all; ``spill`` is then what goes out instead, if anything.
    """

    comment: str
    values: str
    function: str
    index: int
    count: int
    first: int
    is_paged: bool
    room: int | None
    spill: SpillView | None
    before: tuple[str, str] | None
    scale: tuple[str, int, int] | None
    unknown: int
    low: str
    high: str
    hole: str | None
    beside: str

    @property
    def start(self) -> str:
        """The index of the first value, as an expression."""
        return f"page * {self.count}" if self.is_paged else str(self.first)


View = EachView | LiveView | SpillView | ExpressionView | FlagByteView
"""What a builder writes on every build for one field, or for some of its elements."""
