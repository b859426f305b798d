"""Judges a parameter that was empty or reserved and gets a meaning: what old senders leave there has one, too."""

import re

from codegen.diff.judging.judging import Judgement
from codegen.diff.judging.phrases import in_one_wording, says_unknown
from codegen.diff.judging.readings import senses_of, stated_values
from codegen.model.dialect.dialect import CommandParameter, EnumDefinition
from codegen.pattern import pattern

_NOTHING = pattern(
    r"\b(?:no|not|none|never|nothing|all|every|each|any|both|off|disabled?|false|current|present|unused|normal(?:ly)?|"
    r"standard|as before|without|reserved|undefined|unspecified|auto\w*|ignore)\b",
    re.IGNORECASE,
)
_NAMED = pattern(r"(?<![\w.-])0(?![\w.]*\w)|\bzero\b", re.IGNORECASE)
_SELECTING = pattern(r"\b(?:id|instance|index)\b", re.IGNORECASE)
_UNUSED = Judgement(effect="it was not used before")


def first_meaning(old: CommandParameter | None, new: CommandParameter, enum: EnumDefinition | None) -> Judgement:
    """Return what comes of the first meaning of a parameter; ``enum`` are the entries that it has now.

    Old senders leave 0 there, or the default that was stated.
    """
    is_nan = old is not None and dict(old.attributes).get("default", "").strip().lower() == "nan"
    attributes, text = dict(new.attributes), new.description
    left: int | str = "NaN" if is_nan else 0
    stated = {str(number).lower(): words for number, words in stated_values(in_one_wording(text)).items()}
    said = stated.get(str(left).lower())
    if said is None and not is_nan and enum is not None:
        said = next((f"{one.name.replace('_', ' ')} {one.description}" for one in enum.entries if one.value == 0), None)
        if said is None or _changes_nothing(said) or (old is not None and _NAMED.search(old.description)):
            return _UNUSED  # who demanded a 0 there knew what to give that number to
        return Judgement(doubt=f"whether {said.strip()!r} is what happened where nobody set it")
    if said is not None:
        if _changes_nothing(said):
            return _UNUSED
        return Judgement(breaks=True, effect=f"old senders leave {left} there, which asks for {said!r} now")
    is_open = not is_nan and not _NAMED.search(text)
    if is_open and (attributes.get("units") or _SELECTING.search(attributes.get("label", ""))):
        return Judgement(doubt="what 0 is, which old senders leave there")
    return _UNUSED


def _changes_nothing(said: str) -> bool:
    """Return whether a number with such a meaning leaves things as they are where nobody sets it."""
    return bool(senses_of(said) - {"the best", "the worst"}) or says_unknown(said) or _NOTHING.search(said) is not None
