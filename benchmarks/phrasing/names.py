"""Facts that names are wrong in: entries of enums, fields, messages, and parameters of commands."""

import random
from collections.abc import Mapping
from functools import cache

from phrasing.amounts import OTHER_UNITS
from phrasing.filling import ENOUGH, Fact, Maker, Words, both, named, of_field, reference, some_message


def _entry_field(chance: random.Random) -> tuple[Words, list[tuple[str, int]]] | None:
    enums = reference().dialect.enums
    found = of_field(
        chance,
        lambda field: (
            (field.definition.enum or "") in enums
            and not field.definition.is_bitmask
            and field.definition.enum != "MAV_CMD"
            and len(enums[field.definition.enum or ""].entries) > ENOUGH
        ),
    )
    if found is None:
        return None
    _, field, words = found
    return words, [(entry.name, entry.value) for entry in enums[field.definition.enum or ""].entries]


def _enum(chance: random.Random) -> Fact | None:
    found = _entry_field(chance)
    if found is None:
        return None
    words, entries = found
    name, value = chance.choice(entries)
    return both({**words, "e": name}, value, chance.choice([value + 1, value + 2, max(value - 1, value + 3)]))


def _short(chance: random.Random) -> Fact | None:
    """Three entries of a field by the ends of their names, of which the first has another value in the wrong twin."""
    found = _entry_field(chance)
    if found is None:
        return None
    words, entries = found
    names = [name.split("_") for name, _ in entries]
    shared = next((at for at in range(10) if len({tuple(each[: at + 1]) for each in names}) > 1), 0)
    ends = [" ".join(each[shared:]).lower() for each in names]
    told = [(end, name, value) for end, (name, value) in zip(ends, entries, strict=True) if _is_wordy(end)]
    if len(told) < ENOUGH:
        return None
    (s, _, v), (sb, eb, vb), (sc, ec, vc) = chance.sample(told, ENOUGH)
    more = {"s": s, "S": s.capitalize(), "sb": sb, "sc": sc, "eb": eb, "ec": ec, "vb": str(vb), "vc": str(vc)}
    return both(words, v, v + 20, **more)


def _is_wordy(end: str) -> bool:
    return all(len(word) > 3 for word in end.split()) and end.replace(" ", "").isalpha()


def _misspelled(chance: random.Random, name: str) -> str:
    """A name with a word left out, a word more, a letter less or two words swapped."""
    words = name.split("_")
    how = chance.randrange(3)
    if how == 0 and len(words) > 1:
        at = chance.randrange(len(words) - 1)
        words[at], words[at + 1] = words[at + 1], words[at]
        return "_".join(words)
    at = chance.randrange(1, len(name) - 1)
    return name[:at] + name[at + 1 :] if how == 1 and name[at] != "_" else name + ("s" if name.islower() else "S")


def _no_field(chance: random.Random) -> Fact | None:
    found = of_field(chance, lambda field: "_" in field.name and not field.name[-1].isdigit() and len(field.name) > 7)
    if found is None:
        return None
    message, field, words = found
    wrong = _misspelled(chance, field.name)
    others = [other.name for other in message.fields if other is not field]
    if message.field(wrong) or not others:
        return None
    return both({**words, "f": chance.choice(others)}, field.name, wrong)


def _no_message(chance: random.Random) -> Fact | None:
    message = some_message(chance)
    wrong = _misspelled(chance, message.name)
    if wrong in reference().dialect.messages or message.name[-1].isdigit():
        return None
    return both(named(message), message.name, wrong)


def _no_entry(chance: random.Random) -> Fact | None:
    found = _entry_field(chance)
    if found is None:
        return None
    words, entries = found
    name, other = (each[0] for each in chance.sample(entries, 2))
    wrong = _misspelled(chance, name)
    if wrong == name or name[-1].isdigit() or "_" not in name:
        return None
    return both({**words, "e": other}, name, wrong)


@cache
def _commands() -> tuple[tuple[str, int, tuple[tuple[str, str, str], ...]], ...]:
    found = []
    for entry in reference().dialect.enums["MAV_CMD"].entries:
        parameters = []
        for parameter in entry.parameters:
            stated = dict(parameter.attributes)
            if stated.get("label") and not stated.get("reserved"):
                parameters.append((parameter.number, stated["label"].lower(), stated.get("units", "")))
        if not entry.lifecycle.wip:
            found.append((entry.name, entry.value, tuple(parameters)))
    return tuple(found)


def _command(chance: random.Random) -> Fact:
    name, value, _ = chance.choice(_commands())
    return both({"c": name}, value, value + chance.choice([1, 2, 100]))


def _parameter(chance: random.Random) -> Fact | None:
    name, _, parameters = chance.choice(_commands())
    if len(parameters) <= 1:
        return None
    number, label, _ = chance.choice(parameters)
    wrong = chance.choice([other[0] for other in parameters if other[0] != number])
    return both({"c": name, "l": label}, number, wrong)


def _parameter_unit(chance: random.Random) -> Fact | None:
    name, _, parameters = chance.choice(_commands())
    known = [each for each in parameters if each[2] in OTHER_UNITS]
    if not known:
        return None
    number, label, unit = chance.choice(known)
    return both({"c": name, "l": label, "n": number}, unit, chance.choice(OTHER_UNITS[unit]))


MAKERS: Mapping[str, Maker] = {
    "enum": _enum,
    "short": _short,
    "no_field": _no_field,
    "no_message": _no_message,
    "no_entry": _no_entry,
    "command": _command,
    "param": _parameter,
    "param_unit": _parameter_unit,
}
"""By the kind of phrasing that each fills."""
