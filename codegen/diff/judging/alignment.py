"""Two texts side by side, word by word: which words both have in one order, and the pieces in which they differ."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from difflib import SequenceMatcher
from functools import cache
from itertools import takewhile
from typing import NamedTuple

from codegen.diff.judging.phrases import in_one_wording, with_unknown
from codegen.diff.judging.wording import IDLE
from codegen.diff.judging.words import is_respelt, stem

_TOKEN = re.compile(r"(?<![\w.)\]])-?\d+(?:\.\d+)?(?!\w)|[a-z0-9][a-z0-9_]*")
_FILLING = frozenset(
    map(stem, (
        "also", "always", "just", "simply", "usually", "typically", "generally", "normally", "currently", "e", "g",
        "i", "etc", "please", "note", "s", "has", "have", "had", "been", "being", "does", "do", "when", "whether",
        "there", "then", "they", "their", "these", "those", "which", "any", "each", "such", "so", "given", "mav",
        "field", "message", "command", "vehicle",
    ))
) | {"number", "flag"}  # fmt: skip
"""Words that a better text has more or fewer of without saying more or less."""


class Word(NamedTuple):
    """A word in one spelling, and where it stands in its text."""

    stem: str
    start: int
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
    """Return two texts side by side."""
    sides = [with_unknown(in_one_wording(text)) for text in (old, new)]
    before, after = (_words(text) for text in sides)
    before, after = _joined(before, after), _joined(after, before)
    stems = [word.stem for word in before], _respelt([word.stem for word in after], [word.stem for word in before])
    pieces = tuple(_pieces(sides, (before, after), stems))
    longest = max(len(before), len(after))
    gone = sum(len(piece.gone) for piece in pieces)
    return Alignment(pieces, len(before) - gone, longest)


def _words(text: str) -> list[Word]:
    found = ((_spelt(one[0]), one) for one in _TOKEN.finditer(text.lower()) if one[0] not in IDLE)
    return [Word(word, one.start(), one.end()) for word, one in found if word not in _FILLING]


def _joined(words: list[Word], others: Sequence[Word]) -> list[Word]:
    """The words of a text, two of them as one where the other text has them in one: ``main loop``, ``mainloop``."""
    known = {word.stem for word in others}
    found: list[Word] = []
    for word in words:
        if found and found[-1].stem + word.stem in known:
            found[-1] = Word(found[-1].stem + word.stem, found[-1].start, word.end)
        else:
            found.append(word)
    return found


def _spelt(word: str) -> str:
    if word == "zero":
        return "0"
    if word.startswith("0x") and word != "0x":
        return str(int(word, 16)) if re.fullmatch(r"0x[0-9a-f]+", word) else word
    return word.rstrip("0").rstrip(".") if "." in word else stem(word)


def _respelt(words: Sequence[str], others: Sequence[str]) -> list[str]:
    """The words of a text, each in the spelling of the other text that only one of them has."""
    missing = [word for word in dict.fromkeys(others) if word.isalpha() and word not in words]
    known = frozenset(others)
    return [word if word in known or not word.isalpha() else _spelling(word, missing) for word in words]


def _spelling(word: str, others: Sequence[str]) -> str:
    return next((each for each in others if is_respelt(word, each)), word)


def _pieces(
    texts: Sequence[str], words: tuple[list[Word], list[Word]], stems: tuple[list[str], list[str]]
) -> Iterator[Piece]:
    before, after = stems
    for old, new in _together(_differences(before, after)):
        gone, come = before[old.start : old.stop], after[new.start : new.stop]
        if "".join(gone) != "".join(come):
            yield Piece(
                *_without_common(gone, come), _written(texts[0], words[0], old), _written(texts[1], words[1], new)
            )


def _differences(before: Sequence[str], after: Sequence[str]) -> Iterator[tuple[range, range]]:
    """Yield where two rows of words differ; what both begin with is left out first, which most of it is."""
    first = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(before, after, strict=False)))
    matcher = SequenceMatcher(None, before[first:], after[first:], autojunk=False)
    for kind, *bounds in matcher.get_opcodes():
        if kind != "equal":
            start, end, other_start, other_end = (index + first for index in bounds)
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
    common = Counter(gone) & Counter(come)
    return tuple((Counter(gone) - common).elements()), tuple((Counter(come) - common).elements())


def _written(text: str, words: Sequence[Word], where: range) -> str:
    """What stands at some words in a text, from the end of the word before them."""
    if not where:
        return ""
    return text[words[where.start - 1].end if where.start else 0 : words[where.stop - 1].end]
