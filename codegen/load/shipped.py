"""The dialects that pymavlink ships as XML inside its package: of the installed one, or of another that is given."""

import os
from collections.abc import Mapping
from functools import cache
from importlib.util import find_spec

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.load.files import DISK, Files
from codegen.source import Place


def shipped_dialect_path(name: str, files: Files) -> str | None:
    """The absolute path of the XML file of a shipped dialect (``common``), or None where pymavlink has no such."""
    return _shipped(files).get(name)


def shipped_dialect_names(files: Files) -> tuple[str, ...]:
    """The names of all shipped dialects, sorted; empty where pymavlink is not installed."""
    return tuple(_shipped(files))


def is_shipped(path: str, files: Files) -> bool:
    """Return whether the absolute ``path`` is the XML file of a shipped dialect."""
    return path in _shipped(files).values()


def shipped_folders(files: Files) -> tuple[str, ...]:
    """The folders that the XML files of the shipped dialects lie in."""
    return tuple({os.path.dirname(path) for path in _shipped(files).values()})


def files_beside(path: str, files: Files) -> Files:
    """Return the files that a dialect without a project may include, which may be somebody else's.

    They lie in its own folder, in the working directory, below these, or are shipped.
    """
    return files.confined((os.path.dirname(path), os.getcwd(), *shipped_folders(files)))


def dialect_path(
    written: str, folder: str, unknown: Rule, place: Place, files: Files, report: Report, *, is_file: bool
) -> str | None:
    """The absolute path of the XML file of the dialect called ``written``; None after the diagnostic ``unknown``.

    Where pymavlink ships no such dialect, ``written`` is the path of a file below ``folder``, if ``is_file`` says so.
    """
    path = shipped_dialect_path(written, files)
    if path is not None:
        return path
    if not is_file:
        hint = did_you_mean(written, shipped_dialect_names(files))
        report.add(unknown, place, f"pymavlink ships no dialect {written}", hint)
        return None
    return os.path.normpath(os.path.join(folder, written))


def _shipped(files: Files) -> Mapping[str, str]:
    return _installed() if files.dialects is None else files.dialects


def dialects_in(folder: str, files: Files, report: Report) -> dict[str, str]:
    """The absolute path of each XML file of a folder by the name of its dialect, sorted."""
    names = (name for name in files.names(folder, report) if name.endswith(".xml"))
    return {os.path.splitext(name)[0]: os.path.join(folder, name) for name in names}


@cache
def _installed() -> dict[str, str]:
    # find_spec on the top-level package locates it without importing it, which would cost more than reading the XML.
    try:
        found = find_spec("pymavlink")
    except (ImportError, ValueError):
        return {}
    paths: dict[str, str] = {}
    for location in (found.submodule_search_locations or ()) if found else ():
        paths = {**dialects_in(os.path.abspath(os.path.join(location, "dialects", "v20")), DISK, Report()), **paths}
    return dict(sorted(paths.items()))
