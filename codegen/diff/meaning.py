"""What the bytes of a field mean, in two versions: units, sentinels, enums, ranges. Nothing of it is in CRC_EXTRA."""

import math
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.diff import wire_rules as rules
from codegen.diff.change import BOTH, Change, ChangeRule, Victim, changed
from codegen.diff.pairing import Pair
from codegen.model.dialect import FieldDefinition, Sentinel, WireField
from codegen.model.literals import exact_number
from codegen.model.unit import Unit, conversion, decimal, map_words, ratio
from codegen.source import Place

_WORD = re.compile(r"-?[\w.]*\w")
_NUMBER = re.compile(r"-?[\d.]+")
_SENTENCE = re.compile(r"(?<=[.;])\s")
_WHEN = re.compile(r"\b(?:if|when|not|unknown|invalid|unset|unused|ignored?|use|set|sent?d?)\b", re.IGNORECASE)

_SAME_NUMBER = "the same value is the same number as before"

_TEXTS: tuple[tuple[str, ChangeRule], ...] = (
    ("enum", rules.FIELD_ENUM),
    ("increment", rules.FIELD_INCREMENT),
    ("default", rules.FIELD_DEFAULT),
    ("print_format", rules.PRINT_FORMAT),
    ("description", rules.DESCRIPTION),
)


def meaning_changes(pair: Pair, message: str, enums: Mapping[str, str]) -> Iterator[Change]:
    """What changed in the meaning of a field of ``message``, the gravest first; ``enums`` are called otherwise now."""
    old, new = pair.old.definition, pair.new.definition

    def told(
        rule: ChangeRule,
        before: str | None,
        after: str | None,
        effect: str = "",
        breaks: tuple[Victim, ...] | None = None,
        places: tuple[Place, Place] = (old.place, new.place),
    ) -> Change:
        subject = f"{message}.{new.name}"
        return changed(rule, subject, before, after, places, effect, breaks=breaks, messages=(message,))

    is_same_number = _scale(old, new) == 1
    if (old.units or None) != (new.units or None):
        effect = _SAME_NUMBER if is_same_number else _unit_effect(old.units, new.units)
        is_harmless = is_same_number or not old.units
        yield told(rules.FIELD_UNITS, old.units or None, new.units or None, effect, () if is_harmless else None)
    if not _is_same_sentinel(pair.old.sentinel, pair.new.sentinel):
        effect, breaks = _sentinel_effect(pair)
        places = _stated_at(pair.old), _stated_at(pair.new)  # a correction may have stated it
        yield told(rules.FIELD_SENTINEL, _sentinel(pair.old), _sentinel(pair.new), effect, breaks, places)
    if _number(old.multiplier) != _number(new.multiplier):
        effect = _SAME_NUMBER if is_same_number else _factor_effect(old, new)
        yield told(rules.FIELD_MULTIPLIER, old.multiplier, new.multiplier, effect, () if is_same_number else None)
    if old.is_bitmask != new.is_bitmask:
        words = ["bits" if side.is_bitmask else "a number" for side in (old, new)]
        yield told(rules.FIELD_BITMASK, words[0], words[1])
    if old.is_instance != new.is_instance:
        words = ["the instance" if side.is_instance else "a value" for side in (old, new)]
        yield told(rules.FIELD_INSTANCE, words[0], words[1], "what the messages are about is told apart otherwise")
    if (_number(old.minimum), _number(old.maximum)) != (_number(new.minimum), _number(new.maximum)):
        yield told(rules.FIELD_RANGE, _range(old), _range(new))
    for attribute, rule in _TEXTS:
        before, after = getattr(old, attribute) or None, getattr(new, attribute) or None
        if before != after:
            effect = _enum_effect(before, after, enums) if rule is rules.FIELD_ENUM else ""
            yield told(rule, before, after, effect, () if effect else None)


def _enum_effect(old: str | None, new: str | None, enums: Mapping[str, str]) -> str:
    """Why another enum breaks nobody; empty where it does."""
    if old is None:
        return "stated for the first time"
    return "another name of the same enum" if enums.get(old) == new else ""


