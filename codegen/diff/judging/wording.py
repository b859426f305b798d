"""The likeness of two names or two texts: a respelling, a better text, or words for something else."""

import re
from collections.abc import Callable, Collection, Iterable
from enum import StrEnum
from functools import cache

from codegen.diff.judging.words import (
    excluding,
    exclusive_groups,
    is_negated,
    is_respelt,
    is_short_for,
    is_slip,
    stem,
)
from codegen.pattern import pattern

_PARTS = pattern(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_WORD = pattern(r"[a-z]+|\d+(?:\.\d+)?")
_ADDRESS = pattern(r"https?://\S+|www\.\S+", re.IGNORECASE)
_SIGNED = pattern(r"[a-z]+|-?\d+")
_CLAUSE = pattern(r"[,;.()/]|\band\b|\bor\b|\belse\b|\botherwise\b")

_PLACEHOLDERS = frozenset({"empty", "reserved", "unused", "none", "undefined", "unset", "spare", "n/a", "tbd"})


def _words(text: str) -> list[str]:
    return text.split()


IDLE = frozenset(
    _words(
        "a an and are as at be by for from if in into is it its of on or that the this to was were where which with "
        "will can may must should set use used using value values parameter param future whichever"
    )
)
_FILLING = frozenset({"0", "nan", "zero", "send", "all", "remaining", "params", "parameters", "ignored", "yet"})
_MOST_HYPHENATED = 2
"""Words that one word is in a text with hyphens."""
_GENERAL = frozenset(_words("mav type mode status state flag id comp kind option enum instance index number"))
_NEGATING = frozenset({"not", "no", "non", "un", "dis", "in", "never"})
_TURNING = frozenset({"counter", "anti", "not", "clockwis", "no"})


class Likeness(StrEnum):
    """The likeness of two wordings.

    UNSAID: at least one says nothing. NEAR: most words of one are in the other. VAGUE: some are. OPPOSITE: a word is
    replaced by one that excludes it; DISPUTED: so it is, but much else is another, too.
    """

    SAME = "same"
    NEAR = "near"
    VAGUE = "vague"
    UNSAID = "unsaid"
    OTHER = "other"
    DISPUTED = "disputed"
    OPPOSITE = "opposite"


def name_likeness(old: str, new: str, whole: str = "") -> Likeness:
    """Return how alike two names are, whatever prefix they have; ``whole`` is the name of the enum that they belong to.

    Letters of another case, prefixes, abbreviations, plurals and the order of words are no difference. NEAR is a name
    that says less or more than the other, or differs by a letter.
    """
    around = {*_names(whole), *_GENERAL}
    before, after = _without(_names(old), around), _without(_names(new), around)
    texts = [("".join(side), "".join(part)) for side, part in ((before, _names(old)), (after, _names(new)))]
    if sorted(before) == sorted(after) or any(one == other for one, other in zip(*texts, strict=True)):
        return Likeness.SAME
    if _is_opposed(*_unmatched(_names(old), _names(new)), is_text=True):
        return Likeness.OPPOSITE  # though a word of it may be one of the prefix, too
    gone, come = _unmatched(before, after)
    if _is_opposed(gone, come):
        return Likeness.OPPOSITE
    if not gone and not come:
        return Likeness.NEAR  # by abbreviations, which may be other words: auto, autotune
    if not gone or not come:
        return Likeness.NEAR if len(before) != len(gone) or len(after) != len(come) else Likeness.OTHER
    if any(word.isdigit() for word in (*gone, *come)):
        return Likeness.OTHER
    if len(gone) == len(come) == 1 and is_slip(gone[0], come[0]):
        is_swapped = sorted(gone[0]) == sorted(come[0]) and len(gone[0]) >= _LONG
        return Likeness.SAME if is_swapped else Likeness.NEAR
    if set(_names(old)) <= _GENERAL or set(_names(new)) <= _GENERAL:
        return Likeness.VAGUE
    shared = [word for word in before if word not in gone and len(word) > 3]
    return Likeness.VAGUE if shared else Likeness.OTHER


@cache
def text_likeness(old: str, new: str) -> Likeness:
    """Return how alike two texts are, by their words without those that carry nothing."""
    if is_unsaid(old) or is_unsaid(new):
        return Likeness.UNSAID
    before, after = words_of(old), words_of(new)
    if not any(map(_is_telling, before ^ after)) and _are_exchanged(old, new):
        return Likeness.OPPOSITE
    if before == after:
        return Likeness.DISPUTED if _is_reordered(old, new) else Likeness.SAME
    gone, come = _differing(old, new)
    common = min(len(before) - len(gone), len(after) - len(come))
    least = min(len(before), len(after))
    if not least:
        return Likeness.UNSAID
    share = common / least
    if _is_opposed(gone, come, is_text=True):
        return Likeness.OPPOSITE if share >= 0.5 or least <= 3 else Likeness.DISPUTED
    if share >= 0.6 and not any(word.isdigit() for word in gone):
        return Likeness.NEAR
    return Likeness.VAGUE if share >= 0.3 else Likeness.OTHER


def common_share(old: str, new: str, of: Callable[[int, int], int] = max) -> float:
    """Return which share of the words of the longer text, or of the shorter one, both have in some spelling."""
    before, after = words_of(old), words_of(new)
    gone, come = _differing(old, new)
    others = [word for word in gone if not any(len(word) >= _LONG and is_slip(word, other) for other in come)]
    return (len(before) - len(others)) / max(of(len(before), len(after)), 1)


def is_reworded(old: str | None, new: str | None) -> bool:
    """Return whether a text has other words, beyond their spelling: whether they mean the same a person can tell."""
    return any(_differing(without_addresses(old or ""), without_addresses(new or "")))


@cache
def _differing(old: str, new: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the words of each of two texts that the other does not have in any spelling."""
    before, after = words_of(old), words_of(new)
    gone, come = _unmatched(sorted(before - after), sorted(after - before))
    return tuple(gone), tuple(come)


def is_replaced(names: tuple[str, str], texts: tuple[str, str]) -> bool:
    """Return whether both name and text have one word in place of another, and it is the same one in both."""
    of_names = _unmatched(*(_names(name) for name in names))
    of_texts = _unmatched(*(sorted(words_of(text)) for text in texts))
    return all(not set(one).isdisjoint(other) for one, other in zip(of_names, of_texts, strict=True))


def other_word(old: str, new: str) -> tuple[str, str] | None:
    """The one word in which two texts differ, where the second has another word in its place and not a respelling."""
    sets = words_of(old), words_of(new)
    if len(sets[0] - sets[1]) > _MOST_HYPHENATED or len(sets[1] - sets[0]) > _MOST_HYPHENATED:
        return None
    before, after = (
        [word for word in _WORD.findall(text.lower().replace("re-", "re")) if word not in IDLE] for text in (old, new)
    )
    if len(before) != len(after):
        return None
    differing = [pair for pair in zip(before, after, strict=True) if stem(pair[0]) != stem(pair[1])]
    if len(differing) != 1 or any(word.isdigit() for word in differing[0]):
        return None
    one, other = (stem(word) for word in differing[0])
    return None if is_respelt(one, other) else differing[0]


def _are_exchanged(old: str, new: str) -> bool:
    """Return whether both texts tell of the same things and numbers, but put others of them together.

    ``positive is clockwise, negative is counter-clockwise`` and the reverse have the same words.
    """
    sides = [[_telling(clause) for clause in _CLAUSE.split(text.lower())] for text in (old, new)]
    before, after = ([clause for clause in side if len(clause) > 1] for side in sides)
    if len(before) < 2 or len(before) != len(after):
        return False
    same_words = sorted(word for clause in before for word in clause) == sorted(
        word for clause in after for word in clause
    )
    return same_words and sorted(map(sorted, before)) != sorted(map(sorted, after))


def _is_reordered(old: str, new: str) -> bool:
    """Return whether texts of the same words list things of one kind in another
    order: ``w, x, y, z`` and ``x, y, z, w``.
    """
    sides = [[word for word in map(stem, _WORD.findall(text.lower())) if excluding(word)] for text in (old, new)]
    for group in exclusive_groups() if sides[0] != sides[1] else ():
        before, after = ([word for word in side if word in group] for side in sides)
        if len(set(before)) > 2 and before != after and sorted(before) == sorted(after):
            return True
    return False


@cache
def _telling(clause: str) -> tuple[str, ...]:
    """The numbers of a clause, and its words that exclude others."""
    words = (stem(word) for word in _SIGNED.findall(clause))
    return tuple(filter(_is_telling, words))


def _is_telling(word: str) -> bool:
    return word.lstrip("-").isdigit() or word in _TURNING or bool(excluding(word))


def is_unsaid(text: str) -> bool:
    """Return whether a text says nothing: there is none, or it says that the thing is empty or reserved."""
    words = _WORD.findall(text.lower())
    return not words or (words[0] in _PLACEHOLDERS and all(word in _PLACEHOLDERS | IDLE | _FILLING for word in words))


def says_reserved(name: str) -> bool:
    """Return whether a name says that the number means nothing (yet)."""
    return not {"reserved", "unused", "spare", "empty"}.isdisjoint(_plain(name))


def says_private(name: str, text: str) -> bool:
    """Return whether a number is for anybody's own use."""
    found = {*_plain(name), *_WORD.findall(text.lower())}
    return not {"user", "private", "custom", "privately"}.isdisjoint(found)


def names_of(text: str, names: Iterable[str]) -> bool:
    """Return whether a text has any of some names as they are written."""
    return any(re.search(rf"(?<!\w){re.escape(name)}(?!\w)", text) for name in names)


@cache
def words_of(text: str) -> frozenset[str]:
    """The words of a text that carry something, in one spelling."""
    return frozenset(stem(word) for word in _WORD.findall(text.lower()) if word not in IDLE)


def without_addresses(text: str) -> str:
    """Return a text without the addresses of pages, whose words and numbers say nothing of it."""
    return _ADDRESS.sub(" ", text) if "://" in text or "www." in text.lower() else text


@cache
def _names(name: str) -> tuple[str, ...]:
    return tuple(stem(part.lower()) for part in _PARTS.findall(name))


def _plain(name: str) -> set[str]:
    return {part.lower() for part in _PARTS.findall(name)}


def _without(words: Iterable[str], around: Collection[str]) -> list[str]:
    words = list(words)
    return [word for word in words if word not in around] or words[-1:]


def _unmatched(before: Iterable[str], after: Iterable[str]) -> tuple[list[str], list[str]]:
    """Return the words of each text that the other lacks, be it in full or shortened."""
    gone, come = [], list(after)
    for word in before:
        match = next((other for other in come if other == word), None) or next(
            (other for other in come if is_short_for(word, other)), None
        )
        if match is None:
            gone.append(word)
        else:
            come.remove(match)
    return gone, come


def _is_opposed(gone: Collection[str], come: Collection[str], *, is_text: bool = False) -> bool:
    if any(not excluding(word).isdisjoint(come) for word in gone):
        return True
    if is_text:
        return False
    for one, other in ((gone, come), (come, gone)):
        if not one and not _NEGATING.isdisjoint(other):
            return True
    return any(is_negated(word, other) or is_negated(other, word) for word in gone for other in come)


_LONG = 8
"""Letters of a word in which two that changed places make no other word."""
