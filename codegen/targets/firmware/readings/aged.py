"""Statements that forget what code has set, but not of late: readings count how long ago that was."""

import math
from collections.abc import Iterable, Iterator

from codegen.model.code.payload_code import UNKNOWN, indented
from codegen.model.quantities.set_together import set_together
from codegen.model.vehicle import Component, Quantity, Reading
from codegen.targets.firmware.messages.payload import SpelledCode
from codegen.targets.firmware.words import SET_AGE


def aged(reading: Reading, code: SpelledCode) -> Iterator[str]:
    """Forget what nothing has set for a while: readings count how long ago it was."""
    component = reading.component
    for quantity in component.quantities.values():
        if not quantity.ages_by_readings:
            continue
        stale_ms = quantity.trust.stale_after_ms
        age = code.word(component.name, f"{quantity.attribute}_age")
        cited = cited_in(quantity.cited("stale_after"))
        yield f"# {quantity.path} is forgotten {stale_ms} ms after one was set{cited}."
        yield f"if {age} != {code.unknown()}:"
        yield f"    {age} = {age} + 1"
        yield f"    if {age} > {math.ceil((stale_ms or 0) / component.read_every_ms)}:"
        yield f"        {age} = {UNKNOWN}"
        yield from indented(_unknown(quantity, code), 2)
        if extremes := component.extremes(quantity):
            yield from indented([*_found(extremes, quantity, code)])
    yield from _set_together(component, code)


def _set_together(component: Component, code: SpelledCode) -> Iterator[str]:
    """Forget what code sets together; what is counted of a reading stays where that is taken."""
    together = set_together(component)
    if together is None or component.returns is None:
        return
    name = component.name
    age = code.word(name, SET_AGE)
    cited = cited_in(component.returns.count.cited("restarting_stale_after"))
    yield f"# What else code sets is forgotten {together.stale_ms} ms after the last of it{cited}."
    yield f"if {age} != {code.unknown()}:"
    yield f"    {age} = {age} + 1"
    yield f"    if {age} > {together.readings}:"
    yield f"        {age} = {UNKNOWN}"
    yield from (f"        {code.word(name, each.attribute)} = {UNKNOWN}" for each in together.alone)
    for reading, counted in together.counted:
        yield f"        if {code.number_of(code.word(name, reading.word('is_read')))} != 1:"
        yield from (f"            {code.word(name, each.attribute)} = {UNKNOWN}" for each in counted)


def _found(extremes: Iterable[Quantity], listed: Quantity, code: SpelledCode) -> Iterator[str]:
    """Find the lowest and the highest value of a list, of those that are known."""
    words = [(each, code.word(each.component, each.attribute)) for each in extremes]
    yield from (f"{word} = {UNKNOWN}" for _, word in words)
    yield "count = 0"
    yield f"while count < {max(listed.elements or (0,))}:"
    yield f"    value = {code.number_of(code.half(listed, 0, 'count'))}"
    yield "    count += 1"
    yield f"    if value == {UNKNOWN}:"
    yield "        continue"
    for extreme, word in words:
        number = code.number_of(word)
        if extreme.derivation.is_of_lowest:
            yield f"    if {word} == {code.unknown()}:"
            yield f"        {word} = value"
        yield f"    if value {'<' if extreme.derivation.is_of_lowest else '>'} {number}:"
        yield f"        {word} = value"


def all_unknown(quantity: Quantity, component: Component, code: SpelledCode) -> list[str]:
    """Make a list unknown, and the lowest and the highest of it."""
    extremes = (f"{code.word(each.component, each.attribute)} = {UNKNOWN}" for each in component.extremes(quantity))
    return [*_unknown(quantity, code), *extremes]


def _unknown(quantity: Quantity, code: SpelledCode) -> list[str]:
    """Make a list unknown. ``count`` counts its values, since one more variable would put all on the heap."""
    return [
        "count = 0",
        f"while count < {max(quantity.elements or (0,))}:",
        f"    {code.half(quantity, 0, 'count')} = {UNKNOWN}",
        "    count += 1",
    ]


def cited_in(criterion: str) -> str:
    """A criterion as the end of a comment, or nothing."""
    return f" ({criterion})" if criterion else ""
