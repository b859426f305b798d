"""One case of a message: what is set in the state, and what must go out."""

from fractions import Fraction
from textwrap import wrap

from codegen.frozen import dataclass
from codegen.model.answers.known import Stored
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.targets.suite.expected import Wire

Setting = tuple[str, str, int | float | str | list[int | float | str | None] | None, int]
"""Component, attribute, value and instance; ``"nan"``, ``"inf"`` and ``"-inf"`` stand for the floats.

The component ``parameters`` has the parameters by their attributes.
"""


@dataclass(frozen=True, slots=True)
class MessageCase:
    """A state and the message that must come of it by a ``table``. ``requirement`` is the criterion that asks for it.

    ``also`` are further criteria that it shows: those of fields that are the same in every message.
    """

    name: str
    requirement: str
    message: str
    table: str
    instance: int
    settings: tuple[Setting, ...]
    expect: dict[str, Wire]
    page: int = 0
    also: tuple[str, ...] = ()


def set_to(quantity: Quantity, value: Stored, instance: int) -> Setting:
    """Return how a test sets a quantity of an instance."""
    plain = list(map(as_set, value)) if isinstance(value, tuple) else as_set(value)
    if quantity.kind is QuantityKind.BOOLEAN:
        plain = bool(value)
    return (quantity.component, quantity.attribute, plain, instance)


def literal_of(value: Stored) -> str:
    """The same as a literal of generated Python, in the body of a function; a list takes several lines where long."""
    if not isinstance(value, tuple):
        return repr(as_set(value))
    text = ", ".join(repr(as_set(each)) for each in value)
    if len(text) < 80:
        return f"[{text}]"
    lines = wrap(f"{text},", 112, break_on_hyphens=False)
    return "\n    ".join(("[", *(f"    {line}" for line in lines), "]"))


def as_set(value: int | Fraction | str | None) -> int | float | str | None:
    """A number or a text as code sets it."""
    return float(value) if isinstance(value, Fraction) else value
