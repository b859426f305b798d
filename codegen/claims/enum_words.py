"""Words for entries of an enum: which entry they mean, whatever their order, without what all names begin with."""

import re
from collections.abc import Iterator

from codegen.claims.identifier import ENTRY_VALUE
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import EnumDefinition

_IDLE = frozenset(
    [
        "a",
        "an",
        "the",
        "is",
        "are",
        "for",
        "means",
        "of",
        "to",
        "mode",
        "state",
        "type",
        "and",
        "value",
        "it",
        "in",
        "on",
        "if",
    ]
)
_UNITS = frozenset(
    [
        "hz",
        "m",
        "cm",
        "mm",
        "s",
        "ms",
        "us",
        "v",
        "mv",
        "a",
        "ma",
        "deg",
        "bytes",
        "byte",
        "bits",
        "times",
        "fields",
        "elements",
        "entries",
        "values",
    ]
)
_WORD = re.compile(r"[a-z0-9]+")


def is_entry(enum: EnumDefinition, written: str, value: int) -> bool:
    """Whether words are those of the entry that has a value."""
    words = _words(written)
    tokens = _tokens(enum)
    return any(entry.value == value and words and _are_same(words, tokens[entry.name]) for entry in enum.entries)


def _words(written: str) -> list[str]:
    return [word for word in _WORD.findall(written.lower()) if word not in _IDLE]


def entry_claim(
    reading: Reading, name: str, enum: EnumDefinition, passage: Passage, found: "re.Match[str]"
) -> Iterator[Diagnostic]:
    """What is wrong with the ``value`` and ``words`` that were found; ``name`` is what they are said of."""
    words = _words(found["words"])
    if not words or set(words) & _UNITS:
        return
    stated = int(found["value"])
    tokens = _tokens(enum)
    at = next((entry for entry in enum.entries if entry.value == stated), None)
    meant = [entry for entry in enum.entries if words == tokens[entry.name]]
    is_exact = bool(meant)
    meant = meant or [entry for entry in enum.entries if _are_same(words, tokens[entry.name])]
    meant = meant or [entry for entry in enum.entries if _holds(tokens[entry.name], words)]
    meant = meant or [
        entry for entry in enum.entries if len(tokens[entry.name]) > 1 and _holds(words, tokens[entry.name])
    ]
    if len(meant) != 1 or meant[0].value == stated:
        return
    if not is_exact and at is not None and _overlaps(words, tokens[at.name]):
        return  # another wording of the right one
    text = f"{meant[0].name} is {meant[0].value}, not {stated}"
    hint = f"{stated} is {at.name}" if at else None
    place = passage.place_at(found.start("value"))
    yield reading.found(ENTRY_VALUE, place, f"{name} {found[0].strip()}", f"{name}: {text}", hint)


def _tokens(enum: EnumDefinition) -> dict[str, list[str]]:
    """The words of each entry's name, without those that all of them begin with."""
    split = {entry.name: entry.name.lower().split("_") for entry in enum.entries}
    shared = 0
    while len({tuple(words[: shared + 1]) for words in split.values() if len(words) > shared + 1}) == 1 and all(
        len(words) > shared + 1 for words in split.values()
    ):
        shared += 1
    return {name: [word for word in words[shared:] if word not in _IDLE] for name, words in split.items()}


def _holds(tokens: list[str], words: list[str]) -> bool:
    """Whether a name has all the words and one more, such as the kind of thing that it is."""
    return len(tokens) == len(words) + 1 and all(any(_is_like(word, token) for token in tokens) for word in words)


def _are_same(words: list[str], tokens: list[str]) -> bool:
    """Whether the words are those of a name, in any order, shortened or not."""
    if len(words) != len(tokens):
        return False
    left = list(tokens)
    for word in words:
        same = next((token for token in left if _is_like(word, token)), None)
        if same is None:
            return False
        left.remove(same)
    return True


def _is_like(word: str, token: str) -> bool:
    short, long = sorted((word, token), key=len)
    return short == long or (len(short) > 2 and long.startswith(short))


def _overlaps(words: list[str], tokens: list[str]) -> bool:
    return any(_is_like(word, token) for word in words for token in tokens)
