"""Judges changes of what the vehicle keeps: what a number is, where it comes from, and what a stored one means."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import zip_longest

from codegen.diagnostics import shortened_list
from codegen.diff.change import Change
from codegen.diff.judging.texts import same_entry
from codegen.diff.system.carrying import carried_on
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
    if _origin(old, sides.old) != _origin(new, sides.new) or _is_derived_otherwise(old, new, sides):
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
    return type(derivation), written, measured, given, limits_, spec.per, spec.restarts_with, derivation.prefers


def _is_derived_otherwise(old: Quantity, new: Quantity, sides: Sides) -> bool:
    """Return whether a curve, or anything else that a derivation says of itself, is another one.

    Its numbers are in the units in which the quantities of the component are kept: they can be compared where these are
    as they were.
    """
    kept = [
        {name: each.stored for name, each in side.components[old.component].quantities.items()}
        for side in (sides.old, sides.new)
    ]
    is_kept_alike = all(kept[1].get(name, unit) == unit for name, unit in kept[0].items())
    if not is_kept_alike:
        curves = [_curves(each, side) for each, side in ((old, sides.old), (new, sides.new))]
        return curves[0] != curves[1]
    said = [
        [(fact.attribute, fact.text) for fact in each.derivation.facts(each) if not fact.is_trust]
        for each in (old, new)
    ]
    is_compared = new.derivation.conversion is not None or bool(new.derivation.gives)  # with units, by _origin
    return not is_compared and said[0] != said[1]


def _curves(quantity: Quantity, system: System) -> list[list[tuple[Fraction, Fraction]]]:
    """Return the points of the curve of each instance, in amounts."""
    quantities = system.components[quantity.component].quantities
    kept = next((quantities[name].stored.scale for name in quantity.derivation.sources if name in quantities), 1)
    return [
        [(Fraction(point) * kept, Fraction(value) * quantity.stored.scale) for point, value in curve]
        for curve in quantity.derivation.curves_by_instance
    ]


def trust(change: Change, sides: Sides) -> Change:
    """A quantity that is believed for longer or less long: who listens gets an old value, or none; failsafes wait."""
    pair = _quantities(change, sides)
    if pair is None:
        return change
    old, new = pair
    if old.trust != new.trust:
        waiting = sorted({each for side in (sides.old, sides.new) for each in _watching(side, new.path)})
        acts = f", which {shortened_list(waiting, 3)} may wait for" if waiting else ""
        change = doubtful(change, f"whether it is to be unknown just then{acts}")
    if _warned_above(old) != _warned_above(new):
        change = doubtful(change, "whether the warning is to be given just then")
    return change


def _warned_above(quantity: Quantity) -> list[Fraction] | None:
    threshold = quantity.derivation.threshold
    return None if threshold is None else [each / quantity.steps for each in threshold.above]


def _watching(system: System, path: str) -> Iterator[str]:
    """The failsafes that watch a quantity, or what is computed from it."""
    reached = {path, *carried_on(system).get(path, ())}
    for each in system.program.failsafes if system.program else ():
        if any(one.quantity and one.quantity.path in reached for one in (*each.conditions, *each.to_arm)):
            yield f"failsafe {each.name}"


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
    for doubt in _stored_otherwise(old, new):
        change = doubtful(change, doubt)
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


def _stored_otherwise(old: Parameter, new: Parameter) -> Iterator[str]:
    if any(new.spec.was.get(name) != factor for name, factor in old.spec.was.items()):
        yield "whether what is stored under an old name is still on boards"
    if old.spec.reboot != new.spec.reboot:
        yield f"whether who sets it counts on its being used {'after a restart' if new.spec.reboot else 'at once'}"
    if old.unit == new.unit and (old.step / new.step).denominator != 1:
        yield "whether values between the steps are stored or set by anybody"


def _shares(one: str, other: str) -> bool:
    return bool(set(one.lower().split()) & set(other.lower().split()))
