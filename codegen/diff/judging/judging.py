"""Judges a number under another name: a respelling, another thing, or a question for a person."""

from typing import NamedTuple

from codegen.diff.judging.readings import stated_values
from codegen.diff.judging.wording import (
    Likeness,
    is_replaced,
    is_unsaid,
    name_likeness,
    names_of,
    says_private,
    says_reserved,
    text_likeness,
)
from codegen.model.dialect.dialect import EnumDefinition, EnumEntry

_ALIKE = (Likeness.SAME, Likeness.NEAR)
_UNCLEAR = (Likeness.VAGUE, Likeness.UNSAID)


class Judgement(NamedTuple):
    """The judgement of a change: whether it ``breaks`` somebody, the ``doubt`` for a person to settle, its effect."""

    breaks: bool = False
    doubt: str = ""
    effect: str = ""

    @property
    def gravity(self) -> int:
        """The larger, the graver."""
        return 2 if self.breaks else 1 if self.doubt else 0


HARMLESS = Judgement()


def gravest(*judgements: Judgement) -> Judgement:
    """The gravest of several, the first of those that are alike."""
    return max(judgements, key=lambda each: each.gravity)


def other_entry(old: EnumEntry, new: EnumEntry, enum: EnumDefinition) -> Judgement:
    """Return what comes of a number of ``enum``, as it was, that another entry has now."""
    if says_reserved(old.name) or (is_unsaid(old.description) and old.description):
        return Judgement(effect="it was reserved")
    names = name_likeness(old.name, new.name, enum.name)
    texts = text_likeness(old.description, new.description)
    if says_reserved(new.name):
        if names_of(new.description, (old.name,)) or texts in _ALIKE:
            return Judgement(effect="the text still says what it was")
        return Judgement(breaks=True, effect=f"nothing says any more that it was {old.name}")
    is_private = says_private(old.name, old.description) and not says_private(new.name, new.description)
    if is_private and names is not Likeness.SAME:
        return Judgement(doubt=f"{old.name} was for anybody's own use, which {new.name} may meet")
    if texts is Likeness.SAME and _is_common(old, enum):
        texts = Likeness.UNSAID
        if names is Likeness.NEAR:
            return Judgement(effect="a respelling, the text being the same")
    if texts is Likeness.NEAR and is_replaced((old.name, new.name), (old.description, new.description)):
        texts = Likeness.OPPOSITE
    return by_words(names, texts, old.name, new.name)


def _is_common(entry: EnumEntry, enum: EnumDefinition) -> bool:
    """Return whether other entries have the same text, which then does not tell them apart."""
    return any(other.description == entry.description and other.name != entry.name for other in enum.entries)


def by_words(names: Likeness, texts: Likeness, old: str, new: str) -> Judgement:
    """Return what comes of another name, by the likeness of both names and of both texts."""
    another = Judgement(breaks=True, effect=f"what was {old} is read as {new}, and the reverse")
    if texts is Likeness.OPPOSITE or (names is Likeness.OPPOSITE and texts is not Likeness.SAME):
        return another
    if names is Likeness.SAME:
        if texts in (Likeness.OTHER, Likeness.DISPUTED):
            return Judgement(doubt=f"the name is a respelling of {old}, but the text tells of something else")
        return Judgement(effect="a respelling")
    if texts is Likeness.SAME:
        return Judgement(effect="another name of the same, as the text shows")
    if names is Likeness.NEAR:
        if texts is Likeness.NEAR and len(old) <= len(new):
            return Judgement(effect="a fuller name of the same, as the text shows")
        if texts in (Likeness.OTHER, Likeness.DISPUTED):
            return another
        return Judgement(doubt=f"whether {new} still is what {old} was")
    if texts is Likeness.NEAR or (names is Likeness.VAGUE and texts in _UNCLEAR):
        return Judgement(doubt=f"whether {new} is another name of {old} or another thing")
    return another


def gone_entry(entry: EnumEntry, *, is_bitmask: bool) -> Judgement:
    """Return what comes of an entry that is gone with its number, of an enum of bits or of numbers."""
    if says_reserved(entry.name):
        return Judgement(effect="it was reserved")
    if is_bitmask and entry.value == 0:
        if not {"none", "default", "no"}.isdisjoint(entry.name.lower().split("_")):
            return Judgement(effect="0 is the set without any bit")
        return Judgement(doubt=f"whether 0 still says {entry.name}, which a set without any bit does not")
    return Judgement(breaks=True)


def other_enum(old: EnumDefinition | None, new: EnumDefinition | None, text: str) -> Judgement:
    """Return what comes of other names for the numbers of a field or a parameter, whose description is ``text`` now."""
    if old is None:
        return Judgement(effect="stated for the first time")
    if new is None:
        said = stated_values(text)
        entries = {entry.value: entry.name for entry in old.entries}
        agreeing = [
            number
            for number, words in said.items()
            if isinstance(number, int) and _is_entry(entries.get(number, ""), words, old.name)
        ]
        if names_of(text, (old.name,)) or (agreeing and len(agreeing) == len(old.entries)):
            return Judgement(effect="the description still says so")
        return Judgement(breaks=True, effect="nothing says what its numbers mean any more")
    after = {entry.value: entry for entry in new.entries}
    around = f"{old.name}_{new.name}"
    likenesses = {
        entry.name: name_likeness(entry.name, after[entry.value].name, around)
        for entry in old.entries
        if entry.value in after
    }
    missing = [entry.name for entry in old.entries if entry.value not in after]
    other = [name for name, likeness in likenesses.items() if likeness in (Likeness.OTHER, Likeness.OPPOSITE)]
    if other:
        number = next(entry.value for entry in old.entries if entry.name == other[0])
        return Judgement(breaks=True, effect=f"{number} was {other[0]} and is {after[number].name}")
    if not missing and all(likeness is Likeness.SAME for likeness in likenesses.values()):
        if len(after) == len(old.entries):
            return Judgement(effect="another name of the same enum")
        return Judgement(effect=f"{new.name} has all values of {old.name}")
    if not likenesses:
        return Judgement(breaks=True, effect=f"none of its numbers is one of {new.name}")
    named = (missing or [name for name, likeness in likenesses.items() if likeness is not Likeness.SAME])[0]
    return Judgement(doubt=f"whether {new.name} has what {named} was")


def enum_for_words(text: str, new: EnumDefinition | None) -> Judgement:
    """Return what comes of an enum that is stated for numbers of which ``text`` told: whether both agree."""
    if new is None:
        return HARMLESS
    entries = {entry.value: entry.name for entry in new.entries}
    for number, words in stated_values(text).items():
        if isinstance(number, int) and number in entries and not _is_entry(entries[number], words, new.name):
            other = next((value for value, name in entries.items() if _is_entry(name, words, new.name)), None)
            if other is not None:
                effect = f"{number} was {words!r} in the description, which is {other} in {new.name}"
                return Judgement(breaks=True, effect=effect)
    return HARMLESS


def _is_entry(name: str, words: str, enum: str) -> bool:
    return name_likeness(words.strip().replace(" ", "_"), name, enum) in _ALIKE
