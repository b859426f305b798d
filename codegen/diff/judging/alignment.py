"""Two texts side by side, word by word: which words both have in one order, and the pieces in which they differ."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from difflib import SequenceMatcher
from functools import cache
from typing import NamedTuple

from codegen.diff.judging.phrases import in_one_wording, with_unknown
from codegen.diff.judging.wording import IDLE
from codegen.diff.judging.words import stem
from codegen.pattern import pattern

_TOKEN = pattern(r"(?<![\w.)\]])-?\d+(?:\.\d+)?(?!\w)|[a-z0-9][a-z0-9_]*")
_HEXADECIMAL = pattern(r"0x[0-9a-f]+")
_FILLING = frozenset(
    map(stem, (
        "also", "always", "just", "simply", "usually", "typically", "generally", "normally", "currently", "e", "g",
        "i", "etc", "please", "note", "s", "has", "have", "had", "been", "being", "does", "do", "when", "whether",
        "there", "then", "they", "their", "these", "those", "which", "any", "each", "such", "so", "given", "mav",
        "field", "message", "command", "vehicle",
    ))
) | {"number", "flag"}  # fmt: skip
"""Words that a better text has more or fewer of without saying more or less."""

_LEAST_COMMON = 0.2
"""Of the words of the longer text: with fewer in both, texts are not laid beside each other."""
_MOST_WORDS = 500
"""Words between the first and the last that differ: more take a time that grows with their cube."""


class Word(NamedTuple):
    """A word in one spelling, and where it ends in its text."""

    stem: str
    end: int


class Piece(NamedTuple):
    """A place where two texts differ: the words that are ``gone``, those that ``come``, and both as written.

    What is written begins behind the last word that both have.
    """

    gone: tuple[str, ...]
    come: tuple[str, ...]
    was: str
    now: str

    @property
    def is_exchange(self) -> bool:
        """Return whether a phrase stands where another one stood."""
        return bool(self.gone) and bool(self.come)


class Alignment(NamedTuple):
    """Two texts: the pieces in which they differ, and how many words both have and the longer one has."""

    pieces: tuple[Piece, ...]
    kept: int
    longest: int

    @property
    def share(self) -> float:
        """Return which share of the longer text both have."""
        return self.kept / max(self.longest, 1)


@cache
def aligned(old: str, new: str) -> Alignment:
    """Return two texts side by side; without pieces where they have next to nothing in common, or differ all along."""
    texts = [with_unknown(in_one_wording(text)) for text in (old, new)]
    before, after = (_words(text) for text in texts)
    longest = max(len(before), len(after))
    first, last = _shared_ends(before, after)
    middles = before[first : len(before) - last], after[first : len(after) - last]
    if all(middles):
        stems = [{word.stem for word in side} for side in (before, after)]
        if len(stems[0] & stems[1]) < _LEAST_COMMON * longest or max(map(len, middles)) > _MOST_WORDS:
            return Alignment((), 0, longest)
    starts = [words[first - 1].end if first else 0 for words in (before, after)]
    pieces = tuple(_pieces(texts, middles, starts))
    kept = len(before) - sum(len(piece.gone) for piece in pieces)
    return Alignment(pieces, kept, longest)


def _words(text: str) -> list[Word]:
    return [Word(word, one.end()) for one in _TOKEN.finditer(text.lower()) if (word := _carried(one[0]))]


@cache
def _carried(word: str) -> str:
    """A word in one spelling; empty where it carries nothing."""
    if word in IDLE:
        return ""
    if word.startswith("0x") and _HEXADECIMAL.fullmatch(word):
        return str(int(word, 16))
    spelt = "0" if word == "zero" else word.rstrip("0").rstrip(".") if "." in word else stem(word)
    return "" if spelt in _FILLING else spelt


def _shared_ends(before: Sequence[Word], after: Sequence[Word]) -> tuple[int, int]:
    """Return how many words two texts have alike at their beginning, and behind that at their end."""
    least = min(len(before), len(after))
    first = 0
    while first < least and before[first].stem == after[first].stem:
        first += 1
    last = 0
    while last < least - first and before[-1 - last].stem == after[-1 - last].stem:
        last += 1
    return first, last


def _pieces(texts: Sequence[str], words: Sequence[Sequence[Word]], starts: Sequence[int]) -> Iterator[Piece]:
    """Yield where the ``words`` of two texts differ, which begin at ``starts`` there."""
    before, after = ([word.stem for word in side] for side in words)
    for old, new in _together(_differences(before, after)):
        gone, come = before[old.start : old.stop], after[new.start : new.stop]
        if "".join(gone) != "".join(come):
            told = (_written(*each) for each in zip(texts, words, starts, (old, new), strict=True))
            yield Piece(*_without_common(gone, come), *told)


def _differences(before: Sequence[str], after: Sequence[str]) -> Iterator[tuple[range, range]]:
    """Yield where two rows of words differ."""
    if not before or not after:
        if before or after:
            yield range(len(before)), range(len(after))
        return
    for kind, start, end, other_start, other_end in SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
        if kind != "equal":
            yield range(start, end), range(other_start, other_end)


def _together(found: Iterable[tuple[range, range]]) -> Iterator[tuple[range, range]]:
    """Yield differences, those as one that are a word apart where one of them is gone and the other one new.

    ``full throttle`` and ``throttle as it is set`` are one phrase for another.
    """
    last: tuple[range, range] | None = None
    for old, new in found:
        is_near = last is not None and old.start - last[0].stop == 1
        if last is not None and is_near and not last[1] and not old:
            last = range(last[0].start, old.stop), range(last[1].start, new.stop)
            continue
        if last is not None:
            yield last
        last = old, new
    if last is not None:
        yield last


def _without_common(gone: Sequence[str], come: Sequence[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The words of a difference that are not on both sides of it."""
    if set(gone).isdisjoint(come):
        return tuple(gone), tuple(come)
    common = Counter(gone) & Counter(come)
    return tuple((Counter(gone) - common).elements()), tuple((Counter(come) - common).elements())


def _written(text: str, words: Sequence[Word], start: int, where: range) -> str:
    """Return the part of a text in which some words stand, from the end of the word before them."""
    if not where:
        return ""
    return text[words[where.start - 1].end if where.start else start : words[where.stop - 1].end]
