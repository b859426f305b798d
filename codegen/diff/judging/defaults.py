"""Judges the mark ``(default)`` that moves to another entry of an enum, or to another number of a text."""

from collections.abc import Sequence
from typing import NamedTuple

from codegen.diff.judging.judging import HARMLESS, Judgement
from codegen.model.dialect.dialect import EnumEntry
from codegen.pattern import pattern

_MARK = pattern(
    r"[(\[](?:the )?default[)\]]|(?:^|[.;,:(\[]\s*|\b(?:this|it) is )(?:the )?(?:default|used by default)"
    r"(?: (?:behaviou?r|mode|option|choice|setting|value))?\s*(?:[.;:,)\]]|$)"
)
"""The mark of a default, in small letters; ``reset to the default`` and ``the default rate`` are no mark."""
_MARKED = pattern(
    r"(?<![\w.])(-?\d+|nan)\s*(?:[:=]|\bis\b|\bfor\b)?[^.;,()\[\]\d]*(?:[(\[](?:the )?default[)\]]|, the default\b)"
)
"""A number of which a text says that it is the default: ``0: airspeed (default)``."""


class MovedDefault(NamedTuple):
    """The entry that is the default now, by its name, and what comes of that."""

    entry: str
    judgement: Judgement


def is_default(text: str) -> bool:
    """Return whether a text says that what it is about is the default."""
    return "default" in (small := text.lower()) and _MARK.search(small) is not None


def moved_default(old: Sequence[EnumEntry], new: Sequence[EnumEntry]) -> MovedDefault | None:
    """Return what comes of the mark of the default at another entry; both have to be in both versions."""
    before, after = ({entry.name: is_default(entry.description) for entry in side} for side in (old, new))
    kept = before.keys() & after.keys()
    gone = [name for name, was in before.items() if name in kept and was and not after[name]]
    come = [name for name, now in after.items() if name in kept and now and not before[name]]
    if not gone or not come:
        return None
    return MovedDefault(come[0], _moved(gone[0], come[0]))


def other_default_in_text(old: str, new: str) -> Judgement:
    """Return what comes of the mark of the default at another number of a text, which both texts tell of."""
    before, after = (dict.fromkeys(_MARKED.findall(text.lower())) for text in (old, new))
    if len(before) != 1 or len(after) != 1 or before == after:
        return HARMLESS
    return _moved(*(next(iter(side)) for side in (before, after)))


def _moved(was: str, now: str) -> Judgement:
    return Judgement(breaks=True, effect=f"who leaves it open got {was} and gets {now}")
