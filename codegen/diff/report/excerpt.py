"""Two long texts, as far as they differ: a reviewer sees what changed and a few words around it."""

from collections.abc import Sequence
from difflib import SequenceMatcher

_LONG = 70
"""Texts of so many characters are shown whole."""
_MOST = 240
_AROUND = 4
"""Words on each side of what changed."""


def difference(old: str | None, new: str | None) -> tuple[str | None, str | None]:
    """Return both texts, of long ones the words that differ with a few around them, at most 240 characters each.

    Words are never cut; what is left out is told by three dots.
    """
    if old is None or new is None:
        return old and _limited(old), new and _limited(new)
    if max(len(old), len(new)) <= _LONG:
        return old, new
    olds, news = old.split(), new.split()
    runs = _runs(olds, news)
    if not runs:  # in spaces alone
        return _limited(old), _limited(new)
    return _excerpt(olds, [run[:2] for run in runs]), _excerpt(news, [run[2:] for run in runs])


def _runs(olds: Sequence[str], news: Sequence[str]) -> list[tuple[int, int, int, int]]:
    """Return where words differ: ``olds[i1:i2]`` became ``news[j1:j2]``. Neighbours
    that share their surroundings are one.
    """
    start, most = 0, min(len(olds), len(news))
    while start < most and olds[start] == news[start]:
        start += 1
    end = 0
    while end < most - start and olds[-1 - end] == news[-1 - end]:
        end += 1
    middle = SequenceMatcher(None, olds[start : len(olds) - end], news[start : len(news) - end], autojunk=False)
    found: list[tuple[int, int, int, int]] = []
    for kind, i1, i2, j1, j2 in middle.get_opcodes():
        if kind == "equal":
            continue
        run = (start + i1, start + i2, start + j1, start + j2)
        if found and run[0] - found[-1][1] <= 2 * _AROUND:
            run = (found[-1][0], run[1], found.pop()[2], run[3])
        found.append(run)
    return found


def _excerpt(words: Sequence[str], runs: Sequence[tuple[int, ...]]) -> str:
    spans = [(max(0, first - _AROUND), min(len(words), behind + _AROUND)) for first, behind in runs]
    parts = [("" if begin == 0 else "... ") + " ".join(words[begin:end]) for begin, end in spans]
    return _limited(" ".join([*parts, *([] if spans[-1][1] == len(words) else ["..."])]))


def _limited(text: str) -> str:
    """The text up to the last word that ends within the limit."""
    if len(text) <= _MOST:
        return text
    room = text[: _MOST - 4]
    return f"{(room.rpartition(' ')[0] or room).removesuffix(' ...')} ..."
