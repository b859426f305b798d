"""Judges what two texts say of the same number, the same sign, or the same bit."""

from collections.abc import Mapping

from codegen.diff.judging.judging import HARMLESS, Judgement, gravest
from codegen.diff.judging.mentions import negations
from codegen.diff.judging.phrases import in_one_wording, says_unknown
from codegen.diff.judging.readings import (
    directions,
    is_one_sense,
    senses_of,
    stated_signs,
    stated_states,
    stated_values,
)
from codegen.diff.judging.wording import Likeness, common_share, text_likeness
from codegen.pattern import pattern

_ALIKE = (Likeness.SAME, Likeness.NEAR)
_SOME, _MOST, _NEARLY_ALL = 0.35, 0.6, 0.8
"""Shares of the words that two texts about one number have in common."""
_DECIDED = frozenset({"kept", "by default"})
"""Senses that a text about a number does not lose by being said anew."""

_LIMITS = frozenset(2**bits - 1 for bits in (7, 8, 15, 16, 31, 32, 63, 64))
_ABSENT = pattern(r"\b(?:not|isn't) (?:fitted|connected|installed|present)\b|\bmissing\b|\bthere (?:is|are) no\b")
_NAME = pattern(r"\w+")
_HEAD = pattern(r"[(.,;:]")
_BARE = frozenset({"true", "false", "yes", "no"})


def other_statements(old: str, new: str) -> Judgement:
    """Return what comes of numbers and bits of which two texts say something else."""
    states = stated_states(old), stated_states(new)
    values = stated_values(old), stated_values(new)
    bits = [{**state, **value} for state, value in zip(states, values, strict=True)] if any(states) else ()
    return gravest(stated_conflict(*values), moved_value(*bits) if bits else HARMLESS, _turned_state(*states))


def _turned_state(old: Mapping[int | str, str], new: Mapping[int | str, str]) -> Judgement:
    """Return what comes of a bit that is cleared for what it was set for, each text telling of one state alone."""
    if len(old) != 1 or len(new) != 1 or old.keys() == new.keys():
        return HARMLESS
    was, now = next(iter(old.values())), next(iter(new.values()))
    if not was or negations(was) % 2 != negations(now) % 2 or not is_alike(was, now):
        return HARMLESS
    return Judgement(breaks=True, effect=f"the bit is {next(iter(new))} where it was {next(iter(old))}: {now!r}")


def stated_conflict(old: Mapping[int | str, str], new: Mapping[int | str, str]) -> Judgement:
    """Return what comes of numbers of which two texts say something else."""
    for number, words in old.items():
        if (
            number not in new
            or _is_bare(words) != _is_bare(new[number])
            or text_likeness(words, new[number]) is Likeness.SAME
        ):
            continue
        moved = next((other for other, said in new.items() if text_likeness(words, said) is Likeness.SAME), None)
        if moved is not None and moved in old and text_likeness(old[moved], new[moved]) is not Likeness.SAME:
            return _moved(number, words, new[number], moved)
        if _says_nothing(number, words) and _says_nothing(number, new[number]):
            continue
        is_same = _is_same(words, new[number])
        if is_same and is_alike(words, new[number]):
            continue
        moved = next((other for other, said in new.items() if other != number and is_alike(words, said)), None)
        if moved is not None:
            return _moved(number, words, new[number], moved)
        if text_likeness(words, new[number]) is Likeness.OPPOSITE or _is_decided_otherwise(words, new[number]):
            return Judgement(breaks=True, effect=f"{number} was {words!r} and is {new[number]!r}")
        if not is_same:
            return Judgement(doubt=f"whether {number}, which was {words!r}, is {new[number]!r}")
    return HARMLESS


def _says_nothing(number: int | str, words: str) -> bool:
    """Return whether a number that is no amount stands for something that is unknown or that there is none of."""
    return (number == "NaN" or number in _LIMITS) and (
        says_unknown(words) or "none" in senses_of(words) or _ABSENT.search(words) is not None
    )


