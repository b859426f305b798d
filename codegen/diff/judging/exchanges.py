"""Judges the pieces in which two texts differ: a phrase for another one, two that changed places, an alternative.

Who says a thing anew says all of it anew, adds a sentence, or leaves a word out. Where one phrase is another and all
around it stays, it is what the number is that was changed.
"""

import re
from collections.abc import Sequence

from codegen.diff.judging.alignment import Alignment, Piece, aligned
from codegen.diff.judging.judging import HARMLESS, Judgement
from codegen.diff.judging.units_in_words import says_unit
from codegen.diff.judging.wording import IDLE
from codegen.diff.judging.words import is_respelt, is_slip
from codegen.pattern import pattern

_LEAST_FRAME, _SMALL_FRAME = 3, 2
"""Words around a phrase that both texts have; fewer where the phrase is what is counted from."""
_LEAST_SHARE = 0.4
"""Of the words of the longer text, for one phrase to be exchanged in it."""
_LONGEST_PHRASE = 20
"""Words of a phrase, in place of which another one stands: more are told in sentences of their own."""
_MOST_PIECES = 6
"""In which two texts differ, some of them by a slip of the pen."""
_NEARLY_ALL = 0.7
"""Of the words of the longer text, for it to be exchanged while something else is added or gone."""
_LEAST_LETTERS = 4
"""Of a word with a slip of the pen, to be known as another one."""
_LONGEST_SWAPPED = 4
"""Words of a phrase that changes places with another one; sentences may stand in any order."""
_LONGEST_MIDDLE = 40

_POINTERS = pattern(r"\b(?:see|described|description|refer|documented|documentation)\b", re.IGNORECASE)
_ALTERNATIVE = pattern(
    r"^\W*(?:or\b(?! \w+ \(\d)(?=.*\b(?:if|when|while|where|unless)\b)|unless\b|except\b|but not\b"
    r"|(?:not )?(?:including|excluding|counting)\b)",
    re.IGNORECASE | re.DOTALL,
)
_ORIGIN = pattern(r"\W*(?:from|above|below|relative to|since|until|between|towards?|after|before)\b", re.IGNORECASE)
_ORDERED = pattern(r"\b(?:order|elements)\b", re.IGNORECASE)
_RESTRICTION = pattern(
    r"\b(?:ignored|not used|unused|not supported) (?:by|for|on|in)\b|\baffects \w+ only\b", re.IGNORECASE
)
_ALTERNATING = frozenset({"or", "unless", "except", "but", "including", "excluding", "counting"})
_RESTRICTING = frozenset({"ignored", "used", "unused", "supported", "affects"})
_WORD = pattern(r"-?\d+(?:\.\d+)?|[^\W\d]\w*")
_JOINING = frozenset({"and", "or", "the", "a", "an"})
_DECIDING = frozenset({"positive", "negative", "true", "false", "nan", "set", "cleared"})


def other_piece(old: str, new: str, *, is_whole: bool = True) -> Judgement:
    """Return what comes of the pieces in which two texts differ.

    ``is_whole`` is whether the text is about one thing: of a message, whose text is about all of its fields, only what
    is exchanged and nothing else tells.
    """
    before, after, around = _middles(old, new)
    swapped = _swapped(before, after, is_ordered=_ORDERED.search(new) is not None)
    if swapped.gravity:
        return swapped
    shared = around + len(set(before) & set(after))
    may_exchange = before and after and shared >= _LEAST_SHARE * (around + max(len(before), len(after)))
    may_condition = is_whole and not (_ALTERNATING.isdisjoint(after) and _RESTRICTING.isdisjoint(before))
    if not may_exchange and not may_condition:
        return HARMLESS
    found = aligned(old, new)
    if (
        old.lower().split()[:_LEAST_FRAME] == new.lower().split()[:_LEAST_FRAME]
        and is_whole
        and found.kept == _SMALL_FRAME
    ):
        found = found._replace(kept=_LEAST_FRAME)  # the words that carry nothing hold the rest together, too
    exchanged = _exchanged(found, is_whole=is_whole)
    if exchanged is not None:
        was, now = exchanged
        return Judgement(doubt=f"whether {now!r} in place of {was!r} is another meaning")
    return _other_condition(found.pieces, new) if is_whole else HARMLESS


def _is_respelt(piece: Piece) -> bool:
    """Return whether the words of a piece are the same in another spelling, or ones that carry nothing, misspelt."""
    gone, come = ([word for word in side if not _is_idle_slip(word)] for side in (piece.gone, piece.come))
    return len(gone) == len(come) and all(is_respelt(one, other) for one, other in zip(gone, come, strict=True))


