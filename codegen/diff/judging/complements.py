"""Judges short texts that begin alike and go on about another thing: ``distance to home``, ``distance to the target``.

So few words are all that is said; in longer texts what is exchanged stands between words that stay.
"""

from collections.abc import Sequence

from codegen.diff.judging.judging import HARMLESS, Judgement
from codegen.diff.judging.readings import is_one_sense
from codegen.diff.judging.units_in_words import says_unit
from codegen.diff.judging.wording import IDLE
from codegen.diff.judging.words import is_respelt, stem
from codegen.pattern import pattern

_WORD = pattern(r"[a-z0-9_]+(?:'s)?|[.;:,()\[\]\n]")
_ARTICLES = frozenset({"the", "a", "an"})
_LINKING = frozenset((
    "of", "in", "at", "from", "to", "since", "until", "till", "as", "by", "for", "per", "with", "within", "on", "onto",
    "into", "over", "under", "above", "below", "before", "after", "through", "between", "behind", "along", "across",
    "towards", "toward", "where", "during", "against", "without", "around", "that", "which", "whose", "who", "when",
    "while", "if", "is", "are", "was", "were", "has", "have", "can", "may", "must", "will", "does",
    "and", "then", "because", "due",
))  # fmt: skip
"""Words that begin what tells of which thing, place, time, way or state it is."""
_BEFORE = frozenset((
    "back", "straight", "out", "up", "down", "forward", "forwards", "backward", "backwards", "away", "home", "left",
    "right", "inside", "outside", "near", "next", "opposite", "beside", "beyond", "directly", "just", "only", "once",
    "always", "still",
))  # fmt: skip
"""Words that may stand before these, or for all of it: ``climb straight up``."""
_PLACING = frozenset(("before", "after", "between", "during", "since", "until", "above", "below", "within", "without"))
"""Words of these that exclude each other, whatever they are followed by."""
_TURNING = ({"to", "by"}, {"from", "into"}, {"from", "to"}, {"in", "out"}, {"at", "after"}, {"at", "before"})
"""Words each of which turns the sense of what stands before the other: ``climb to`` and ``climb by`` 20 m."""
_LONGEST = 8
"""Words of what is told of: more are told in a sentence built otherwise."""
_HERE = frozenset(map(stem, ("current", "present", "position", "now")))
_IT = ["where", "it"]
"""Words for the present position: ``land where it is``."""
_POINTING = frozenset({"see", "refer", "described", "defined", "above", "below", "following", "table"})


def other_complement(old: str, new: str) -> Judgement:
    """Return what comes of two texts whose first clauses begin alike and go on about another thing.

    Nothing comes of it where one of them has a word of what the other one goes on about, in any spelling, as
    ``pressure in the tank`` and ``pressure within the fuel tank``.
    """
    preposition = _other_preposition(old, new)
    if preposition is not None:
        return _doubt(*preposition)
    before, after = _first_clause(old), _first_clause(new)
    shared = 0
    while shared < min(len(before), len(after)) and stem(before[shared]) == stem(after[shared]):
        shared += 1
    head, was, now = before[:shared], before[shared:], after[shared:]
    if not _telling(head) or not all(0 < len(side) <= _LONGEST for side in (was, now)):
        return HARMLESS
    if head[-1] not in _LINKING and not all(side[0] in _LINKING or side[0] in _BEFORE for side in (was, now)):
        return HARMLESS
    if was[0] != now[0] and {was[0], now[0]} <= _PLACING:
        return _doubt(was, now)
    if _is_told(was, new) or _is_told(now, old) or says_unit(" ".join(was)) or says_unit(" ".join(now)):
        return HARMLESS
    told = [_HERE if side[:2] == _IT else _telling(side) for side in (was, now)]
    if not any(told) or any(not each and len(side) == 1 for each, side in zip(told, (was, now), strict=True)):
        return HARMLESS
    if told[0] <= _HERE >= told[1] or not _POINTING.isdisjoint((*was, *now)):
        return HARMLESS
    if is_one_sense(" ".join(was), " ".join(now)):
        return HARMLESS
    return _doubt(was, now)


def _other_preposition(old: str, new: str) -> tuple[list[str], list[str]] | None:
    """Return the one word in which two texts differ, with the word before it, where it turns the sense of that."""
    before, after = (_WORD.findall(text.lower()) for text in (old, new))
    differing = [index for index, pair in enumerate(zip(before, after, strict=False)) if pair[0] != pair[1]]
    if len(before) != len(after) or len(differing) != 1 or "distance" in before:
        return None
    where = differing[0]
    if {before[where], after[where]} not in _TURNING:
        return None
    first = max(0, where - 1)
    return before[first : where + 1], after[first : where + 1]


def _doubt(was: Sequence[str], now: Sequence[str]) -> Judgement:
    return Judgement(doubt=f"whether {' '.join(now)!r} in place of {' '.join(was)!r} is another meaning")


def _first_clause(text: str) -> list[str]:
    words: list[str] = []
    for word in _WORD.findall(text.lower()):
        if not word[0].isalnum():
            if words:
                break
        elif word not in _ARTICLES:
            words.append(word.removesuffix("'s"))
    return words


def _telling(words: list[str]) -> set[str]:
    return {stem(word) for word in words if word not in IDLE and word not in _LINKING}


def _is_told(words: list[str], text: str) -> bool:
    """Return whether a text has one of some words."""
    others = _telling([word.removesuffix("'s") for word in _WORD.findall(text.lower()) if word[0].isalnum()])
    return any(word == other or is_respelt(word, other) for word in _telling(words) for other in others)