def _is_bare(words: str) -> bool:
    """Return whether the words for a number only say that it is one of two."""
    return words.lower() in _BARE


def moved_value(old: Mapping[int | str, str], new: Mapping[int | str, str]) -> Judgement:
    """Return what comes of numbers of which one text says what the other one says of another number."""
    for number, words in old.items():
        others = [other for other, said in new.items() if other != number and is_alike(words, said)]
        if number in new and others and not is_alike(words, new[number]):
            return _moved(number, words, new[number], others[0])
    return HARMLESS


def other_truth(old: str, new: str) -> Judgement:
    """Return what comes of a text that begins with what a truth value says, where the old one told of 0 and 1."""
    before = stated_values(in_one_wording(old))
    if 1 in stated_values(in_one_wording(new)):
        return HARMLESS
    head = _HEAD.split(new, maxsplit=1)[0]
    if 0 in before and 1 in before and is_alike(before[0], head) and not is_alike(before[1], head):
        return Judgement(breaks=True, effect=f"1 was {before[1]!r} and is {head.strip()!r}, which 0 was")
    return HARMLESS


def _moved(number: int | str, words: str, now: str, moved: int | str) -> Judgement:
    return Judgement(breaks=True, effect=f"{number} was {words!r} and is {now!r}; {moved} is that now")


def without_alike(old: str, new: str) -> tuple[str, str]:
    """Return two texts without the phrases in which both say the same of a number in words of their own."""
    before, after = stated_values(old), stated_values(new)
    for number, words in before.items():
        said = after.get(number, words)
        is_nothing = _says_nothing(number, words) and _says_nothing(number, said)
        if said != words and (is_nothing or _is_one_sense(words, said)):
            old, new = old.replace(words, " "), new.replace(said, " ")
    return old, new


def is_alike(words: str, other: str) -> bool:
    """Return whether two texts about a number say the same, or one of them more of it."""
    return _is_one_sense(words, other) or text_likeness(words, other) in _ALIKE


def _is_one_sense(words: str, other: str) -> bool:
    """Return whether two texts about a number say the same whatever their words: nothing is known, all is kept, or
    another field decides, which both name.
    """
    if says_unknown(words) and says_unknown(other):
        return True
    if not _identifiers(words).isdisjoint(_identifiers(other)) and text_likeness(words, other) is not Likeness.OPPOSITE:
        return negations(words) == negations(other)
    return is_one_sense(words, other)


def _identifiers(words: str) -> set[str]:
    """Return the names of fields, entries and messages in a text."""
    return {word for word in _NAME.findall(words) if "_" in word.strip("_")}


def _is_same(words: str, other: str) -> bool:
    """Return whether two texts about a number have most words of the shorter one, and some of the longer one."""
    if _is_one_sense(words, other):
        return True
    shorter, longer = common_share(words, other, of=min), common_share(words, other)
    return shorter >= _NEARLY_ALL or (shorter >= _MOST and longer >= _SOME)


def _is_decided_otherwise(words: str, other: str) -> bool:
    """Return whether a number kept something, or stood for the default, and is for something else now."""
    before, after = senses_of(words), senses_of(other)
    return not _DECIDED.isdisjoint(before) and before.isdisjoint(after) and not says_unknown(other)


def other_signs(old: str, new: str) -> Judgement:
    """Return what comes of signs of which two texts say something else."""
    before, after = stated_signs(old), stated_signs(new)
    for sign in before.keys() & after.keys():
        other = "negative" if sign == "positive" else "positive"
        kept, turned = (_shared(before[sign], after.get(each, frozenset())) for each in (sign, other))
        if turned > kept:
            return Judgement(breaks=True, effect=f"{sign} numbers are what {other} ones were")
        is_comparable = bool(directions(before[sign])) == bool(directions(after[sign]))
        if before[sign] and after[sign] and not kept and is_comparable:
            return Judgement(doubt=f"whether {sign} numbers still are what they were")
    return HARMLESS


def _shared(one: frozenset[str], other: frozenset[str]) -> float:
    return len(one & other) / max(len(one | other), 1)
