"""Findings in the documents of a project, cached from one run to the next: most edits leave most documents alone.

What is found in a document depends on its text, on all that the documents are compared with, and on files that are read
meanwhile, such as dialects that have a message of the same name. While these are as they were, so is what was found.
"""

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, cast

from codegen.decode.decoded import decoded, with_files_read
from codegen.diagnostics import Diagnostic, Report
from codegen.frozen import dataclass
from codegen.load.files import Files, asked_once
from codegen.model.price import sent_sizes
from codegen.model.system import System
from codegen.tool.cache import entry, keep_object, kept_object, pickled
from codegen.tool.digest import tool_digest

if TYPE_CHECKING:
    from codegen.claims.reading import Reference
    from codegen.commands.documents import OfDialect
    from codegen.importing.stated import StatedFields


@dataclass(frozen=True, slots=True)
class Found:
    """The findings in a document: drift between its tables and those of the messages, and false claims."""

    drift: tuple[Diagnostic, ...]
    claims: tuple[Diagnostic, ...]


def project_documents(systems: Iterable[System]) -> list[str]:
    """The absolute paths of the requirement documents of a project and its programs, each once."""
    files = {requirement.place.file for system in systems for requirement in system.spec.requirements}
    return sorted(files)


def check_project_documents(systems: Sequence[System], files: Files, report: Report) -> list[str]:
    """Report what is wrong in the documents of a project; returns the absolute paths of those that could be read.

    Of a place that has a finding already, such as a cell that differs from the population table, no claim is reported.
    """
    paths = project_documents(systems)
    systems = _without_texts(systems, paths)
    compared_with, dialects = _digest(systems), _digest_of_dialects(systems)
    seen: dict[str, str] = {}
    looked_at: dict[str, str] = {}
    reference = asked_once(lambda noting: _reference(systems, noting))
    found: dict[str, Found] = {}
    for path in paths:
        text = files.read_text(path, report)
        if text is not None:
            find = _finder(text, path, systems, reference, (compared_with, dialects, looked_at))
            inputs = compared_with, path, text
            found[path] = with_files_read(inputs, find, seen, files) if compared_with else find(files)
    for of_document in found.values():
        report.extend(of_document.drift)
    told = {finding.place for finding in report}
    for of_document in found.values():
        report.extend(finding for finding in of_document.claims if finding.place not in told)
    return list(found)


def _without_texts(systems: Iterable[System], documents: Iterable[str]) -> tuple[System, ...]:
    """The systems without the hashes of the documents and of what they say: an edit of one that changes no criterion
    concerns no other.
    """
    left_out = set(documents)
    kept = []
    for system in systems:
        files = {path: found for path, found in system.spec.files.items() if path not in left_out}
        requirements = tuple(replace(each, said="") for each in system.spec.requirements)
        kept.append(replace(system, spec=replace(system.spec, files=files, requirements=requirements)))
    return tuple(kept)


def _digest(systems: Iterable[System]) -> str:
    """The hash of what the documents are compared with; empty where there is none for a dialect.

    Systems are made of their specifications and dialects, and messages may name files as they are called from here.
    """
    parts = [(system.spec, system.dialect.digest) for system in systems]
    if not all(digest for _, digest in parts):
        return ""
    return entry("documents", tool_digest(), os.getcwd(), pickled(parts))


def _digest_of_dialects(systems: Sequence[System]) -> str:
    """The hash of all that statements about messages are compared with; empty where there is none for a dialect.

    That are the dialect, also with overlays that are not listed, and how long messages are as they are sent. Most edits
    of a specification leave these alone.
    """
    if not systems or not systems[0].dialect.digest:
        return ""
    spec = systems[0].spec
    parts = (
        systems[0].dialect.digest, spec.folder, spec.project, spec.corrections, spec.other_corrections, spec.refusals,
        spec.other_overlays, sorted(sent_sizes(systems).items()),
    )  # fmt: skip
    return entry("dialects of documents", tool_digest(), os.getcwd(), pickled(parts))


def _reference(systems: Sequence[System], files: Files) -> "Reference":
    from codegen.commands.documents import project_reference

    return project_reference(systems, files)


def _finder(
    text: str,
    path: str,
    systems: Sequence[System],
    reference: "Callable[[Files], Reference]",
    known_by: tuple[str, str, dict[str, str]],
) -> Callable[[Files], Found]:
    """Return what finds what is wrong in a document: it imports all that this needs.

    ``known_by`` has the hashes of the systems and of the dialects, and by path what was found at files that were
    compared before.
    """
    compared_with, dialects, seen = known_by

    def find(noting: Files) -> Found:
        from codegen.commands.documents import found_claims, of_dialects
        from codegen.importing.stated import stated_fields

        stated = decoded("stated fields", text, path, lambda _: stated_fields(text, path), Report())
        assert stated is not None  # every text is Markdown

        def compare(inner: Files) -> "OfDialect":
            return of_dialects(text, path, reference(inner), inner)

        known = with_files_read((dialects, path, text), compare, seen, noting) if dialects else None
        claims = found_claims(text, path, reference(noting), noting, known)
        return Found((*stated.findings, *_drift(stated, systems, compared_with)), tuple(claims))

    return find


def _drift(stated: "StatedFields", systems: Sequence[System], compared_with: str) -> tuple[Diagnostic, ...]:
    """The drift of the lists of fields of a document; most edits leave these as they are, and where they stand."""
    if not stated.lists:
        return ()
    lists = [(each.rows, each.place, each.context, sorted(role.value for role in each.roles)) for each in stated.lists]
    name = entry("drift", compared_with, pickled(lists)) if compared_with else ""
    known = kept_object(name) if name else None
    if known is not None:
        return cast("tuple[Diagnostic, ...]", known)
    from codegen.importing.drift import drift

    found = tuple(drift(stated, systems))
    if name:
        keep_object(name, found)
    return found
