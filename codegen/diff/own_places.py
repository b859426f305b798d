"""Places that somebody can act on: those of the packaged corrections become places of the files that are compared."""

import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from codegen.decode.shipped_corrections import FOLDER
from codegen.diff.change import Change
from codegen.model.dialect.dialect import Dialect
from codegen.model.system import System
from codegen.source import Place


def at_own_places(
    changes: Iterable[Change],
    old: Dialect,
    new: Dialect,
    old_systems: Sequence[System] = (),
    new_systems: Sequence[System] = (),
) -> Iterator[Change]:
    """Yield the changes of a dialect with no place in a file that comes with codegen.

    What a packaged correction states of a field stands in a project where a table answers for the field, else where
    the project names its dialect. Without a project it stands at the field in the XML.
    """
    for change in changes:
        place = _own(change.place, change.subject, new, new_systems) or _own(
            change.place, change.subject, old, old_systems
        )
        was_at = change.was_at and _own(change.was_at, change.subject, old, old_systems)
        is_same = place == change.place and was_at == change.was_at
        yield change if is_same else replace(change, place=place or change.place, was_at=was_at)


def _own(place: Place, subject: str, dialect: Dialect, systems: Sequence[System]) -> Place | None:
    """Return the place itself where it is nobody's but the user's; None where nothing else says where it is."""
    if os.path.dirname(place.file) != FOLDER:
        return place
    message, _, field = subject.partition(".")
    answers = (
        answer.covers.written.place
        for system in systems
        for populated in system.messages
        if populated.wire.name == message
        for answer in populated.answers
        if answer.covers.field.name == field
    )
    named = (system.spec.project.at("dialect") for system in systems)
    wire = dialect.messages.get(message)
    fields = (each.definition.place for each in (wire.fields if wire else ()) if each.name == field)
    return next((found for places in (answers, named, fields) for found in places), None)