def _is_idle_slip(word: str) -> bool:
    return len(word) >= _LEAST_LETTERS and any(is_slip(word, each) for each in IDLE if len(each) >= _LEAST_LETTERS)


def _exchanged(found: Alignment, *, is_whole: bool) -> tuple[str, str] | None:
    """The one phrase, wherever it stands, in place of which another one stands, each as written."""
    if len(found.pieces) > _MOST_PIECES or not any(piece.is_exchange for piece in found.pieces):
        return None
    pieces = [piece for piece in found.pieces if not _is_respelt(piece)]
    exchanges = [piece for piece in pieces if piece.is_exchange]
    if len({(piece.gone, piece.come) for piece in exchanges}) != 1:
        return None
    others = len(pieces) - len(exchanges)
    one = exchanges[0]
    least = _LEAST_SHARE if not others else _NEARLY_ALL
    is_origin = _ORIGIN.match(one.was) is not None and _ORIGIN.match(one.now) is not None
    is_framed = found.kept >= (_SMALL_FRAME if is_origin else _LEAST_FRAME)
    if others > (1 if is_whole else 0) or found.share < least or not is_framed:
        return None
    if max(len(one.gone), len(one.come)) > _LONGEST_PHRASE:
        return None
    if any(is_respelt(word, other) for word in one.gone for other in one.come):
        return None  # which says some of the same, in a sentence built otherwise
    if says_unit(one.was) and says_unit(one.now):
        return None  # which has a rule of its own
    if is_whole and (_is_only_numbers(one.gone) or _is_only_numbers(one.come)):
        return None
    if _POINTERS.search(one.was) or _POINTERS.search(one.now) or any("_" in word for word in one.gone + one.come):
        return None
    return one.was.strip(" ,;.:()"), one.now.strip(" ,;.:()")


def _is_only_numbers(words: Sequence[str]) -> bool:
    return all(word.lstrip("-").replace(".", "").isdigit() or word == "nan" for word in words)


def _other_condition(pieces: Sequence[Piece], new: str) -> Judgement:
    """Return what comes of an alternative that is new within a sentence, or of a restriction that is gone from all of
    a text.
    """
    for piece in pieces:
        if not piece.gone and _ALTERNATIVE.search(piece.now):
            return Judgement(doubt=f"whether it was so before: {piece.now.strip(' ,;.()')!r}")
        restriction = None if piece.come else _RESTRICTION.search(piece.was)
        if restriction is not None and _restricted(piece.was, restriction) not in new.lower():
            return Judgement(doubt=f"whether it still is so: {piece.was.strip(' ,;.()')!r}")
    return HARMLESS


def _restricted(text: str, found: re.Match[str]) -> str:
    """Return a restriction with the word behind it, in small letters: ``ignored by planes``."""
    after = _WORD.search(text, found.end())
    return text[found.start() : after.end() if after else found.end()].lower()


def _middles(old: str, new: str) -> tuple[list[str], list[str], int]:
    """Return the words of two texts without those with which both begin and end, and how many these are."""
    before, after = (_WORD.findall(text.lower()) for text in (old, new))
    least, first, last = min(len(before), len(after)), 0, 0
    while first < least and before[first] == after[first]:
        first += 1
    while last < least - first and before[-1 - last] == after[-1 - last]:
        last += 1
    return before[first : len(before) - last], after[first : len(after) - last], first + last


def _swapped(middle: Sequence[str], now: Sequence[str], *, is_ordered: bool) -> Judgement:
    """Return what comes of two phrases that changed places, all else being the same; lists may be in an order."""
    if len(middle) != len(now) or len(middle) > _LONGEST_MIDDLE:
        return HARMLESS
    for first in range(1, _LONGEST_SWAPPED + 1):
        for last in range(1, min(_LONGEST_SWAPPED, len(middle) - first) + 1):
            one, between, other = middle[:first], middle[first : len(middle) - last], middle[len(middle) - last :]
            if [*other, *between, *one] == now and (is_ordered or not _JOINING.issuperset(between)):
                return _of_swapped(" ".join(one), " ".join(other), between)
    return HARMLESS


def _of_swapped(one: str, other: str, between: Sequence[str]) -> Judgement:
    if any(word in _DECIDING or word.lstrip("-").isdigit() for word in between):
        return Judgement(breaks=True, effect=f"{one!r} and {other!r} have changed places in the text")
    return Judgement(doubt=f"whether {one!r} and {other!r} have changed places with another meaning")
