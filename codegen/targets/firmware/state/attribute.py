"""Attributes of the components in state.py: which view of the words each of them is."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from codegen.frozen import dataclass
from codegen.model.code.letters import letter_words
from codegen.model.code.storage import SMALL_INT_MAX, Storage
from codegen.model.quantities.reach import Reach
from codegen.model.quantities.set_together import set_together
from codegen.model.vehicle import Component, Quantity, QuantityKind
from codegen.targets.firmware.words import SET_AGE, Block, age_word, differ
from codegen.targets.imports import text_literals
from codegen.targets.naming import prose, quoted

VIEWS = {
    **dict.fromkeys(("integer", "shown_integer", "floating"), "wide"),
    **dict.fromkeys(("integers", "shown_integers", "floats", "aging_row"), "rows"),
    **dict.fromkeys(("elements", "shown_elements"), "lists"),
    **dict.fromkeys(("at_least", "below"), "thresholds"),
    "text": "letters",
    "ticking": "clock_plain",
    **dict.fromkeys(("aging", "aged_number"), "ages"),
}
"""The modules of those views that are there only where something needs them, by the view; rows needs wide."""

MADE_WHEN_USED = {
    *("at_least", "below", "known", "number", "result", "truth", "whole"),
    *("aged_number", "aging", "integer", "shown_integer", "ticking"),
}
"""The views that a class states in lines of text, and makes of these when they are first used."""

FURTHER = {
    "number": (5, {"denominator": "1", "age": "None"}),
    "at_least": (2, {"own": "None"}),
    "below": (2, {"own": "None", "floor": "-1073741823", "own_floor": "None"}),
}
"""The least number of arguments of such a view, and the defaults of its further ones by name."""

ENDS = {str(-SMALL_INT_MAX): "-", str(SMALL_INT_MAX): "+"}
"""The smallest and the largest whole number that is kept, as a line of text has them: most have no other limit."""

OF_THE_PROGRAM = "vehicle"
"""The component that the program itself uses: its attributes are there at once, for a pass is not to make one."""

LONGEST = 120
"""Columns of a line."""


@dataclass(frozen=True, slots=True)
class AttributeView:
    """An attribute of a component: the view of words that it is, and what it means, in lines above it or behind it."""

    name: str
    expression: str
    above: str
    behind: str


@dataclass(frozen=True, slots=True)
class LineView:
    """Attributes that are made when they are first used: the literals of their line, and the comments above it."""

    names: tuple[str, ...]
    kind: str
    comments: tuple[str, ...]
    literals: tuple[str, ...]


def attributes(
    component: Component, block: Block, told: Mapping[str, Reach]
) -> tuple[tuple[AttributeView, ...], tuple[LineView, ...]]:
    """The attributes of a component that its class has at once, and those that it makes when they are used, in order.

    ``told`` has the limits of its quantities by path.
    """
    at_once: list[AttributeView] = []
    lines: list[LineView] = []
    places = {block.constant(word): str(at) for word, at in block.offsets.items()}
    for view in _attributes(component, block, told):
        if component.name != OF_THE_PROGRAM and _kind(view) in MADE_WHEN_USED and "told=" not in view.expression:
            lines.append(_line(view, places))
        else:
            at_once.append(_broken(view))
    return tuple(at_once), tuple(lines)


def _kind(view: AttributeView) -> str:
    return view.expression.partition("(")[0]


def _line(view: AttributeView, places: Mapping[str, str]) -> LineView:
    """Return the line of an attribute: its names, the kind of its view, and what that is told.

    ``places`` are the numbers of the words by the names of their constants.
    """
    kind, _, rest = view.expression.partition("(")
    arguments = _by_position(kind, rest.removesuffix(")").split(", "))
    told = [ENDS.get(value, places.get(value, value).strip('"')) for value in arguments]
    words = ["", *(f"{name}:" for name in view.name.split(", ")), kind, *told[:-1], f"{told[-1]}\\n"]
    comments = tuple(line for text in (view.above, view.behind) if text for line in text.split("\n    # "))
    return LineView(tuple(view.name.split(", ")), kind, comments, text_literals(words, indent=8))


def _by_position(kind: str, arguments: Iterable[str]) -> list[str]:
    """The arguments of a view without their names, in order, and in between what is meant where there is none."""
    given: list[str] = []
    named: dict[str, str] = {}
    for argument in arguments:
        name, is_named, value = argument.rpartition("=")
        if is_named:
            named[name] = value
        else:
            given.append(value)
    needed, further = FURTHER.get(kind, (0, {}))
    for name in tuple(further)[len(given) - needed :]:
        if named:
            given.append(named.pop(name, further[name]))
    return given


def _broken(view: AttributeView) -> AttributeView:
    """The same, with the arguments in a line or lines of their own where one has no room, as the formatter has them."""
    if len(f"    {view.name} = {view.expression}") <= LONGEST:
        return view
    called, _, rest = view.expression.partition("(")
    arguments = rest.removesuffix(")")
    if len(f"        {arguments}") > LONGEST:
        arguments = arguments.replace(", ", ",\n        ") + ","
    return replace(view, expression=f"{called}(\n        {arguments}\n    )")


def _attributes(component: Component, block: Block, told: Mapping[str, Reach]) -> Iterator[AttributeView]:
    for quantity in component.quantities.values():
        views = _views(quantity, component, block, told[quantity.path])
        if quantity.ages and _is_plain(quantity):
            yield from (_aged_number(view, quantity, block) for view in views)
        elif quantity.ages:
            yield from (each for view in views for each in _aging(view, quantity, block))
        elif quantity.derivation.counts_time:
            yield from (each for view in views for each in _ticking(view))
        else:
            yield from views
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
    """Return whether there is a value at all times, in words."""
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
        own = (block.constant(f"{quantity.name}_{word}") for word in ("limit", "floor"))
        expression = derivation.attribute(followed, *own)
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
    inner = "_" if quantity.ages and not _is_plain(quantity) else ""
    if quantity.elements is not None:
        yield from _elements(quantity, told, block, above, f"{shown} each, or None while it is unknown{cited}")
        return
    if quantity.kind is QuantityKind.BOOLEAN:
        yield AttributeView(quantity.attribute, f"truth({place})", above, "")
        return
    if quantity.kind is QuantityKind.TEXT:
        yield _text(quantity, place, above, f"A text, {_known_words(quantity)}{cited}")
        return
    called = f'"{inner}{quantity.name}"'
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
        age = _age(quantity, component, block)
        yield AttributeView(
            names,
            f"number({_joined(limits, steps, age)})",
            _lines(above, f"{shown}, {_known_words(quantity)}{cited}"),
            "",
        )


def _age(quantity: Quantity, component: Component, block: Block) -> str:
    """The argument for what counts readings since code has set it, or nothing."""
    if quantity.derivation.represented:
        return f"age={block.constant('failures')}"
    together = set_together(component)
    return f"age={block.constant(SET_AGE)}" if together and quantity in together.quantities else ""


def _elements(quantity: Quantity, told: Reach, block: Block, above: str, behind: str) -> Iterator[AttributeView]:
    """The attributes of a list."""
    elements, place = quantity.elements or (0,), block.constant(quantity.attribute)
    inner = f'"{"_" if quantity.ages else ""}{quantity.attribute}"'
    if quantity.storage is not Storage.SMALL:
        yield from _rows(quantity, told, place, inner, above, behind)
        return
    own = f"own={block.constant(f'{quantity.attribute}_count')}" if differ(elements) else ""
    age = f"age={block.constant(f'{quantity.attribute}_age')}" if quantity.ages_by_readings else ""
    arguments = _joined(place, max(elements), *told, inner, own, age)
    yield AttributeView(quantity.attribute, f"elements({arguments})", above, "")
    if quantity.attribute != quantity.name:
        numerator, denominator = quantity.steps.numerator, quantity.steps.denominator
        steps = _joined(inner, numerator, denominator if denominator != 1 else "")
        yield AttributeView(quantity.name, f"shown_elements({steps})", "", behind)


def _text(quantity: Quantity, place: str, above: str, behind: str) -> AttributeView:
    initial = f"initial={quoted(quantity.initial)}" if isinstance(quantity.initial, str) else ""
    return AttributeView(quantity.attribute, f"text({_joined(place, quantity.length, initial)})", above, behind)


def _rows(quantity: Quantity, told: Reach, place: str, called: str, above: str, behind: str) -> Iterator[AttributeView]:
    """The same of a list: the view of one number has a name in the plural, and takes how many there are."""
    count = max(quantity.elements or (0,))
    for view in _wide(quantity.element, told, place, called, above, behind):
        name, _, arguments = view.expression.partition(f"({place}, ")
        several = {"floating": "floats"}.get(name, f"{name}s")
        yield AttributeView(view.name, f"{several}({place}, {count}, {arguments}", view.above, view.behind)


def _ticking(view: AttributeView) -> Iterator[AttributeView]:
    """The attribute of a clock, under a name of the module's own, and as of now in its place."""
    inner = f"_{view.name}"
    yield AttributeView(inner, view.expression, view.above, view.behind)
    yield AttributeView(view.name, f'ticking("{inner}")', "", "")


