"""Answers each element of a field: by a quantity, in a unit that fits, as a user could write it in state.yaml.

What the tables say is drawn by lot, from a fixed seed: in which unit people think, in which it is stored, limits, an
initial value, an age.
"""

import keyword
import random
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from operator import or_

from population.answer import Answer
from population.fields import Field, Message
from population.numeric import real, trusted, whole

TAKEN = {"instance", "number", "failures", "expire", "forget", "keep", "gone"}
LISTS = True
"""True: a quantity with ``elements`` answers arrays as a whole; else each element has a quantity of its own."""
TEXTS = True
"""True: a quantity is a ``text``; else texts are constants."""
CLOCKS = {"us": 1, "ms": 1000, "cs": 10_000, "ds": 100_000, "s": 1_000_000}


def component(message: Message) -> str:
    """The component of the state that the message is about."""
    return message.name.lower()


def answer(message: Message, seed: int) -> list[Answer]:
    """An answer for every element; a field without a sentinel withholds the message, or has an initial value."""
    dice = random.Random(f"{seed} {message.name}")
    clocks = ["boot", "unix"]  # each tells one field: what is set for the one would be for the other, too
    dice.shuffle(clocks)
    return [each for field in message.fields for each in _elements(message, field, clocks, dice)]


def refused(before: Answer) -> Answer:
    """Return the answer in place of one whose quantity the generator refuses: nothing is known, or 0."""
    if before.kind == "text":
        return Answer(before.field, 0, "text", '{constant: "x"}')
    written = "unknown" if before.unknown is not None else "{constant: 0}"
    return Answer(before.field, before.at, "fixed", written)


def _elements(message: Message, field: Field, clocks: list[str], dice: random.Random) -> Iterator[Answer]:
    if field.code == "s":
        if TEXTS:
            yield _text(message, field, dice)
            return
        text = "".join(dice.choices("abcXYZ 019", k=dice.randint(1, max(1, field.count)))).strip() or "x"
        yield Answer(field, 0, "text", f'{{constant: "{text}"}}')
        return
    if LISTS and field.count > 1 and field.enum is None and dice.random() < 0.6:
        name = field.name.lower().replace("_", "") + "list"
        base = Answer(field, 0, "number", f"{{state: {component(message)}.{name}}}", name)
        drawn = real(base, dice) if field.is_float else whole(base, dice)
        drawn = replace(drawn, quantity=(*drawn.quantity, ("elements", str(field.count))))
        yield from (replace(drawn, at=at, listed=field.count) for at in range(field.count))
        return
    for at in range(max(1, field.count)):
        name = field.name.lower().replace("_", "") + (f"x{at}" if field.count else "")
        name += "value" if name in TAKEN or keyword.iskeyword(name) else ""
        base = Answer(field, at, "number", f"{{state: {component(message)}.{name}}}", name)
        fitting = [clock for clock in clocks if clock not in _other_clocks(field)]
        if fitting and field.unit in CLOCKS and not field.count and field.bits >= 32 and not field.is_float:
            if dice.random() < 0.4:
                clocks.remove(fitting[-1])
                yield _clock(base, fitting[-1])
            else:
                yield whole(base, dice)
        elif field.enum is not None and field.enum.is_bitmask and not field.count and dice.random() < 0.4:
            yield _flags(message, base, dice)
        elif field.enum is not None:
            yield _enum(base, dice)
        elif field.is_float:
            yield real(base, dice)
        else:
            yield whole(base, dice)


def _other_clocks(field: Field) -> set[str]:
    """Return the clocks that a field does not count by, where its name says which one it does."""
    parts = set(field.name.lower().split("_"))
    return {"unix"} if "boot" in parts else {"boot"} if "unix" in parts else set()


def _clock(base: Answer, name: str) -> Answer:
    withholds = name == "unix" and base.unknown is None
    return replace(
        base,
        kind="clock",
        written=f"{{clock: {name}}}",
        name=name,
        withholds=withholds,
        microseconds=CLOCKS[base.field.unit],
    )


def _flags(message: Message, base: Answer, dice: random.Random) -> Answer:
    """Return flags: some entries at all times, some by booleans of the state, some never."""
    assert base.field.enum is not None
    fitting = {value: name for value, name in base.field.enum.entries.items() if 0 < value < 1 << base.field.bits}
    single = {value: name for value, name in fitting.items() if value.bit_count() == 1}
    words, flags = [], []
    for number, (value, entry) in enumerate(single.items()):
        chosen = dice.random()
        if chosen < 0.2:
            words.append(entry)
            flags.append(("", value))
        elif chosen < 0.8:
            words.append(f"{entry} if {component(message)}.{base.name}b{number}")
            flags.append((f"{base.name}b{number}", value))
    if not flags:
        return _enum(base, dice)
    return replace(base, kind="flags", written=f"{{flags: [{', '.join(words)}]}}", flags=tuple(flags))


def _enum(base: Answer, dice: random.Random) -> Answer:
    enum = base.field.enum
    assert enum is not None
    found = replace(base, kind="enum", steps=Fraction(1), quantity=(("enum", enum.name),))
    largest = (1 << base.field.bits) - 1
    if enum.is_bitmask and reduce(or_, enum.entries, 0) > largest:  # flags that the field has no bits for
        found = replace(found, written=f"{found.written[:-1]}, max: {largest}}}")
    low, high = found.ends
    fitting = [value for value in enum.entries if low <= value <= high and value != base.unknown]
    if base.unknown is None and fitting and dice.random() < 0.5:
        value = dice.choice(fitting)
        return replace(found, initial=Fraction(value), quantity=(*found.quantity, ("initial", enum.entries[value])))
    return trusted(replace(found, withholds=base.unknown is None), dice)


def _text(message: Message, field: Field, dice: random.Random) -> Answer:
    """Kept in as many bytes as the field has, or fewer, or more."""
    name = field.name.lower().replace("_", "") + "text"
    kept = max(1, field.count + dice.randint(-3, 5))
    base = Answer(field, 0, "text", f"{{state: {component(message)}.{name}}}", name, steps=Fraction(kept))
    base = replace(base, quantity=(("text", str(kept)),))
    return trusted(replace(base, withholds=base.unknown is None), dice)