def _scale(old: FieldDefinition, new: FieldDefinition) -> Fraction | None:
    """By which factor the number for one value grew, unit and multiplier together; None where that is not known."""
    factor = Fraction(1) if (old.units or "") == (new.units or "") else _factor(old.units or "", new.units or "")
    before, after = _number(old.multiplier or "1"), _number(new.multiplier or "1")
    if factor is None or not isinstance(before, Fraction) or not isinstance(after, Fraction) or not after:
        return None
    return factor * before / after


def _factor(old: str, new: str) -> Fraction | None:
    before, after = Unit.parse(old), Unit.parse(new)
    return ratio(before, after) if before and after else None


def _unit_effect(old: str | None, new: str | None) -> str:
    """By which factor receivers of the other version are wrong, where it is known."""
    if not old:
        return "stated for the first time"
    if not new:
        return "nothing says what the number counts any more"
    factor = _factor(old, new)
    if factor is None:
        before, after = Unit.parse(old), Unit.parse(new)
        way = conversion(before, after) if before and after else None
        return f"the number is read in another unit{f': {old} {map_words(way)} = {new}' if way else ''}"
    word = f"{decimal(factor)} times as large" if factor > 1 else f"{decimal(1 / factor)} times as small"
    return f"the same value is a number {word}"


def _sentinel_effect(pair: Pair) -> tuple[str, tuple[Victim, ...]]:
    """What comes of another sentinel, and who breaks: nobody where the text says the same in the other version."""
    old, new = _sentinel(pair.old), _sentinel(pair.new)
    if new is None and old is not None:
        if _is_described(old, pair.new.definition.description):
            return "the description still says so", ()
        return f"new receivers take an old sender's {old} for a measurement, old ones a real {old} for unknown", BOTH
    if old is None and new is not None:
        if _is_described(new, pair.old.definition.description):
            return "the description said so before", ()
        return f"old receivers take {new} for a measurement", (Victim.OLD_STATION,)
    return f"old receivers take {new} for a measurement, new ones take {old} for one", BOTH


def _is_described(sentinel: str, description: str) -> bool:
    """Whether a text names the sentinel: a bare number only where it says when that is sent, so not ``0 to 100``."""
    word = sentinel.strip("[]:")
    sentences = _SENTENCE.split(description)
    return any(
        word in _WORD.findall(sentence) and (not _NUMBER.fullmatch(word) or bool(_WHEN.search(sentence)))
        for sentence in sentences
    )


def _factor_effect(old: FieldDefinition, new: FieldDefinition) -> str:
    before, after = _number(old.multiplier or "1"), _number(new.multiplier or "1")
    if isinstance(before, Fraction) and isinstance(after, Fraction) and before and after:
        return f"receivers of the other version are wrong by a factor of {decimal(max(after / before, before / after))}"
    return "receivers of the other version are wrong by a factor"


def _is_same_sentinel(old: Sentinel | None, new: Sentinel | None) -> bool:
    """Whether the same values mean unknown, however they are written."""
    if old is None or new is None:
        return old is new
    return old.form is new.form and [_value(value) for value in old.values] == [_value(value) for value in new.values]


def _value(value: int | float | None) -> str:
    return "NaN" if isinstance(value, float) and math.isnan(value) else str(value)


def _stated_at(field: WireField) -> Place:
    return field.sentinel.place if field.sentinel else field.definition.place


def _sentinel(field: WireField) -> str | None:
    return None if field.sentinel is None else field.sentinel.written


def _number(text: str | None) -> Fraction | str | None:
    """The number that a text stands for, so that 0.01 is 1E-2; the text itself where it is none."""
    number = None if text is None else exact_number(text)
    return text if number is None else number


def _range(definition: FieldDefinition) -> str | None:
    if definition.minimum is None and definition.maximum is None:
        return None
    return f"{definition.minimum or ''}..{definition.maximum or ''}"
