"""Stored values of the state, and the numbers that they make on the wire."""

import math
from collections.abc import Mapping
from fractions import Fraction

from codegen.model.code.letters import cut
from codegen.model.vehicle import Parameter, Quantity

Stored = int | Fraction | str | tuple[int | Fraction | None, ...] | None
"""A stored integer, or one for each element, or the exact value of a float, or a text as it was set; None is unknown.

A boolean is 0 or 1."""

Known = Mapping[str, Stored]
"""Stored values by ``component.quantity`` or name of a parameter."""

Value = int | float | str
"""One element on the wire; a text is one."""


def single(known: Known, name: str) -> int | None:
    """The one integer that is stored under a name; None where it is unknown."""
    value = known[name]
    assert value is None or isinstance(value, int)
    return value


def stored_value(source: Quantity | Parameter, known: Known) -> int | None:
    """Return what a builder reads of a source: a parameter has its default until it
    is set, a quantity what stands in.
    """
    if isinstance(source, Parameter):
        return single(known, source.name) if source.name in known else source.default
    value = single(known, source.path)
    return value if value is not None or source.initial is None else int(source.initial)


def kept_number(source: Quantity, known: Known) -> int | Fraction | None:
    """Return what is kept of a quantity of any storage: set beyond its limits, it is at the limit."""
    value = known[source.path]
    value = source.initial if value is None else value
    assert not isinstance(value, tuple | str)
    return None if value is None else max(source.minimum, min(source.maximum, value))


def kept_text(source: Quantity, known: Known) -> str | None:
    """Return what is kept of a text; None while it is unknown."""
    value = known[source.path]
    value = source.initial if value is None else value
    assert value is None or isinstance(value, str)
    return None if value is None else cut(value, source.length)


def is_known(source: Quantity, known: Known) -> bool:
    """Return whether a quantity is known; of a list every value."""
    value = known[source.path]
    return value is not None and not (isinstance(value, tuple) and None in value)


def shown_value(value: Value) -> str:
    """A value as documents print it: NaN, a number, or a text in quotes."""
    return "NaN" if isinstance(value, float) and math.isnan(value) else repr(value)
