"""A dialect file and everything it includes."""

import os
from dataclasses import replace
from functools import lru_cache

from codegen.decode.dialect.dialect import decode_dialect_file
from codegen.diagnostics import Diagnostic, Report, did_you_mean
from codegen.load.files import Files
from codegen.load.shipped import is_shipped, shipped_dialect_names, shipped_dialect_path
from codegen.load.text import FILE_NOT_FOUND, real_path
from codegen.load.xml_tree import parse_xml_bytes
from codegen.model.dialect.dialect import DialectFile
from codegen.source import Place


def decode_dialect_files(
    path: str, files: Files, report: Report, asked_at: Place | None = None, known: tuple[DialectFile, ...] = ()
) -> tuple[DialectFile, ...]:
    """The file and all files it includes, over all levels, each once; included files before those that include them.

    Paths of includes are relative to the including file; a plain name of which there is no file is that of a shipped
    dialect. Files that include each other are read once each, which is
    no error. A missing or unreadable file is reported at its ``<include>``; for ``path`` itself at ``asked_at``, the
    place that names it, if there is one. ``known`` are files that were read before and are not read again: those of
    the dialect, when ``path`` is an overlay.
    """
    finished: list[DialectFile] = []
    seen = {real_path(file.path) for file in known}
    # A stack of its own instead of recursion: a chain of includes may be as long as it likes.
    open_files: list[tuple[DialectFile, int]] = []

    def open_file(path: str, asked_at: Place | None, written: str = "") -> None:
        identity = real_path(path)
        if identity in seen:
            return
        seen.add(identity)
        missing = Report()
        data = files.read_bytes(path, missing, asked_at)
        report.extend(_with_hint(found, written, files) for found in missing)
        file, findings = (None, ()) if data is None else _decoded(data, path)
        report.extend(findings)
        if file is not None:
            open_files.append((file, 0))

    open_file(os.path.abspath(path), asked_at)
    while open_files:
        file, position = open_files.pop()
        if position == len(file.includes):
            finished.append(file)
            continue
        open_files.append((file, position + 1))
        include = file.includes[position]
        if "://" in include.path:
            message = f"{include.path} is an address: nothing is read from a network"
            report.add(FILE_NOT_FOUND, include.place, message, "keep a copy beside this file, and name that")
        else:
            open_file(_included(file.path, include.path, files), include.place, include.path)
    return tuple(finished)


def _with_hint(found: Diagnostic, written: str, files: Files) -> Diagnostic:
    """Return a finding about an included file; where a shipped dialect is nearly called so, that is the hint."""
    if not written or found.rule is not FILE_NOT_FOUND:
        return found
    names = [f"{name}.xml" for name in shipped_dialect_names(files)]
    hint = did_you_mean(written, [name for name in names if name.lower() == written.lower()] or names) or ""
    return replace(found, hint=hint) if hint.startswith("did you mean") else found


def _included(path: str, written: str, files: Files) -> str:
    """The absolute path of what a file includes: what lies there, or else the dialect of that name that is shipped.

    So a dialect of one's own says ``<include>common.xml</include>`` without a copy of it beside it.
    """
    beside = os.path.abspath(os.path.join(os.path.dirname(path), written))
    name, ending = os.path.splitext(written)
    shipped = shipped_dialect_path(name, files) if ending == ".xml" else None
    if (
        shipped is None or files.read_bytes(beside, Report()) is not None
    ):  # which notes for the cache that there is none
        return beside
    return shipped


def decode_project_dialect(
    path: str, files: Files, report: Report, asked_at: Place | None = None
) -> tuple[DialectFile, ...]:
    """Decode the dialect that a project names, like ``decode_dialect_files``: files of its own add to pymavlink's.

    A file that is called as a dialect of pymavlink is a copy of that, perhaps of another release, and adds nothing.
    """
    found = decode_dialect_files(path, files, report, asked_at)
    copied = {f"{name}.xml" for name in shipped_dialect_names(files)}
    return tuple(replace(file, is_overlay=os.path.basename(file.path) not in copied) for file in found)


def decode_overlay(
    path: str, files: Files, report: Report, asked_at: Place | None = None, known: tuple[DialectFile, ...] = ()
) -> tuple[DialectFile, ...]:
    """Decode a file of the project that adds to the dialect, like ``decode_dialect_files``, and mark it as an overlay.

    So are the files that it includes, but not pymavlink's.
    """
    found = decode_dialect_files(path, files, report, asked_at, known)
    return tuple(replace(file, is_overlay=not is_shipped(file.path, files)) for file in found)


@lru_cache(maxsize=64)
def _decoded(data: bytes, path: str) -> tuple[DialectFile | None, tuple[Diagnostic, ...]]:
    """Return what the content of a file defines, and what is wrong with it.

    Kept: whoever reads several specifications mostly finds the same dialect files in them.
    """
    found = Report()
    root = parse_xml_bytes(data, path, found)
    file = None if root is None else decode_dialect_file(root, path, found)
    return file, tuple(found)
