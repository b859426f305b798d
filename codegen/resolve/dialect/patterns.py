"""Corrections of many fields: a pattern becomes one correction for each field that it matches."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from codegen.diagnostics import Report, did_you_mean
from codegen.model.dialect.dialect import MessageDefinition
from codegen.resolve.dialect.corrected import CORRECTION_UNKNOWN, is_stated

if TYPE_CHECKING:
    from codegen.model.spec.spec import Correction


def matching(pattern: str, names: Iterable[str]) -> list[str]:
    """The names that are of a pattern, in their order: ``*`` is any text, ``?`` a character, ``[ab]`` a or b."""
    return [name for name in names if fnmatchcase(name, pattern)]


def expanded(
    corrections: "Iterable[Correction]", messages: Mapping[str, MessageDefinition], report: Report
) -> "tuple[Correction, ...]":
    """The corrections, in place of each with a pattern one for each of its fields; a pattern without any is reported.

    Where the dialect states of some of the fields already what is to be set, only the others are corrected.
    """
    return tuple(one for correction in corrections for one in _of_each(correction, messages, report))


def _of_each(
    correction: "Correction", messages: Mapping[str, MessageDefinition], report: Report
) -> "Iterator[Correction]":
    message = messages.get(correction.message or "")
    if correction.fields is None or correction.field is not None or message is None:
        yield correction  # what is wrong with it is reported where it is applied
        return
    fields = {field.name: field for field in message.fields}
    names = matching(correction.fields, fields)
    if not names:
        problem = f"{message.name} has no field of the pattern {correction.fields}"
        report.add(CORRECTION_UNKNOWN, correction.at("fields"), problem, did_you_mean(correction.fields, fields))
    for name in names:
        open_attributes = {key: text for key, text in correction.set.items() if not is_stated(fields[name], key, text)}
        if open_attributes or not correction.set:
            yield replace(correction, field=name, fields=None, set=open_attributes)
        elif all(is_stated(fields[other], key, text) for other in names for key, text in correction.set.items()):
            yield replace(correction, field=name, fields=None)  # one finding for all
            return
