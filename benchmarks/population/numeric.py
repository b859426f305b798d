"""Answers a field of numbers: its unit, its storage, its limits, and the value that stands in for unknown."""

import random
import re
from dataclasses import replace
from fractions import Fraction

from population.answer import SMALL, STALE_S, Answer
from population.fields import Field
from population.units import PEOPLE


def real(base: Answer, dice: random.Random) -> Answer:
    """Answer with a float: that of the field, in its unit or another one, or in whole steps of a thousandth."""
    unit, wire = _people(base.field, dice)
    keys, steps, attribute = [("unit", unit)] if unit else [], None, ""
    if base.field.unit and dice.random() < 0.3:
        stored = _times(base.field.unit, 3)
        keys, steps, attribute = [*keys, ("stored", stored)], wire * 1000, f"{base.name}_{_suffix(stored)}"
    found = replace(base, quantity=tuple(keys), wire=wire, steps=steps, attribute=attribute)
    return trusted(_with_initial(_with_limits(found, dice), dice), dice)


def whole(base: Answer, dice: random.Random) -> Answer:
    """Answer in steps of the field, or in finer ones that are rounded."""
    field = base.field
    unit, per_unit = _people(field, dice)
    wire = per_unit / field.multiplier
    keys, steps, stored = [("unit", unit)] if unit else [], max(wire, Fraction(1)), unit
    if wire > 1:
        stored = field.unit if field.multiplier == 1 else "steps"
    chosen = dice.random()
    if chosen < 0.25 and field.unit and field.bits <= 16:
        stored = _times(field.unit, 1)
        keys, steps = [*keys, ("stored", stored)], 10 * per_unit
    elif (chosen < 0.6 or wire < 1) and field.unit and field.multiplier == 1:
        stored = field.unit
        keys, steps = [*keys, ("stored", stored)], wire
    attribute = f"{base.name}_{_suffix(stored)}"
    found = replace(base, quantity=tuple(keys), wire=wire, steps=steps, attribute=attribute)
    return _shaped(trusted(_with_initial(_with_limits(found, dice), dice), dice), dice)


def _shaped(found: Answer, dice: random.Random) -> Answer:
    """Return the answer with keys of the table: its rounding, and limits that are narrower."""
    keys = ""
    if found.factor.denominator != 1 and dice.random() < 0.5:
        found = replace(found, rounding=dice.choice(("down", "up", "toward_zero")))
        keys = f", rounding: {found.rounding}"
    low, high = found.whole_ends
    if high - low > 10 and dice.random() < 0.2:
        inner = sorted(dice.randint(low, high) / found.factor for _ in range(2))
        units = [end // found.steps for end in inner]
        least, most = (end * found.steps for end in units)
        stands_in = least if found.initial is None else found.initial  # a table does not limit what stands in
        is_inner = low <= least * found.factor and most * found.factor <= high and least < most
        if is_inner and least <= stands_in <= most:
            found = replace(found, least=least, most=most)
            keys += f", min: {units[0]}, max: {units[1]}"
    return replace(found, written=found.written.replace("}", f"{keys}}}"))


def _people(field: Field, dice: random.Random) -> tuple[str, Fraction]:
    """The unit in which the quantity is thought of, and what one of it is in units of the field."""
    if field.unit in PEOPLE and dice.random() < 0.6:
        return PEOPLE[field.unit]
    return field.unit, Fraction(1)


def _times(unit: str, tens: int) -> str:
    """A unit whose numbers were multiplied with a power of ten: degE3, and m/s*5*1000."""
    return f"{unit}*{10**tens}" if unit[-1].isdigit() else f"{unit}E{tens}"


def _suffix(unit: str) -> str:
    """Return the end of the name of the attribute with the stored value: its unit."""
    text = unit.replace("%", "pct") if unit.endswith("%") else re.sub("[^a-z0-9]+", "_", unit.lower()).strip("_")
    return text or "number"


def _with_limits(found: Answer, dice: random.Random) -> Answer:
    """Limits in the unit of people, so that whole steps lie at them."""
    if dice.random() < 0.6:
        return found
    steps = found.steps
    if steps is None:
        low, high = Fraction(dice.randint(-500, 0), 4), Fraction(dice.randint(4, 500), 4)
    else:
        least, most = _reach(found)
        grain = steps.denominator  # so many steps are a number of units that can be written
        low = Fraction(dice.randint(-(-least // grain), 0) * grain if least < 0 else least)
        high = Fraction(dice.randint(1, max(1, most // grain)) * grain)
        if not all(_is_written(end / steps) for end in (low, high)) or low >= high:
            return found
        low, high = low / steps, high / steps
    written = (("min", _decimal(low)), ("max", _decimal(high)))
    low, high = (low, high) if steps is None else (low * steps, high * steps)
    return replace(found, quantity=(*found.quantity, *written), low=low, high=high)


def _reach(found: Answer) -> tuple[int, int]:
    """The smallest and the largest number of steps that the field carries, and the state."""
    assert found.steps is not None
    if found.field.is_float:
        return -SMALL, SMALL
    low, high = (end * found.steps / found.wire for end in found.ends)
    return int(-(-low // 1)), int(high // 1)


def _with_initial(found: Answer, dice: random.Random) -> Answer:
    """Return an answer to a field without a sentinel: with an initial value, or with the message withheld."""
    if found.unknown is not None:
        return found
    if dice.random() < 0.5:
        return replace(found, withholds=True)
    if found.steps is None:
        value = Fraction(dice.randint(-800, 800), 4)
        value = max(value, found.low) if found.low is not None else value
        value = min(value, found.high) if found.high is not None else value
        return replace(found, initial=value, quantity=(*found.quantity, ("initial", _decimal(value))))
    low, high = found.low, found.high
    if low is None or high is None:
        low, high = (Fraction(end) for end in _reach(found))
    for _ in range(20):
        value = Fraction(dice.randint(int(low), int(min(high, low + dice.choice((10**2, 10**4, 10**8))))))
        if _is_written(value / found.steps):
            written = ("initial", _decimal(value / found.steps))
            return replace(found, initial=value, quantity=(*found.quantity, written))
    return replace(found, withholds=True)


def trusted(found: Answer, dice: random.Random) -> Answer:
    """Return the answer, some of which are believed for a second only."""
    if found.initial is not None or dice.random() < 0.75:
        return found
    return replace(found, is_aging=True, quantity=(*found.quantity, ("stale_after", f"{STALE_S} s")))


def _is_written(number: Fraction) -> bool:
    """Return whether a number has an end when it is written with a point."""
    rest = number.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1


def _decimal(number: Fraction) -> str:
    """Written with a point, exactly."""
    digits = 0
    while (number * 10**digits).denominator != 1:
        digits += 1
    whole = str(abs(int(number * 10**digits))).rjust(digits + 1, "0")
    text = f"{whole[:-digits]}.{whole[-digits:]}" if digits else whole
    return f"-{text}" if number < 0 else text
