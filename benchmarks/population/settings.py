"""Settings of an attribute: the ways to set it, its extremes, random values, and the values that the state keeps."""

import math
import random
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from population.answer import SMALL, Answer
from population.expected import cut

STORED, PEOPLE = "stored", "people"


@dataclass(frozen=True)
class Setting:
    """A value for one of both attributes; ``how`` is empty where an attribute is left as it is."""

    how: str = ""
    value: int | float | str | None = None


LEAVE = Setting()
REALS = (0.0, -0.0, 1.0, -1.0, 0.1, -0.6, 1.5, 16777217.0, 1e-3, 1e10, -3.4028234663852886e38, 3.4028235677973366e38)
BEYOND = (1e39, -1e300, math.inf, -math.inf, 1e-38, 1e-45, -7e-46, 5e-324, 2.2250738585072014e-308)


def is_fixed(answer: Answer) -> bool:
    """Return whether there is nothing to set: a constant, or flags of which none depends on the state."""
    is_constant = answer.kind == "fixed" or (answer.kind == "text" and answer.steps is None)
    return is_constant or (answer.kind == "flags" and not any(name for name, _ in answer.flags))


def extremes(answer: Answer) -> list[Setting]:
    """The ends, beyond both, unknown, zero, and what is next to a sentinel."""
    if is_fixed(answer):
        return [LEAVE]
    if answer.kind == "text":
        size = answer.field.count
        cuts = ("x" * (size + extra) + letter * 4 for letter in "\u00e9\u20ac\U0001f600" for extra in range(-4, 1))
        return [Setting(PEOPLE, text) for text in (None, "", "y" * size, "a\0b", "\0", *cuts)]
    if answer.kind == "flags":
        every = sum(value for name, value in answer.flags if name)
        return [Setting(PEOPLE, every), Setting(PEOPLE, 0)]
    if answer.kind == "clock":
        wrap = answer.microseconds << answer.field.bits
        ends = (0, 1, wrap - 1, wrap, 1 << 30, (1 << 30) * 1000 - 1, 1 << 48)
        found = [Setting(STORED, end % (1 << 63)) for end in ends if not _is_sentinel(answer, end)]
        return [*found, Setting(STORED, None)] if answer.name == "unix" else found
    if answer.kind == "enum":
        return [*(Setting(PEOPLE, value) for value in _entries(answer)), Setting(PEOPLE, None)]
    found = [Setting(PEOPLE, None), Setting(PEOPLE, math.nan)]
    if answer.steps is None:
        sentinel = [] if answer.unknown is None else [answer.unknown / float(answer.wire)]
        return [*found, *(Setting(PEOPLE, value) for value in (*REALS, *BEYOND, *sentinel))]
    return [*found, Setting(STORED, None), *_whole(answer)]


def _whole(answer: Answer) -> Iterator[Setting]:
    """Whole steps at the ends of everything, and beyond."""
    assert answer.steps is not None
    ends = {Fraction(0), Fraction(1), Fraction(-1), Fraction(5), Fraction(-15)}
    ends |= {end for end in (answer.low, answer.high) if end is not None}
    if not answer.field.is_float:
        sentinel = [] if answer.unknown is None else [Fraction(answer.unknown)]
        ends |= {end * answer.steps / answer.wire // 1 for end in (*answer.ends, *sentinel)}
    ends |= {Fraction(end) for end in (SMALL, -SMALL, 1 << 32, -(1 << 33), (1 << 63) - 1)}
    for end in sorted({end + step for end in ends for step in (-1, 0, 1)}):
        if -(1 << 63) <= end < 1 << 64:
            yield Setting(STORED, int(end))
            units = float(end / answer.steps)
            if abs(end) < 1 << 50:
                yield Setting(PEOPLE, units)
    yield from (Setting(PEOPLE, value) for value in (math.inf, -math.inf, 1e30, -1e30))


def lots(answer: Answer, dice: random.Random) -> Setting:
    """A random value that is known; one in eight that need not be is unknown."""
    if answer.kind in ("number", "enum") and not answer.withholds and dice.random() < 0.125 / max(1, answer.listed):
        return Setting(PEOPLE, None)
    if is_fixed(answer):
        return LEAVE
    if answer.kind == "text":
        return Setting(PEOPLE, "".join(dice.choices("az \u00fc\u2013\U0001f6a2", k=dice.randint(0, 20))))
    if answer.kind == "flags":
        every = sum(value for name, value in answer.flags if name)
        return Setting(PEOPLE, dice.getrandbits(64) & every)
    if answer.kind == "clock":
        value = dice.getrandbits(dice.randint(1, 62))
        return Setting(STORED, value + answer.microseconds if _is_sentinel(answer, value) else value)
    if answer.kind == "enum":
        return Setting(PEOPLE, dice.choice(_entries(answer)))
    if answer.steps is None:
        size, code = (4, "<f") if dice.random() < 0.5 else (8, "<d")
        value = struct.unpack(code, dice.randbytes(size))[0]
        return Setting(PEOPLE, value if not math.isnan(value) else dice.uniform(-1000, 1000))
    low, high = answer.ends if not answer.field.is_float else (Fraction(-SMALL), Fraction(SMALL))
    if not answer.field.is_float:
        low, high = (end * answer.steps / answer.wire for end in (low, high))
    low, high = (low if answer.low is None else answer.low), (high if answer.high is None else answer.high)
    steps = dice.randint(math.ceil(low), max(math.ceil(low), math.floor(high)))
    if abs(steps) < 1 << 45 and dice.random() < 0.5:
        return Setting(PEOPLE, float((steps + Fraction(dice.randint(-9, 9), 20)) / answer.steps))
    return Setting(STORED, steps)


def kept(answer: Answer, setting: Setting) -> Fraction | float | str | None:
    """Return the stored value: whole steps between the limits, or the float as it was set; None is unknown."""
    value = setting.value
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return answer.initial if answer.kind != "clock" else None
    if isinstance(value, str):
        assert answer.steps is not None
        return cut(value, int(answer.steps))
    if answer.kind != "number":
        return Fraction(value)
    low, high = answer.low, answer.high
    if answer.steps is None:
        value = float(low) if low is not None and value < low else value  # -0.0 is not below 0
        return float(high) if high is not None and value > high else value
    if setting.how == STORED:
        steps = Fraction(value)
    else:
        exact = Fraction(value) * answer.steps
        steps = Fraction(abs(exact) + Fraction(1, 2)) // 1 * (1 if exact >= 0 else -1)
    steps = steps if low is None else max(low, steps)
    return steps if high is None else min(high, steps)


def _entries(answer: Answer) -> list[int]:
    """Entries that the field carries; of a bitmask also several together."""
    enum = answer.field.enum
    assert enum is not None
    low, high = answer.ends
    fitting = [value for value in enum.entries if low <= value <= high]
    if enum.is_bitmask:
        every = 0
        for value in fitting:
            every |= value
        fitting += [every, every & 0x5555555555555555, 0]
    return fitting


def _is_sentinel(answer: Answer, microseconds: int) -> bool:
    return (
        answer.unknown is not None and microseconds // answer.microseconds % (1 << answer.field.bits) == answer.unknown
    )
