"""Judges another text about the same number: nothing, another meaning, or a question for a person."""

from codegen.diff.judging.alignment import aligned
from codegen.diff.judging.complements import other_complement
from codegen.diff.judging.conflicts import other_signs, other_statements, without_alike
from codegen.diff.judging.defaults import other_default_in_text
from codegen.diff.judging.exchanges import other_piece
from codegen.diff.judging.judging import HARMLESS, Judgement, gravest
from codegen.diff.judging.mentions import OTHERWISE, negations, numbers, quantities_of
from codegen.diff.judging.phrases import in_one_wording, with_named_axes, without_examples
from codegen.diff.judging.references import STATED_LATE, denied_references, references
from codegen.diff.judging.turned import is_turned_twice
from codegen.diff.judging.units_in_words import without_same_unit
from codegen.diff.judging.wording import (
    Likeness,
    common_share,
    is_unsaid,
    other_word,
    text_likeness,
    without_addresses,
    words_of,
)
from codegen.pattern import pattern

_SEVERAL = pattern(r"[.;:] ")
"""Between sentences, of which one may be about one field and the next about another."""
_LEAST_WORDS = 4
_LEAST_HALF = 0.45
"""Of the words of an entry's shorter text: with fewer in both, they may tell of something else."""
_SENTENCE = 3
"""Words of a sentence that was added, which may deny something of its own."""
_LEAST_SHARE = 0.4
"""Of the words of the longer text: with fewer in both, a denial in one of them is of something else."""


def other_text(old: str, new: str) -> Judgement:
    """Return what comes of another text for what keeps its name and its place."""
    return _of_words(*_in_one_wording(old, new))


def same_entry(old: str, new: str) -> Judgement:
    """Return what comes of another text for an entry that keeps its name and its number."""
    old, new = _in_one_wording(old, new)
    found = _of_words(old, new)
    lengths = [len(words_of(text)) for text in (old, new)]
    if not found.gravity and common_share(old, new, of=min) < _LEAST_HALF and min(lengths) >= _LEAST_WORDS:
        return Judgement(doubt="the text tells of something else under the same name")
    return found


def other_message(old: str, new: str) -> Judgement:
    """Return what comes of another text for a message, which is about all of its fields and much else."""
    old, new = _in_one_wording(old, new)
    found = other_reference(old, new)
    if found.breaks:
        return found
    if is_unsaid(old) or is_unsaid(new):
        return HARMLESS
    found = _other_word(old, new) or other_piece(old, new, is_whole=False)
    return found if found.gravity or _SEVERAL.search(old) or _SEVERAL.search(new) else other_complement(old, new)


def _in_one_wording(old: str, new: str) -> tuple[str, str]:
    """Return both texts without addresses, examples and the unit that both state, in one wording."""
    old, new = (in_one_wording(without_examples(without_addresses(text))) for text in (old, new))
    return with_named_axes(*without_same_unit(old, new))


def _of_words(old: str, new: str) -> Judgement:
    if is_turned_twice(old, new):
        return HARMLESS
    values = gravest(other_statements(old, new), other_default_in_text(old, new))
    if values.gravity:
        return values
    likeness = text_likeness(old, new)
    if likeness is Likeness.OPPOSITE:
        return Judgement(breaks=True, effect="the text says the opposite")
    found = other_reference(old, new)
    if found.gravity:
        return found
    if likeness is Likeness.DISPUTED:
        return Judgement(doubt="whether the text says the opposite of what it said")
    if likeness is Likeness.UNSAID:
        return HARMLESS
    old, new = without_alike(old, new)
    found = _other_numbers(old, new) or _other_sense(old, new) or _other_word(old, new) or other_piece(old, new)
    return found if found.gravity else gravest(_other_quantity(old, new), other_complement(old, new))


def _other_quantity(old: str, new: str) -> Judgement:
    """Return what comes of a text about all of something that is about one of it now, or the reverse."""
    before, after = quantities_of(old), quantities_of(new)
    for noun in before.keys() & after.keys():
        gone, come = before[noun] - after[noun], after[noun] - before[noun]
        if gone and come:
            return Judgement(doubt=f"whether it is of {_listed(come)} and was of {_listed(gone)}: {noun}")
    return HARMLESS


def other_reference(old: str, new: str) -> Judgement:
    """Return what comes of another axis, height or clock from which a text says that something is measured."""
    before, after = references(old), references(new)
    if before == after == {}:
        return HARMLESS
    denied = denied_references(old), denied_references(new)
    nothing: frozenset[str] = frozenset()
    for kind in sorted(before.keys() | after.keys()):
        was, now = before.get(kind, nothing), after.get(kind, nothing)
        gone, come = was - now, now - was
        if gone and come:
            effect = f"the text tells of {_listed(come)} where it told of {_listed(gone)}"
            return Judgement(breaks=True, effect=effect)
        turned = (was & denied[1].get(kind, nothing)) | (now & denied[0].get(kind, nothing))
        if turned:
            return Judgement(breaks=True, effect=f"one of the texts says that {_listed(turned)} is not meant")
        if (gone or come) and kind in STATED_LATE and not is_unsaid(old):
            return Judgement(doubt=f"whether {_listed(gone | come)} was meant all the time")
    return HARMLESS


def _listed(names: frozenset[str]) -> str:
    return " and ".join(sorted(names))


def _other_numbers(old: str, new: str) -> Judgement | None:
    before, after = numbers(old), numbers(new)
    gone, come = before - after, after - before
    if not gone or not come:
        return None
    words = [{word for word in words_of(text) if not word.isdigit()} for text in (old, new)]
    change = f"{', '.join(sorted(gone))} in the text is {', '.join(sorted(come))} now"
    if words[0] == words[1]:
        return Judgement(breaks=True, effect=change)
    return Judgement(doubt=f"whether it is another meaning that {change}")


def _other_sense(old: str, new: str) -> Judgement | None:
    """Return what comes of a text that denies what it said, or says another thing of a sign."""
    added = words_of(new) - words_of(old)
    is_longer = words_of(old) <= words_of(new) and len(added) >= _SENTENCE
    is_rest = (OTHERWISE.search(old) is None) != (OTHERWISE.search(new) is None)
    if (
        negations(old) % 2 != negations(new) % 2
        and not is_rest
        and aligned(old, new).share >= _LEAST_SHARE
        and not is_longer
    ):
        return Judgement(doubt="whether the text denies what it said")
    signs = other_signs(old, new)
    return signs if signs.gravity else None


def _other_word(old: str, new: str) -> Judgement | None:
    word = other_word(old, new)
    return Judgement(doubt=f"whether {word[1]!r} in place of {word[0]!r} is another meaning") if word else None
