"""Compares a parameter of a command in two versions: its label, its words, its unit, its range, its enum."""

from collections.abc import Mapping

from codegen.diff.dialect.meaning import Vocabulary, other_default
from codegen.diff.judging.conflicts import other_statements, other_truth
from codegen.diff.judging.judging import HARMLESS, Judgement, enum_for_words, gravest, other_enum
from codegen.diff.judging.phrases import in_one_wording
from codegen.diff.judging.quantities import (
    first_minimum,
    first_unit,
    other_range,
    other_unit,
    share_for_unit,
)
from codegen.diff.judging.texts import other_text
from codegen.diff.judging.units_in_words import unit_in_words
from codegen.diff.judging.unset import first_meaning
from codegen.diff.judging.wording import Likeness, is_unsaid, name_likeness, text_likeness
from codegen.model.dialect.dialect import CommandParameter, EnumEntry

_TELLING = ("label", "units", "enum", "multiplier")
_ALIKE = (Likeness.SAME, Likeness.NEAR)


def other_parameter(
    old: CommandParameter | None,
    new: CommandParameter | None,
    entries: tuple[EnumEntry, EnumEntry],
    enums: Vocabulary,
) -> Judgement:
    """Return what comes of a parameter that is written otherwise; ``entries`` are its command in both versions."""
    if old is None or is_spare(old):
        if new is None or is_spare(new):
            return Judgement(effect="it was not used before")
        return first_meaning(old, new, enums.new.get(dict(new.attributes).get("enum", "")))
    if new is None or is_spare(new):
        return Judgement(breaks=True, effect=f"what old stations set as {_called(old)} is not used any more")
    before, after = dict(old.attributes), dict(new.attributes)
    return gravest(
        _other_words(old, new, entries),
        _other_unit(before, after, old.description, new.description),
        _other_range(before, after),
        first_minimum(_range(before), _range(after), old.description),
        _other_enum(before, after, old.description, new.description, enums),
        _other_default(before, after),
    )


def is_spare(parameter: CommandParameter) -> bool:
    """Return whether a parameter carries nothing: it is reserved, or nothing is said of it."""
    attributes = dict(parameter.attributes)
    if attributes.get("reserved", "").strip().lower() in ("true", "1"):
        return True
    return not any(attributes.get(name) for name in _TELLING) and is_unsaid(parameter.description)


def _called(parameter: CommandParameter) -> str:
    return repr(dict(parameter.attributes).get("label") or parameter.description)


def _other_words(old: CommandParameter, new: CommandParameter, entries: tuple[EnumEntry, EnumEntry]) -> Judgement:
    labels = [dict(side.attributes).get("label", "") for side in (old, new)]
    texts = text_likeness(old.description, new.description)
    names = name_likeness(*labels) if all(labels) else Likeness.UNSAID
    another = Judgement(
        breaks=True, effect=f"what was {_called(old)} is read as {_called(new)}{_swapped(old, new, entries)}"
    )
    if texts is Likeness.OPPOSITE or (names is Likeness.OPPOSITE and texts is not Likeness.SAME):
        return another
    values = other_statements(*(in_one_wording(side.description) for side in (old, new)))
    if names in (Likeness.SAME, Likeness.UNSAID, Likeness.NEAR):
        is_told_by_enum = "enum" in dict(new.attributes) and "enum" not in dict(old.attributes)
        if is_told_by_enum:
            found = gravest(values, other_truth(old.description, new.description))
        else:
            found = other_text(old.description, new.description)
        if found.gravity:
            return found
        is_doubtful = names is not Likeness.SAME and texts is Likeness.OTHER
        if is_doubtful or texts is Likeness.DISPUTED:
            return Judgement(doubt=f"whether {_called(new)} still is what {_called(old)} was")
        return HARMLESS
    if texts in _ALIKE:
        return Judgement(effect="another label for the same, as the text shows")
    if names is Likeness.VAGUE and not values.gravity and texts not in (Likeness.OTHER, Likeness.DISPUTED):
        return Judgement(doubt=f"whether {_called(new)} still is what {_called(old)} was")
    return another


def _swapped(old: CommandParameter, new: CommandParameter, entries: tuple[EnumEntry, EnumEntry]) -> str:
    """Return the end of a sentence that says that two parameters changed places; empty where they did not."""
    label = dict(old.attributes).get("label", "")
    for other in entries[1].parameters:
        if other.number != new.number and label and dict(other.attributes).get("label") == label:
            return f"; {label} is parameter {other.number} now"
    return ""


def _other_unit(before: Mapping[str, str], after: Mapping[str, str], old_text: str, new_text: str) -> Judgement:
    old, new = (
        side.get("units") or unit_in_words(text) or unit_in_words(side.get("label", ""))
        for side, text in ((before, old_text), (after, new_text))
    )
    if old == new or new is None:
        is_gone = old is not None and new is None and "units" in before
        return Judgement(breaks=True, effect="nothing says what the number counts any more") if is_gone else HARMLESS
    if old is not None:
        return other_unit(old, new)
    return gravest(
        share_for_unit(_range(before), _range(after), new, before.get("increment")),
        first_unit(new, "units" in after, old_text),
    )


def _other_range(before: Mapping[str, str], after: Mapping[str, str]) -> Judgement:
    if "enum" in after or "enum" in before:
        return HARMLESS
    is_fixed = before.get("units") and before.get("units") == after.get("units") != "%"
    return other_range(_range(before), _range(after), is_scaled=not is_fixed and "increment" not in before)


def _range(attributes: Mapping[str, str]) -> tuple[str | None, str | None]:
    return attributes.get("minValue"), attributes.get("maxValue")


def _other_enum(
    before: Mapping[str, str], after: Mapping[str, str], old_text: str, new_text: str, enums: Vocabulary
) -> Judgement:
    old, new = before.get("enum"), after.get("enum")
    if old == new:
        return HARMLESS
    if not old:
        return enum_for_words(old_text, enums.new.get(new or ""))
    if old not in enums.old or (new and new not in enums.new):
        return Judgement(breaks=True, effect="its numbers are those of another enum")
    return other_enum(enums.old[old], enums.new.get(new or ""), new_text)


def _other_default(before: Mapping[str, str], after: Mapping[str, str]) -> Judgement:
    """Return what comes of another default: a command carries each number, but who
    fills them in may take the default.
    """
    if "default" not in before or "default" not in after:
        return HARMLESS
    found = other_default(before["default"], after["default"])
    if before["default"] == after["default"] or not found.gravity:
        return HARMLESS
    return Judgement(doubt=f"who fills in the default, which was {before['default']} and is {after['default']}")
