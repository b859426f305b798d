"""The corrections that come with codegen, held against the dialect that is installed."""

from collections.abc import Iterable, Iterator, Mapping, Set
from os.path import basename, splitext
from typing import TYPE_CHECKING

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.dialect.dialect import AttributeCorrection, FieldDefinition, MessageDefinition, Standing
from codegen.resolve.dialect.corrected import attribute_text
from codegen.resolve.dialect.patterns import matching

if TYPE_CHECKING:
    from codegen.model.spec.spec import Refusal, ShippedCorrection

REFUSAL_UNKNOWN = Rule(
    "refusal-unknown",
    "Nothing that comes with codegen corrects the message or the fields that are refused. Correct the names, or remove "
    "the refusal.",
)


def shipped_corrections(
    messages: Mapping[str, MessageDefinition],
    shipped: "Iterable[ShippedCorrection]",
    own: Set[tuple[str | None, str | None, str]],
    refusals: "tuple[Refusal, ...]",
    report: Report,
) -> tuple[AttributeCorrection, ...]:
    """Return what the shipped corrections state about single attributes of fields, and whether each holds.

    It is left to the dialect where that states the attribute by now, and to the project where that corrects the
    attribute of that message and field itself (``own``). It is outdated where its words stand neither in the
    description of the field nor in that of the message, and refused where the project says so; refusals of what is not
    corrected at all are reported.
    """
    unused = list(refusals)
    found: list[AttributeCorrection] = []
    corrected: dict[str, list[str]] = {}
    for correction in shipped:
        message = messages.get(correction.message)
        if message is None or not _is_of(message, correction.place.file):
            continue
        fields = {field.name: field for field in message.fields}
        for name in matching(correction.fields, fields):
            corrected.setdefault(message.name, []).append(name)
            refusal = next(
                (one for one in refusals if one.message == message.name and matching(one.fields, [name])), None
            )
            unused = [one for one in unused if one is not refusal]
            found += _of_field(correction, message, fields[name], refusal, own)
    for refusal in unused:
        written = refusal.message if refusal.fields == "*" else f"{refusal.message}.{refusal.fields}"
        names = corrected.get(refusal.message)
        near = did_you_mean(refusal.fields, names) if names else did_you_mean(refusal.message, corrected)
        hint = near or "codegen explain MESSAGE.field shows the corrections of a field"
        report.add(REFUSAL_UNKNOWN, refusal.place, f"there is no correction of {written} that could be refused", hint)
    return tuple(found)


def _is_of(message: MessageDefinition, path: str) -> bool:
    """Return whether a message stands in the dialect that the file of corrections is for."""
    return splitext(basename(message.place.file))[0] == splitext(basename(path))[0]


def _of_field(
    correction: "ShippedCorrection",
    message: MessageDefinition,
    field: FieldDefinition,
    refusal: "Refusal | None",
    own: Set[tuple[str | None, str | None, str]],
) -> Iterator[AttributeCorrection]:
    stated = next((each.place for each in (field, message) if correction.words in each.description), None)
    for attribute, text in correction.set.items():
        before = attribute_text(field, attribute)
        if before != correction.replaces or (message.name, field.name, attribute) in own:
            continue
        standing = Standing.APPLIED
        if stated is None:
            standing = Standing.OUTDATED
        elif refusal is not None:
            standing = Standing.REFUSED
        yield AttributeCorrection(
            owner=message.name,
            part=field.name,
            attribute=attribute,
            text=text,
            before=before,
            grounds=correction.words,
            place=correction.place,
            standing=standing,
            stated=stated,
            refusal=None if refusal is None else (refusal.reason, refusal.place),
        )
