"""The entry of an enum that words mean: by its name without what all names begin with, or by its description."""

from collections import Counter
from collections.abc import Sequence
from functools import cached_property

from codegen.model.dialect.dialect import EnumDefinition, EnumEntry
from codegen.once import once
from codegen.pattern import pattern

_IDLE = frozenset((
    "a", "an", "the", "is", "are", "for", "means", "of", "to", "mode", "state", "type", "and", "value", "it", "in",
    "on", "if", "be", "was", "has", "have", "had", "with", "by", "that", "this", "its", "only", "not", "or", "as",
    "at", "from", "than", "set", "when", "while", "treated", "really", "just", "vehicle", "current",
))  # fmt: skip
_NO_WORDS = frozenset((
    "hz", "m", "cm", "mm", "s", "ms", "us", "v", "mv", "a", "ma", "deg", "bytes", "byte", "bits", "times", "fields",
    "elements", "entries", "values", "samples", "seconds", "minutes", "metres", "meters", "percent", "messages",
    "per", "hours", "volts", "degrees", "cells", "channels", "characters", "floats",
))  # fmt: skip
_WORD = pattern(r"[a-z0-9]+")
_SAME = {"lost": "loss", "ok": "accepted", "temporarily": "temp"}


class Meaning:
    """The words of the entries of an enum."""

    def __init__(self, enum: EnumDefinition) -> None:
        """Read the names and the descriptions once."""
        self._enum = enum
        names = {entry.name: entry.name.lower().split("_") for entry in enum.entries}
        shared = _shared(list(names.values()))
        self._names = {
            name: [word for word in words[shared:] if word not in _IDLE] or words[shared:]
            for name, words in names.items()
        }
        self._likes: dict[str, frozenset[str]] = {}

    @cached_property
    def _texts(self) -> dict[str, list[str]]:
        return {entry.name: _content(entry.description.lower()) for entry in self._enum.entries}

    def is_named(self, value: int, words: str) -> bool:
        """Return whether words are those of the entry that has a value."""
        content = _content(words)
        return any(
            entry.value == value and content and self._named(entry, content) >= _COVERS for entry in self._enum.entries
        )

    def is_sure(self, entry: EnumEntry, words: str) -> bool:
        """Return whether words are those of the name of an entry, and not only of its description."""
        return self._named(entry, _content(words)) >= _COVERS

    def meant_otherwise(self, value: int, words: str, *, is_name: bool = False) -> EnumEntry | None:
        """The one entry that words mean, where it has another value; None where that is not clear."""
        content = _content(words)
        if not content or set(content) & _NO_WORDS:
            return None
        stated = next((entry for entry in self._enum.entries if entry.value == value), None)
        if stated is not None and stated.name.lower() in words.lower():
            return None  # the whole name is there, whatever other one it is like
        scores = {entry.name: self._named(entry, content) for entry in self._enum.entries}
        best = max(scores.values(), default=0)
        own = scores[stated.name] if stated is not None else 0
        if best >= _COVERS:
            meant = [entry for entry in self._enum.entries if scores[entry.name] == best]
            if len(meant) != 1 or meant[0].value == value or own >= best:
                return None
            if best < _EXACT and stated is not None and (own or _shared_words(content, self._names[stated.name])):
                return None  # another wording of the right one
            if best < _EXACT and stated is not None and self._told(stated, content) >= 1:
                return None
            return meant[0]
        if is_name:
            return self._by_end(content, value)
        told = {entry.name: self._told(entry, content) for entry in self._enum.entries}
        most = max(told.values(), default=0)
        meant = [entry for entry in self._enum.entries if told[entry.name] == most]
        if most < 1 or len(meant) != 1 or meant[0].value == value or len(content) < 2:
            return None
        if stated is None or told[stated.name] > _HALF:
            return None
        return meant[0]

    def marked_otherwise(self, value: int, words: str) -> EnumEntry | None:
        """The one entry with a word in its name that no other has, where that word stands beside another value.

        The entry that has the value may have no word in common with what stands there, neither in its name nor in its
        description.
        """
        content = [word for word in _content(words) if len(word) > _SHORT]
        own = next((entry for entry in self._enum.entries if entry.value == value), None)
        if not content or (own is not None and self._told(own, content)):
            return None
        meant = [entry for entry in self._enum.entries if _shared_words(content, self._own_words[entry.name])]
        return meant[0] if len(meant) == 1 and meant[0].value != value else None

    @cached_property
    def _own_words(self) -> dict[str, list[str]]:
        """By entry the words of its name that are in no other name."""
        in_names = Counter(word for words in self._names.values() for word in set(words))
        return {
            name: [word for word in words if in_names[word] == 1 and len(word) > _SHORT and word not in _EVERYWHERE]
            for name, words in self._names.items()
        }

    def _named(self, entry: EnumEntry, content: Sequence[str]) -> int:
        tokens = self._names[entry.name]
        if list(content) == tokens:
            return _LETTER
        if len(content) == len(tokens) and _all_in(content, tokens) and _all_in(tokens, content):
            return _EXACT
        joined = "".join(tokens)
        if len(content) > 2 and len(tokens) == 1 and "".join(word[0] for word in content) == joined:
            return _EXACT
        if "".join(content) == joined:
            return _EXACT
        if len(tokens) == len(content) + 1 and _all_in(content, tokens):
            return _COVERS
        if len(tokens) > 1 and len(content) == len(tokens) + 1 and _all_in(tokens, content):
            return _COVERS
        return 0

    def _by_end(self, content: Sequence[str], value: int) -> EnumEntry | None:
        """The entry whose name ends as a constant's does."""
        for size in range(len(content) - 1, 0, -1):
            end = list(content[-size:])
            meant = [entry for entry in self._enum.entries if self._names[entry.name] == end]
            if meant:
                return meant[0] if meant[0].value != value else None
        return None

    def _told(self, entry: EnumEntry, content: Sequence[str]) -> float:
        known = self._known[entry.name]
        return sum(not known.isdisjoint(self._alike(word)) for word in content) / len(content)

    @cached_property
    def _known(self) -> dict[str, frozenset[str]]:
        """By entry the words of its name and of its description."""
        return {name: frozenset((*words, *self._texts[name])) for name, words in self._names.items()}

    @cached_property
    def _vocabulary(self) -> frozenset[str]:
        return frozenset().union(*self._known.values())

    def _alike(self, word: str) -> frozenset[str]:
        """Return the words of all entries that are like a word, looked for once."""
        found = self._likes.get(word)
        if found is None:
            if len(self._likes) >= _MOST:
                self._likes.clear()
            found = self._likes[word] = frozenset(token for token in self._vocabulary if _is_like(word, token))
        return found


