"""Attributes of the components in state.py: which view of the words each of them is."""

from collections.abc import Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.reach import Reach
from codegen.model.storage import Storage
from codegen.model.vehicle import Component, Quantity, QuantityKind
from codegen.targets.firmware.words import Block, age_word, differ
from codegen.targets.naming import prose

WIDE = frozenset({"integer", "shown_integer", "floating"})
"""The views that stand in the module wide, which is there only where something needs it."""

AGING = "aging"
"""The view that forgets, which has a module of its own, too."""


@dataclass(frozen=True, slots=True)
class AttributeView:
    """An attribute of a component: the view of words that it is, and what it means, in lines above it or behind it."""

    name: str
    expression: str
    above: str
    behind: str


def attributes(component: Component, block: Block, told: Mapping[str, Reach]) -> Iterator[AttributeView]:
    """The attributes of a component, in order; ``told`` has the limits of its quantities by path."""
    for quantity in component.quantities.values():
        views = _views(quantity, component, block, told[quantity.path])
        yield from (each for view in views for each in _aging(view, quantity, block)) if quantity.ages else views
    others = {
        "number": "What messages call it",
        "failures": "Failed readings in a row",
        "expires_ms": "When the last good reading will be too old",
    }
    for word, meaning in others.items():
        if word in block.offsets:
            yield AttributeView(word, f"whole({block.constant(word)})", meaning, "")


def _lines(*comments: str) -> str:
    """One comment below the other, above an attribute behind which there is no room."""
    return "\n    # ".join(comments)


def _joined(*parts: object) -> str:
    """The arguments that there are."""
    return ", ".join(str(part) for part in parts if part != "")


def _known_words(quantity: Quantity) -> str:
    """Whether there is a value at all times, in words."""
    return "known from the start" if quantity.initial is not None else "or None while it is unknown"


def _wide(quantity: Quantity, told: Reach, place: str, called: str, above: str, behind: str) -> Iterator[AttributeView]:
    """The attributes of what is kept in halves: in stored units, and, where these are others, in those of people.

    ``called`` is the literal by which it is told that a number is beyond ``told``, where the quantity has wider limits.
    """
    storage, halves = quantity.storage, quantity.storage.halves
    numerator, denominator = quantity.steps.numerator, quantity.steps.denominator
    steps = (numerator, denominator) if denominator != 1 else (numerator,)
    own = (quantity.minimum, quantity.maximum)
    if storage.is_float:
        low = "" if quantity.spec.min is None else f"low={float(quantity.minimum)!r}"
        high = "" if quantity.spec.max is None else f"high={float(quantity.maximum)!r}"
        narrower = "" if told == own else f"told=({float(told[0])!r}, {float(told[1])!r})"
        scale = [f"{name}={part}" for name, part in zip(("numerator", "denominator"), steps, strict=False) if part != 1]
        arguments = _joined(place, halves, called, low, high, narrower)
        own_line = _lines(above, behind) if quantity.attribute == quantity.name else above
        yield AttributeView(quantity.attribute, f"floating({arguments})", own_line, "")
        if quantity.attribute != quantity.name:
            yield AttributeView(quantity.name, f"floating({_joined(arguments, *scale)})", behind, "")
        return
    limits = (halves, *own, called)
    narrower = "" if told == own else f"told=({told[0]}, {told[1]})"
    yield AttributeView(quantity.attribute, f"integer({_joined(place, *limits, narrower)})", above, "")
    if quantity.attribute != quantity.name and quantity.kind is QuantityKind.NUMBER:
        yield AttributeView(quantity.name, f"shown_integer({_joined(place, *limits, *steps, narrower)})", behind, "")


def _views(quantity: Quantity, component: Component, block: Block, told: Reach) -> Iterator[AttributeView]:
    """The attribute for the integer, with what the quantity is above it, and the one for people.

    A number beyond ``told`` is limited on its way to some message.
    """
    cited = f"; {quantity.citation}" if quantity.citation else ""
    above = prose(quantity.spec.doc).rstrip(".")
    derivation = quantity.derivation
    if derivation.follows is not None:
        followed = block.constant(component.quantities[derivation.follows].attribute)
        expression = derivation.attribute(followed, block.constant(f"{quantity.name}_limit"))
        yield AttributeView(quantity.name, expression, above, str(quantity.citation or ""))
        return
    place = block.constant(quantity.attribute)
    above += f" [{quantity.stored.name}]" if quantity.stored.name else ""
    above += f" ({quantity.enum.name})" if quantity.enum else ""
    if derivation.switch:
        above += f": whether {derivation.switch.name} is not 0"
    numerator, denominator = quantity.steps.numerator, quantity.steps.denominator
    steps = f"{numerator}, {denominator}" if denominator != 1 else str(numerator)
    shown = quantity.unit.name or "A number"
    if quantity.elements is not None:
        own = f"own={block.constant(f'{quantity.attribute}_count')}" if differ(quantity.elements) else ""
        limits = _joined(place, max(quantity.elements), *told, f'"{quantity.attribute}"', own)
        yield AttributeView(quantity.attribute, f"elements({limits})", above, "")
        if quantity.attribute != quantity.name:
            expression = f'shown_elements("{quantity.attribute}", {steps})'
            yield AttributeView(quantity.name, expression, "", f"{shown} each, or None while it is unknown{cited}")
        return
    if quantity.kind is QuantityKind.BOOLEAN:
        yield AttributeView(quantity.attribute, f"truth({place})", above, "")
        return
    called = f'"{"_" if quantity.ages else ""}{quantity.name}"'
    if quantity.storage is not Storage.SMALL:
        yield from _wide(quantity, told, place, called, above, f"{shown}, {_known_words(quantity)}{cited}")
        return
    limits = _joined(place, *told, called)
    if quantity.attribute == quantity.name:
        yield AttributeView(quantity.attribute, f"whole({limits})", above, "")
    elif derivation.kept_readings:
        yield AttributeView(quantity.attribute, f"whole({limits})", above, "")
        yield AttributeView(quantity.name, f"result({place}, {steps})", "", f"{shown}, {_known_words(quantity)}{cited}")
    else:
        names = f"{quantity.attribute}, {quantity.name}"
        yield AttributeView(
            names, f"number({limits}, {steps})", _lines(above, f"{shown}, {_known_words(quantity)}{cited}"), ""
        )


def _aging(view: AttributeView, quantity: Quantity, block: Block) -> Iterator[AttributeView]:
    """The attributes as they are, under names of the module's own, and what forgets them in their place."""
    place = block.constant(age_word(quantity))
    names = view.name.split(", ")
    yield AttributeView(", ".join(f"_{name}" for name in names), view.expression, view.above, "")
    for name in names:
        forgets = f'aging("_{name}", {block.constant(quantity.attribute)}, {place}, {quantity.trust.stale_after_ms})'
        above = view.behind if name == names[-1] else ""  # behind the long line there is no room for it
        yield AttributeView(name, forgets, above, "")


def initial_words(quantity: Quantity, place: str) -> Iterator[tuple[str, str]]:
    """The words of the initial value, from ``place`` on, each with what it has."""
    initial, storage = quantity.initial, quantity.storage
    assert initial is not None
    if storage is Storage.SMALL:
        yield place, str(initial)
        return
    for at, half in enumerate(storage.split(float(initial) if storage.is_float else int(initial))):
        yield f"{place} + {at}" if at else place, str(half)
