"""What is stored of the state, and the numbers that it makes on the wire."""

import math
from collections.abc import Mapping

from codegen.model.vehicle import Parameter, Quantity

Stored = int | tuple[int | None, ...] | None
"""A stored integer, or one for each element; None is unknown, a boolean is 0 or 1."""

Known = Mapping[str, Stored]
"""What is stored by ``component.quantity`` or name of a parameter."""

Value = int | float | str
"""One element on the wire; a text is one."""


def single(known: Known, name: str) -> int | None:
    """The one integer that is stored under a name; None where it is unknown."""
    value = known[name]
    assert not isinstance(value, tuple)
    return value


def stored_value(source: Quantity | Parameter, known: Known) -> int | None:
    """What a builder reads of a source: a parameter has its default until it is set, a quantity what stands in."""
    if isinstance(source, Parameter):
        return single(known, source.name) if source.name in known else source.default
    value = single(known, source.path)
    return source.initial if value is None else value


def shown_value(value: Value) -> str:
    """A value as documents print it: NaN, a number, or a text in quotes."""
    return "NaN" if isinstance(value, float) and math.isnan(value) else repr(value)
