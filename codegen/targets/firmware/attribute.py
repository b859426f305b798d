"""Attributes of the components in state.py: which view of the words each of them is."""

from collections.abc import Iterator

from codegen.frozen import dataclass
from codegen.model.storage import Storage
from codegen.model.vehicle import Quantity, QuantityKind

WIDE = frozenset({"integer", "shown_integer", "floating"})
"""The views that stand in the module wide, which is there only where something needs it."""
MODULES = {**dict.fromkeys(WIDE, "wide"), "ticking": "clock_plain"}
"""The module of each view that does not stand in words."""


@dataclass(frozen=True, slots=True)
class AttributeView:
    """An attribute of a component: the view of words that it is, and what it means, in lines above it or behind it."""

    name: str
    expression: str
    above: str
    behind: str


def joined(*parts: object) -> str:
    """The arguments that there are."""
    return ", ".join(str(part) for part in parts if part != "")


def known_words(quantity: Quantity) -> str:
    """Whether there is a value at all times, in words."""
    return "known from the start" if quantity.initial is not None else "or None while it is unknown"


def wide_attributes(quantity: Quantity, place: str, above: str, behind: str) -> Iterator[AttributeView]:
    """The attributes of what is kept in halves: in stored units, and, where these are others, in those of people."""
    storage, halves = quantity.storage, quantity.storage.halves
    numerator, denominator = quantity.steps.numerator, quantity.steps.denominator
    steps = (numerator, denominator) if denominator != 1 else (numerator,)
    if storage.is_float:
        low = "" if quantity.spec.min is None else f"low={float(quantity.minimum)!r}"
        high = "" if quantity.spec.max is None else f"high={float(quantity.maximum)!r}"
        scale = [f"{name}={part}" for name, part in zip(("numerator", "denominator"), steps, strict=False) if part != 1]
        own = behind if quantity.attribute == quantity.name else ""
        yield AttributeView(quantity.attribute, f"floating({joined(place, halves, low, high)})", above, own)
        if quantity.attribute != quantity.name:
            yield AttributeView(quantity.name, f"floating({joined(place, halves, low, high, *scale)})", behind, "")
        return
    limits = (halves, quantity.minimum, quantity.maximum)
    yield AttributeView(quantity.attribute, f"integer({joined(place, *limits)})", above, "")
    if quantity.attribute != quantity.name and quantity.kind is QuantityKind.NUMBER:
        yield AttributeView(quantity.name, f"shown_integer({joined(place, *limits, *steps)})", behind, "")


def initial_words(quantity: Quantity, place: str) -> Iterator[tuple[str, str]]:
    """The words of the initial value, from ``place`` on, each with what it has."""
    initial, storage = quantity.initial, quantity.storage
    assert initial is not None
    if storage is Storage.SMALL:
        yield place, str(initial)
        return
    for at, half in enumerate(storage.split(float(initial) if storage.is_float else int(initial))):
        yield f"{place} + {at}" if at else place, str(half)
