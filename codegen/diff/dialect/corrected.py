"""Attributes of a dialect below a correction, which hides that they have become something else."""

from collections.abc import Iterator
from dataclasses import replace

from codegen.diff.change import Change, changed
from codegen.diff.dialect import wire_rules as rules
from codegen.model.dialect.dialect import AttributeCorrection, Dialect, Standing

_COMMANDS = "MAV_CMD"


def below_corrections(old: Dialect, new: Dialect) -> Iterator[Change]:
    """Yield the attributes that both versions correct to the same text, and that the dialect states otherwise now.

    The correction was made for what stood there. Where it says something else itself, the attribute has changed, which
    is told as that; where the dialect has come to say what it sets, it is obsolete and not applied.
    """
    before = {_target(each): each for each in old.corrections if each.standing is Standing.APPLIED}
    for each in new.corrections:
        known = before.get(_target(each))
        if known is None or each.standing is not Standing.APPLIED or known.text != each.text:
            continue
        if _stated(known) == _stated(each):
            continue
        subject = f"{each.owner}.{each.part}" if each.part else each.owner
        is_message = each.owner in new.messages
        change = changed(
            rules.CORRECTED,
            subject,
            f"{each.attribute} {_stated(known)}",
            f"{each.attribute} {_stated(each)}",
            (known.place, each.place),
            f"a correction still makes it {each.text or 'nothing'}, and was made for what stood there",
            doubt="whether the correction still holds",
            messages=(each.owner,) if is_message else (),
        )
        if is_message:
            yield change
        elif each.owner in new.enums:
            yield replace(change, enum=each.owner, entry=each.part)
        else:
            yield replace(change, enum=_COMMANDS, entry=each.owner)


def _target(correction: AttributeCorrection) -> tuple[str, str, str]:
    return correction.owner, correction.part, correction.attribute


def _stated(correction: AttributeCorrection) -> str:
    """The text that the dialect itself has, on one line."""
    return " ".join((correction.before or "").split()) or "not stated"
