"""Judges changes of what the vehicle keeps: what a number is, where it comes from, and what a stored one means."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import zip_longest

from codegen.diff.change import Change
from codegen.diff.judging.texts import same_entry
from codegen.diff.system.judged import Sides, doubtful, is_narrower, silent
from codegen.model.quantities.conversion import Conversion
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Parameter, Quantity

_SAME = "whether it still gives the same numbers"
_LESS = "whether values beyond its limits, which are narrower now, are meant"


def _quantities(change: Change, sides: Sides) -> tuple[Quantity, Quantity] | None:
    """The quantity in both versions; None where one has none."""
    component, _, name = change.subject.partition(".")
    found = [
        side.components[component].quantities.get(name) if component in side.components else None
        for side in (sides.old, sides.new)
    ]
    return (found[0], found[1]) if found[0] is not None and found[1] is not None else None


def source(change: Change, sides: Sides) -> Change:
    """A quantity that is measured or computed otherwise, or begins with another value."""
    pair = _quantities(change, sides)
    if pair is None:
        return change
    if _is_inverted(*pair):
        effect = "it is true where it was false"
        told = sides.fields.get(change.subject)
        return silent(change, effect) if told else doubtful(change, "whether the opposite is meant", effect)
    for doubt in _doubts(pair, sides):
        change = doubtful(change, doubt)
    return change


def _is_inverted(old: Quantity, new: Quantity) -> bool:
    """Return whether a boolean follows the same number at the other side of a limit."""
    followed = old.derivation.follows
    if followed is None or followed != new.derivation.follows:
        return False
    if old.derivation.own_floors or new.derivation.own_floors:
        return False
    return old.derivation.holds("limit", "") != new.derivation.holds("limit", "")


def _doubts(pair: tuple[Quantity, Quantity], sides: Sides) -> Iterator[str]:
    old, new = pair
    if new.initial is not None and _start(old) != _start(new):
        yield f"whether {_shown_start(new)} is what is told and acted on while nothing is known"
    if old.kind is not new.kind or (old.enum and old.enum.name) != (new.enum and new.enum.name):
        yield "whether who reads it takes it for what it is now"
    if _origin(old, sides.old) != _origin(new, sides.new):
        yield _SAME


def _start(quantity: Quantity) -> Fraction | str | None:
    """Return what it begins with, in its unit."""
    initial = quantity.initial
    return initial if initial is None or isinstance(initial, str) else initial / quantity.steps


def _shown_start(quantity: Quantity) -> str:
    """Return what a quantity begins with, for people."""
    start = _start(quantity)
    if start is None or isinstance(start, str):
        return quantity.start
    return f"{decimal(start)} {quantity.unit.name}".rstrip()


def _origin(quantity: Quantity, system: System) -> tuple[object, ...]:
    """Return what says where a value comes from, whatever unit it is kept in."""
    derivation, spec = quantity.derivation, quantity.spec
    measured = None if derivation.conversion is None else _measured(derivation.conversion, quantity)
    written = None if derivation.conversion is not None else spec.derivations
    given = tuple((name, output.name) for name, output, _ in derivation.gives)
    followed = system.components[quantity.component].quantities.get(derivation.follows or "")
    steps = followed.steps if followed else Fraction(1)
    limits_ = tuple(limit / steps for limit in (*derivation.own_limits, *derivation.own_floors))
    own = (type(derivation), written, measured, given, limits_, spec.per, spec.restarts_with, derivation.prefers)
    return (*own, tuple(_curves(quantity, system)))


def _curves(quantity: Quantity, system: System) -> Iterator[tuple[Fraction, Fraction]]:
    """Yield the points of the curves by which it follows another one, in the units of both."""
    for curve in quantity.derivation.curves_by_instance:
        source = system.components[quantity.component].quantities[quantity.derivation.sources[0]]
        yield from ((at / Fraction(source.steps), stands_for / Fraction(quantity.steps)) for at, stands_for in curve)


def _measured(conversion: Conversion, quantity: Quantity) -> tuple[object, ...]:
    """Return what the counts of a channel are taken for, in the unit of the quantity."""
    factors = conversion.factors
    names = [factor.name for factor in factors if isinstance(factor, Parameter)]
    steps = [factor.default for factor in factors]
    ends = (conversion.exact(count, *steps) / quantity.steps for count in (0, conversion.channel.full_scale))
    return conversion.channel.name, names, *((None, None) if names else ends)


def limits(change: Change, sides: Sides) -> Change:
    """A quantity that is limited to less, or has fewer values."""
    pair = _quantities(change, sides)
    if pair is None:
        return change
    old, new = pair
    if old.unit == new.unit and is_narrower((old.spec.min, old.spec.max), (new.spec.min, new.spec.max)):
        change = doubtful(change, _LESS)
    counts = [sum(each.elements or ()) for each in pair]
    return doubtful(change, "whether nothing is to be told of the others") if counts[1] < counts[0] else change


def trust(change: Change, sides: Sides) -> Change:
    """A value that is believed for longer, or for less long, than before."""
    pair = _quantities(change, sides)
    if pair is None or pair[0].trust == pair[1].trust:
        return change
    return doubtful(change, "whether failsafes and receivers are to believe it for just so long")


def width(change: Change, sides: Sides) -> Change:
    """A text of which fewer bytes are kept."""
    pair = _quantities(change, sides)
    if pair is None or not 0 < pair[1].length < pair[0].length:
        return change
    return doubtful(change, f"whether texts of more than {pair[1].length} bytes are to be cut")


def sensor(change: Change, sides: Sides) -> Change:
    """A sensor whose numbers come in another order or unit, or are believed in a narrower range."""
    name = change.subject.removeprefix("sensor ")
    old, new = (side.sources.get(name) for side in (sides.old, sides.new))
    if old is None or new is None:
        return change
    given = [
        [(output.name, output.unit, steps) for output, steps in zip_longest(side.outputs, side.given_in)]
        for side in (old, new)
    ]
    if given[1][: len(given[0])] != given[0]:
        change = doubtful(change, "whether its driver gives the numbers in this order and these units")
    known = {output.name: output for output in old.outputs}
    for output in new.outputs:
        before = known.get(output.name)
        if before is None or before.unit.dimension != output.unit.dimension:
            continue
        was, now = before.unit.scale, output.unit.scale
        if output.low * now > before.low * was or output.high * now < before.high * was:
            change = doubtful(change, _LESS)
    return change


def parameter_range(change: Change, sides: Sides) -> Change:
    """A parameter that takes less: what is stored beyond becomes the default."""
    old, new = _parameter(sides.old, change), _parameter(sides.new, change)
    if old is None or new is None or old.unit != new.unit:
        return change
    is_higher = new.minimum * new.step > old.minimum * old.step
    narrower = is_higher or new.maximum * new.step < old.maximum * old.step
    return doubtful(change, "whether values are stored that become the default now") if narrower else change


def _parameter(system: System, change: Change) -> Parameter | None:
    return system.parameters.get(change.subject)


def parameter(change: Change, sides: Sides) -> Change:
    """A parameter whose stored values mean something else now."""
    old, new = _parameter(sides.old, change), _parameter(sides.new, change)
    if old is None or new is None:
        return change
    before, after = ({value * side.step: text for value, text in side.choices.items()} for side in (old, new))
    if after and not before:
        return doubtful(change, "whether other values are stored, which become the default now")
    if not after:
        return change
    for value, text in before.items():
        now = after.get(value)
        if now == text:
            continue
        shown = decimal(value)
        if now is None:
            change = doubtful(change, f"whether {shown}, {text}, is stored or set by anybody")
        elif now in before.values():
            change = silent(change, f"{shown} was {text} and is {now}, which was another number")
        elif same_entry(text, now).gravity or not _shares(text, now):
            change = doubtful(change, f"whether {shown}, {now}, is what was {text}")
    return change


def _shares(one: str, other: str) -> bool:
    return bool(set(one.lower().split()) & set(other.lower().split()))