def _is_plain(quantity: Quantity) -> bool:
    """Return whether its attributes are two views of one word, which one call makes and can make forgettable."""
    is_number = quantity.kind is QuantityKind.NUMBER and quantity.attribute != quantity.name
    is_kept = quantity.elements is None and quantity.storage is Storage.SMALL
    return is_number and is_kept and not quantity.derivation.kept_readings and quantity.derivation.follows is None


def _aged_number(view: AttributeView, quantity: Quantity, block: Block) -> AttributeView:
    """The attributes of words.number() that are forgotten."""
    arguments = view.expression.removeprefix("number(").removesuffix(")")
    steps = "" if quantity.steps.denominator != 1 else "1"
    own = _joined(arguments, steps, block.constant(age_word(quantity)), quantity.trust.stale_after_ms)
    return replace(view, expression=f"aged_number({own})")


def _aging(view: AttributeView, quantity: Quantity, block: Block) -> Iterator[AttributeView]:
    """The attributes as they are, under names of the module's own, and what forgets them in their place."""
    names = view.name.split(", ")
    yield AttributeView(", ".join(f"_{name}" for name in names), view.expression, view.above, "")
    arguments: tuple[object, ...] = (block.constant(age_word(quantity)), quantity.trust.stale_after_ms)
    kind = "aging"
    if quantity.elements:
        kind, arguments = "aging_row", (max(quantity.elements), quantity.storage.words, *arguments)
    for name in names:
        forgets = f'{kind}("_{name}", {_joined(block.constant(quantity.attribute), *arguments)})'
        above = view.behind if name == names[-1] else ""  # behind the long line there is no room for it
        yield AttributeView(name, forgets, above, "")


def initial_words(quantity: Quantity, place: str) -> Iterator[tuple[str, str]]:
    """The words of the initial value, from ``place`` on, each with what it has."""
    initial, storage = quantity.initial, quantity.storage
    assert initial is not None
    if isinstance(initial, str):
        for at, word in enumerate(letter_words(initial, quantity.length)):
            yield f"{place} + {at}" if at else place, str(word)
        return
    if storage is Storage.SMALL:
        yield place, str(initial)
        return
    for at, half in enumerate(storage.split(float(initial) if storage.is_float else int(initial))):
        yield f"{place} + {at}" if at else place, str(half)
