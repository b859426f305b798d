"""Changes in the meaning of a field's bytes: units, sentinels, enums, ranges. CRC_EXTRA covers none of them."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

from codegen.diff.change import BOTH, Change, ChangeRule, changed
from codegen.diff.dialect import wire_rules as rules
from codegen.diff.dialect.pairing import Pair
from codegen.diff.dialect.sentinels import is_same_sentinel, other_sentinel
from codegen.diff.judging.judging import HARMLESS, Judgement, enum_for_words, gravest, other_enum
from codegen.diff.judging.quantities import (
    SAME_NUMBER,
    first_minimum,
    first_unit,
    other_range,
    other_unit,
)
from codegen.diff.judging.texts import other_text
from codegen.diff.judging.units_in_words import unit_in_words
from codegen.model.dialect.dialect import EnumDefinition, FieldDefinition, WireField
from codegen.model.dialect.literals import exact_number
from codegen.model.units.unit import Unit, decimal, ratio
from codegen.source import Place

_IN_WORDS = " (in words)"


class Vocabulary(NamedTuple):
    """The enums of both versions, by name."""

    old: Mapping[str, EnumDefinition]
    new: Mapping[str, EnumDefinition]


def meaning_changes(pair: Pair, message: str, enums: Vocabulary) -> Iterator[Change]:
    """Yield what changed in the meaning of a field of ``message``, the gravest
    first; ``enums`` are of both versions.
    """
    if _is_unchanged(pair):
        return
    told = _Teller(pair, message)
    yield from _amounts(told, pair)
    yield from _readings(told, enums)
    yield from _texts(told)


def _is_unchanged(pair: Pair) -> bool:
    """Return whether both versions say the same, wherever they stand: so it is of nearly all fields."""
    old, new = (side.definition for side in pair)
    is_same = old is new or old == new._replace(place=old.place)
    return is_same and is_same_sentinel(pair.old.sentinel, pair.new.sentinel)


class _Teller(NamedTuple):
    """The maker of changes of one field."""

    pair: Pair
    message: str

    @property
    def sides(self) -> tuple[FieldDefinition, FieldDefinition]:
        return self.pair.old.definition, self.pair.new.definition

    def change(
        self,
        rule: ChangeRule,
        words: tuple[str | None, str | None],
        judgement: Judgement | None = None,
        places: tuple[Place, Place] | None = None,
    ) -> Change:
        """The change, judged by its rule alone where there is no judgement."""
        old, new = self.sides
        found = judgement or HARMLESS
        breaks = None if judgement is None else BOTH if found.breaks else ()
        return changed(
            rule,
            f"{self.message}.{new.name}",
            *words,
            places or (old.place, new.place),
            found.effect,
            breaks=breaks,
            doubt=found.doubt,
            messages=(self.message,),
        )

    def attribute(self, name: str) -> tuple[str | None, str | None] | None:
        """Return both texts of an attribute, where they differ."""
        old, new = (getattr(side, name) or None for side in self.sides)
        return None if old == new else (old, new)


def _amounts(told: _Teller, pair: Pair) -> Iterator[Change]:
    """Yield what the number amounts to: units, the value for unknown, the multiplier."""
    old, new = told.sides
    is_same_number = _scale(old, new) == 1
    units = _units(old, new)
    if units is not None:
        is_stated = is_same_number and told.attribute("units") is not None
        judgement = Judgement(effect=SAME_NUMBER) if is_stated else _other_units(*units, old, new)
        yield told.change(rules.FIELD_UNITS, units, judgement)
    if not is_same_sentinel(pair.old.sentinel, pair.new.sentinel):
        found = other_sentinel(pair.old, pair.new)
        words = tuple(side.sentinel.written if side.sentinel else None for side in pair)
        places = _stated_at(pair.old), _stated_at(pair.new)  # a correction may have stated it
        change = told.change(rules.FIELD_SENTINEL, (words[0], words[1]), None, places)
        yield replace(change, effect=found.effect, doubt=found.doubt, breaks=() if found.doubt else found.breaks)
    for name in ("unchanged", "unknown"):
        if words_of_list := told.attribute(name):
            yield told.change(rules.FIELD_SPECIAL, words_of_list)
    if _number(old.multiplier) != _number(new.multiplier):
        judgement = Judgement(effect=SAME_NUMBER) if is_same_number else _other_factor(old, new)
        yield told.change(rules.FIELD_MULTIPLIER, (old.multiplier, new.multiplier), judgement)


def _readings(told: _Teller, enums: Vocabulary) -> Iterator[Change]:
    """Yield how the number is read: as bits, as an instance, within a range, by an enum, by its default."""
    old, new = told.sides
    if old.is_bitmask != new.is_bitmask:
        words = ["bits" if side.is_bitmask else "a number" for side in (old, new)]
        yield told.change(rules.FIELD_BITMASK, (words[0], words[1]))
    if old.is_instance != new.is_instance:
        words = ["the instance" if side.is_instance else "a value" for side in (old, new)]
        yield told.change(rules.FIELD_INSTANCE, (words[0], words[1]), _other_instance(new))
    if (_number(old.minimum), _number(old.maximum)) != (_number(new.minimum), _number(new.maximum)):
        limits = (old.minimum, old.maximum), (new.minimum, new.maximum)
        judgement = gravest(other_range(*limits), first_minimum(*limits, old.description))
        yield told.change(rules.FIELD_RANGE, (_range(old), _range(new)), judgement)
    if words_of_enum := told.attribute("enum"):
        yield told.change(rules.FIELD_ENUM, words_of_enum, _enum_judgement(old, new, enums))
    if increments := told.attribute("increment"):
        yield told.change(rules.FIELD_INCREMENT, increments)
    if defaults := told.attribute("default"):
        yield told.change(rules.FIELD_DEFAULT, defaults, other_default(*defaults))


def _texts(told: _Teller) -> Iterator[Change]:
    old, new = told.sides
    if formats := told.attribute("print_format"):
        yield told.change(rules.PRINT_FORMAT, formats)
    if old.description != new.description:
        is_unit_told = old.units is new.units is None and _units(old, new) is not None
        meaning = HARMLESS if is_unit_told else other_text(old.description, new.description)
        words = old.description or None, new.description or None
        if meaning.gravity:
            yield told.change(rules.FIELD_MEANING, words, meaning)
        else:
            yield told.change(rules.DESCRIPTION, words)


def _units(old: FieldDefinition, new: FieldDefinition) -> tuple[str | None, str | None] | None:
    """Return both units where they differ: of the attributes, or else of the text."""
    before, after = old.units or None, new.units or None
    if before is not None and after is not None:
        return (before, after) if before != after else None
    words = [unit_in_words(side.description) for side in (old, new)]
    if before is None and after is None:
        if words[0] is None or words[1] is None or words[0] == words[1]:
            return None
        return f"{words[0]}{_IN_WORDS}", f"{words[1]}{_IN_WORDS}"
    if before is None:
        return (f"{words[0]}{_IN_WORDS}" if words[0] else None), after
    return before, (f"{words[1]}{_IN_WORDS}" if words[1] else None)


def _other_units(old: str | None, new: str | None, before: FieldDefinition, after: FieldDefinition) -> Judgement:
    """Return what comes of another unit, or of one that came or went, of a field as it was and is."""
    if old is None:
        first = first_unit(new or "", False, before.description)
        return first if first.gravity else Judgement(effect="stated for the first time")
    if new is None:
        effect = "nothing says what the number counts any more"
        is_denied = re.search(r"\bunitless\b|\bno unit\b|\bdimensionless\b", after.description, re.IGNORECASE)
        return (
            Judgement(doubt="whether it ever had that unit", effect=effect)
            if is_denied
            else Judgement(True, effect=effect)
        )
    return other_unit(old.removesuffix(_IN_WORDS), new.removesuffix(_IN_WORDS))


def _scale(old: FieldDefinition, new: FieldDefinition) -> Fraction | None:
    """Return the factor by which the number for one value grew, unit and multiplier together; None where unknown."""
    factor = Fraction(1) if (old.units or "") == (new.units or "") else _factor(old.units or "", new.units or "")
    before, after = _number(old.multiplier or "1"), _number(new.multiplier or "1")
    if factor is None or not isinstance(before, Fraction) or not isinstance(after, Fraction) or not after:
        return None
    return factor * before / after


def _factor(old: str, new: str) -> Fraction | None:
    before, after = Unit.parse(old), Unit.parse(new)
    return ratio(before, after) if before and after else None


def _other_factor(old: FieldDefinition, new: FieldDefinition) -> Judgement:
    """Return what comes of another multiplier: one that a text had before is none."""
    for text, said, words in (
        (new.multiplier if old.multiplier is None else None, old.description, "the description said so before"),
        (old.multiplier if new.multiplier is None else None, new.description, "the description still says so"),
    ):
        factor = _number(text)
        if isinstance(factor, Fraction) and _is_in_text(factor, said):
            return Judgement(effect=words)
    before, after = _number(old.multiplier or "1"), _number(new.multiplier or "1")
    effect = "receivers of the other version are wrong by a factor"
    if isinstance(before, Fraction) and isinstance(after, Fraction) and before and after:
        effect = f"{effect} of {decimal(max(after / before, before / after))}"
        is_told = old.multiplier is None and _is_in_text(after, new.description)
        if is_told:
            return Judgement(doubt="whether the numbers were sent so before it was written down", effect=effect)
    return Judgement(breaks=True, effect=effect)


def _is_in_text(factor: Fraction, text: str) -> bool:
    """Return whether a text tells of a factor: ``* 100`` of 1E-2, ``0: 0 deg, 255: 360 deg`` of 360/255."""
    compact = text.replace(" ", "").lower()
    inverse = decimal(1 / factor)
    if any(f"{sign}{inverse}" in compact for sign in ("*", "x")) or decimal(factor) in compact.split():
        return True
    numerator, denominator = factor.numerator, factor.denominator
    return any(
        f"{denominator * count}:{numerator * count}" in compact
        for count in range(1, 256)
        if denominator * count < 2**16
    )


def _other_instance(new: FieldDefinition) -> Judgement:
    effect = "what the messages are about is told apart otherwise"
    if new.is_instance:
        return Judgement(effect="stated for the first time; the number told apart what the messages are about before")
    return Judgement(breaks=True, effect=effect)


def other_default(old: str | None, new: str | None) -> Judgement:
    """Return what comes of another value for what nobody sets: zeros are what an old sender leaves there."""
    before, after = _number(old or None), _number(new or None)
    if before == after or (before in (None, 0) and after in (None, 0)):
        return Judgement(effect="who does not set it sends 0 already")
    if before is not None and after is not None:
        return Judgement(breaks=True, effect=f"what nobody sets was {old} and is {new}")
    told = new if before is None else old
    return Judgement(doubt=f"who fills in {told}, since what nobody sets is sent as 0")


def _enum_judgement(old: FieldDefinition, new: FieldDefinition, enums: Vocabulary) -> Judgement:
    before, after = enums.old.get(old.enum or ""), enums.new.get(new.enum or "")
    if not old.enum:
        return gravest(Judgement(effect="stated for the first time"), enum_for_words(old.description, after))
    if not new.enum:
        if before is None:
            return Judgement(breaks=True, effect="nothing says what its numbers mean any more")
        return other_enum(before, None, new.description)
    if before is None or after is None:
        return Judgement(breaks=True)
    return other_enum(before, after, new.description)


def _stated_at(field: WireField) -> Place:
    return field.sentinel.place if field.sentinel else field.definition.place


def _number(text: str | None) -> Fraction | str | None:
    """The number that a text stands for, so that 0.01 is 1E-2; the text itself where it is none."""
    number = None if text is None else exact_number(text)
    return text if number is None else number


def _range(definition: FieldDefinition) -> str | None:
    if definition.minimum is None and definition.maximum is None:
        return None
    return f"{definition.minimum or ''}..{definition.maximum or ''}"
