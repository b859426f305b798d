"""The words that phrasings are filled with: messages and fields of a dialect, drawn by lot."""

import random
from collections.abc import Callable
from functools import cache

from codegen.claims.reading import Reference
from codegen.commands.documents import dialect_reference
from codegen.diagnostics import Report
from codegen.model.dialect.dialect import WireField, WireMessage

Words = dict[str, str]
"""The words that fill a phrasing: by the name in its braces."""

Fact = tuple[Words, Words]
"""A true statement about a message, and the same with something wrong in it."""

Maker = Callable[[random.Random], Fact | None]
"""Draws a fact; None where what it has drawn has none."""

HALF = 0.5
ENOUGH = 3
"""Entries, or fields, of which an order can be told."""


@cache
def reference() -> Reference:
    """Return the dialect that phrasings are filled from."""
    found = dialect_reference("common", Report())
    assert found is not None
    return found


@cache
def messages() -> tuple[WireMessage, ...]:
    """The messages with names that are no words."""
    return tuple(
        message
        for message in reference().dialect.messages.values()
        if "_" in message.name and not message.definition.lifecycle.wip and len(message.fields) > 1
    )


def some_message(chance: random.Random) -> WireMessage:
    """Return any of them."""
    return chance.choice(messages())


def of_field(chance: random.Random, fits: Callable[[WireField], bool]) -> tuple[WireMessage, WireField, Words] | None:
    """A field with a property; its message, and the words for both."""
    for _ in range(400):
        message = some_message(chance)
        fields = [field for field in message.fields if fits(field) and ("_" in field.name or len(field.name) > 3)]
        if fields:
            field = chance.choice(fields)
            return message, field, {**named(message), "f": field.name, "t": field.type.name.removesuffix("_t")}
    return None


def named(message: WireMessage) -> Words:
    """Return the words for a message."""
    return {
        "m": message.name,
        "ml": message.name.lower(),
        "id": str(message.id),
        "base": str(message.base_length),
        "frame": str(message.length + 12),
    }


def both(words: Words, right: object, wrong: object, **more: str) -> Fact:
    """Return a fact of a right value and a wrong one."""
    return {**words, "v": str(right), **more}, {**words, "v": str(wrong), **more}
