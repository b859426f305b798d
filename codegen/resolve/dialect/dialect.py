"""The files of a dialect, its overlays and its corrections become one dialect."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.dialect.dialect import Dialect, DialectFile, EnumDefinition, MessageDefinition
from codegen.model.dialect.wire_types import VERSION_TYPE
from codegen.resolve.dialect.corrections import apply_corrections
from codegen.resolve.dialect.enums import merge_enums
from codegen.resolve.dialect.messages import merged_messages, numbered_messages
from codegen.resolve.dialect.wire import wire_message

if TYPE_CHECKING:
    from codegen.model.spec.spec import Correction, Refusal, ShippedCorrection

UNKNOWN_ENUM = Rule(
    "field-unknown-enum",
    "The enum of the field is in no file of the dialect. Correct its name or include the file that has it.",
    remedy="include the file of the dialect that has it",
)

DEFAULT_VERSION = 2
"""The version that mavgen assumes for a file without a ``<version>``."""


def resolve_dialect(
    name: str,
    files: tuple[DialectFile, ...],
    corrections: "tuple[Correction, ...]",
    report: Report,
    shipped: "tuple[ShippedCorrection, ...]" = (),
    refusals: "tuple[Refusal, ...]" = (),
) -> Dialect:
    """The dialect that ``files`` make together: included files first, then the dialect's own, overlays last.

    Enums of the same name are merged; a message may be stated twice only alike. Corrections are applied before ids are
    compared and the wire order and the sentinels are computed; ``shipped`` are those that come with codegen, and
    ``refusals`` says which of them the project does not want. A field whose enum is a bitmask is a bitmask, as if it
    had ``display="bitmask"``. What is in error is reported at its place; the dialect holds what could be resolved.
    """
    files = tuple({file.path: file for file in files}.values())  # an overlay may include what the dialect includes
    enums = merge_enums(files, report)
    added = {message.name for file in files if file.is_overlay for message in file.messages}
    merged = merged_messages(files, report)
    corrected = apply_corrections(merged, enums, corrections, report, added, shipped, refusals)
    messages = numbered_messages(corrected.messages, report)
    wired = [
        wire_message(_with_enums(message, corrected.enums, report), corrected.enums, corrected.places, report)
        for message in messages
    ]
    return Dialect(
        name=name,
        version=_version(files),
        messages={message.name: message for message in wired},
        enums=corrected.enums,
        files=tuple(file.path for file in files),
        overlays=frozenset(file.path for file in files if file.is_overlay),
        corrections=tuple(corrected.of_attributes),
    )


def _version(files: tuple[DialectFile, ...]) -> int:
    """The value of ``uint8_t_mavlink_version`` fields: as in mavgen, the version of the file that declares the field.

    MAVLink's guide says that the outermost file counts, but no generator does so: storm32.xml has version 1 and its
    heartbeats carry the 3 of minimal.xml. Where that file is silent, the last file with a version counts.
    """
    declaring = [
        file.version
        for file in files
        if any(field.type == VERSION_TYPE for message in file.messages for field in message.fields)
    ]
    stated = [*declaring, *(file.version for file in reversed(files))]
    return next((version for version in stated if version is not None), DEFAULT_VERSION)


def _with_enums(message: MessageDefinition, enums: Mapping[str, EnumDefinition], report: Report) -> MessageDefinition:
    """``message`` with ``is_bitmask`` where the enum of a field is one; unknown enums are reported."""
    if not any(field.enum for field in message.fields):
        return message
    fields = []
    for field in message.fields:
        enum = enums.get(field.enum) if field.enum else None
        if field.enum and enum is None:
            hint = did_you_mean(field.enum, enums)
            report.add(UNKNOWN_ENUM, field.place, f"{message.name}.{field.name}: there is no enum {field.enum}", hint)
        fields.append(field._replace(is_bitmask=True) if enum and enum.is_bitmask and not field.is_bitmask else field)
    return replace(message, fields=tuple(fields))
