"""The way of the data for claims: documents, and the dialect or the project that they are compared with."""

import os
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from codegen.claims import of_dialect, of_project, settled
from codegen.claims.overlays import lines_about
from codegen.claims.reading import Reading, Reference, read_document
from codegen.commands.document_programs import programs_about, stated_parameters, stated_rates
from codegen.decode.dialect.known import taken_elsewhere
from codegen.diagnostics import Diagnostic, Report
from codegen.load.files import DISK, Files, asked_once
from codegen.model.price import sent_sizes
from codegen.model.spec.spec import Spec
from codegen.model.system import System
from codegen.project.dialect import listed_messages
from codegen.project.other_overlays import other_dialect

if TYPE_CHECKING:
    from codegen.claims.own.worked.listing import Number


def dialect_reference(written: str, report: Report) -> Reference | None:
    """Return what a dialect says, by its name or the path of its file; None after a diagnostic."""
    from codegen.commands.codec import read_codec_dialect

    dialect = read_codec_dialect(written, report)
    return None if dialect is None else Reference(dialect)


def project_reference(systems: Sequence[System], files: Files = DISK) -> Reference:
    """Return the reference for a project's documents: its dialect and the facts of its programs (one at least)."""
    sent = sent_sizes(systems)
    spec = systems[0].spec
    listed = listed_messages(spec, files, Report())
    reference = Reference(
        systems[0].dialect,
        sent,
        listed,
        stated_parameters(systems),
        stated_rates(systems),
        tuple(systems),
        spec.project.overlays,
    )
    others = {name: asked_once(partial(_with_overlay, reference, spec, name)) for name in spec.other_overlays}
    return replace(reference, others=others)


def _with_overlay(reference: Reference, spec: Spec, overlay: str, files: Files) -> Reference | None:
    """Return what a project would say with an overlay that it does not list; of the
    messages that differ it sends none.
    """
    other = other_dialect(spec, reference.dialect, overlay, files)
    if other is None:
        return None
    sent = {name: size for name, size in reference.sent.items() if name not in other.messages}
    rates = {name: rate for name, rate in reference.rates.items() if name not in other.messages}
    return replace(reference, dialect=other.dialect, sent=sent, rates=rates, systems=())


def reference_about(reference: Reference, path: str) -> Reference:
    """Return the reference for a document: of the facts of a project those of the programs that it is about.

    What messages are, and how long, is alike in all of them.
    """
    systems = reference.systems
    if len(systems) < 2:
        return reference
    narrowed = replace(
        reference,
        parameters=stated_parameters(systems, path),
        rates=stated_rates(systems, path),
        systems=programs_about(systems, path),
    )
    spec = systems[0].spec
    others = {name: asked_once(partial(_with_overlay, narrowed, spec, name)) for name in reference.others}
    return replace(narrowed, others=others)


def check_documents(paths: Iterable[str], reference: Reference, report: Report, files: Files = DISK) -> list[str]:
    """Report what is wrong in the claims of documents; returns the absolute paths of those that could be read."""
    read = []
    for path in dict.fromkeys(os.path.abspath(path) for path in paths):
        text = files.read_text(path, report)
        if text is not None:
            report.extend(found_claims(text, path, reference, files))
            read.append(path)
    return read


def example_numbers(paths: Iterable[str], reference: Reference, files: Files = DISK) -> "Iterator[Number]":
    """The numbers of the worked examples of documents that can be read, and what is found when each is changed."""
    from codegen.claims.own.worked.listing import numbers

    for path in dict.fromkeys(os.path.abspath(path) for path in paths):
        text = files.read_text(path, Report())
        if text is not None:
            about = reference_about(reference, path)
            yield from numbers(text, with_other_dialects(read_document(text, path, about), files))


OfDialect = Mapping[str, tuple[Diagnostic, ...]]
"""Differences from the dialect, by the overlay that is in use besides; empty for none."""


def of_dialects(text: str, path: str, reference: Reference, files: Files) -> OfDialect:
    """Return what a text says of messages otherwise than the dialect, and, where it names an overlay that is not in
    use, otherwise than the dialect with that one.
    """
    reading = read_document(text, path, reference)
    found = {"": of_dialect(with_other_dialects(reading, files))}
    for overlay in lines_about(reading.prose, reference.overlays, reference.others):
        other = reference.others[overlay](files)
        if other is not None:
            found[overlay] = of_dialect(with_other_dialects(read_document(text, path, other), files))
    return found


def found_claims(
    text: str, path: str, reference: Reference, files: Files, known: OfDialect | None = None
) -> list[Diagnostic]:
    """Return what is wrong in the claims of a text: those about an overlay that is not in use by what holds with it.

    ``known`` is what differs from the dialects, if that has been found out.
    """
    known = of_dialects(text, path, reference, files) if known is None else known
    reference = reference_about(reference, path)
    reading = read_document(text, path, reference)
    own = of_project(reading)
    found: list[Diagnostic] = []
    elsewhere: set[int] = set()
    for overlay, lines in lines_about(reading.prose, reference.overlays, reference.others).items():
        if overlay in known:
            elsewhere |= lines
            there = _of_project_there(text, path, reference, files, overlay) if _are_in(own, lines) else ()
            found += settled(reading, (*known[overlay], *there), lines.__contains__)
    found += settled(reading, (*known[""], *own), lambda line: line not in elsewhere)
    return sorted(found, key=lambda finding: finding.place)


def _are_in(findings: Iterable[Diagnostic], lines: Collection[int]) -> bool:
    return any(finding.place.line in lines for finding in findings)


def _of_project_there(text: str, path: str, reference: Reference, files: Files, overlay: str) -> tuple[Diagnostic, ...]:
    """Return the findings about the project as it would be with another overlay; none where that cannot be told."""
    other = reference.others[overlay](files)
    return of_project(read_document(text, path, other)) if other is not None else ()


def with_other_dialects(reading: Reading, files: Files) -> Reading:
    """The reading with the messages of shipped dialects that it names, or that its own ones share an id with."""
    from codegen.claims.unknown_names import unknown_names

    proposed = [message.definition for message in reading.proposed]
    reference = reading.reference
    others = set(unknown_names(reading))
    taken = taken_elsewhere(proposed, reference.dialect.files, reference.listed, files, others)
    return replace(reading, reference=replace(reference, listed=taken)) if taken else reading