_MOST = 1000
"""So many words are remembered with those that are like them."""
_SHORT = 3
"""A word of so many letters stands for anything."""
_EVERYWHERE = frozenset((
    "enabled", "enable", "none", "other", "unknown", "generic", "last", "first", "custom", "reserved", "general",
    "default", "test", "number", "mask", "flag", "flags", "status", "data", "system", "position", "control", "input",
    "output", "available", "supported", "request", "time", "same", "second", "third", "left", "right",
))  # fmt: skip
"""Words of names that say much else in documents."""
_LETTER, _EXACT, _COVERS, _HALF = 4, 3, 2, 0.5


def _shared(names: Sequence[Sequence[str]]) -> int:
    shared = 0
    while (
        names
        and all(len(words) > shared + 1 for words in names)
        and len({tuple(words[: shared + 1]) for words in names}) == 1
    ):
        shared += 1
    return shared


def _content(words: str) -> list[str]:
    return [_SAME.get(word, word) for word in _WORD.findall(words.lower()) if word not in _IDLE]


def _all_in(words: Sequence[str], tokens: Sequence[str]) -> bool:
    left = list(tokens)
    for word in words:
        same = next((token for token in left if _is_like(word, token)), None)
        if same is None:
            return False
        left.remove(same)
    return True


def _shared_words(words: Sequence[str], tokens: Sequence[str]) -> bool:
    return any(_is_like(word, token) for word in words for token in tokens)


def _is_like(word: str, token: str) -> bool:
    if word == token:
        return True
    short, long = (word, token) if len(word) < len(token) else (token, word)
    return len(short) > 2 and long.startswith(short) and not long[-1].isdigit()


@once
def meaning(enum: EnumDefinition) -> Meaning:
    """The words of an enum, read once."""
    return Meaning(enum)
