"""Named values of a message as expressions of the generated Python."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition, WireField


@dataclass(frozen=True, slots=True)
class Reading:
    """A named value of a message: an expression over ``get`` and ``raw``, the fields as read and as they stand.

    ``unit`` is that of the result, ``doc`` says for people what a quantity is, ``enum`` names the numbers that it may
    take, ``field`` is where it stands. ``uses`` are the names of functions and tables in the expression. With
    ``is_by_element`` there is one value for each element.
    """

    name: str
    expression: str
    unit: str
    doc: str
    field: str
    enum: str = ""
    uses: tuple[str, ...] = ()
    is_by_element: bool = False


def scaled(expression: str, factor: Fraction) -> tuple[str, tuple[str, ...]]:
    """An expression times a factor, and what that uses."""
    if factor == 1:
        return expression, ()
    return f"scaled({expression}, {factor.numerator}, {factor.denominator})", ("scaled",)


def plausible(expression: str, low: Fraction | None, high: Fraction | None) -> tuple[str, tuple[str, ...]]:
    """An expression that is unknown beyond the limits, of which each may be None, and what that uses."""
    if low is None and high is None:
        return expression, ()
    ends = ("None" if end is None else str(int(end) if end.denominator == 1 else float(end)) for end in (low, high))
    return f"plausible({expression}, {', '.join(ends)})", ("plausible",)


def flag_names(field: WireField, enum: EnumDefinition) -> Reading:
    """The names of the bits that are set in a field."""
    expression = f'flags(enum_names.{enum.name}, get("{field.name}"))'
    return Reading(field.name, expression, "", "", field.name, uses=("flags", enum.name))
