"""The dialects that pymavlink ships as XML inside its package."""

import os
from functools import cache
from importlib.util import find_spec

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.source import Place


def shipped_dialect_path(name: str) -> str | None:
    """The absolute path of the XML file of a shipped dialect (``common``), or None where pymavlink has no such."""
    return _shipped().get(name)


def shipped_dialect_names() -> tuple[str, ...]:
    """The names of all shipped dialects, sorted; empty where pymavlink is not installed."""
    return tuple(_shipped())


def is_shipped(path: str) -> bool:
    """Whether the absolute ``path`` is the XML file of a shipped dialect."""
    return path in _shipped().values()


def dialect_path(
    written: str, folder: str, unknown: Rule, place: Place, report: Report, *, is_file: bool
) -> str | None:
    """The absolute path of the XML file of the dialect called ``written``; None after the diagnostic ``unknown``.

    Where pymavlink ships no such dialect, ``written`` is the path of a file below ``folder``, if ``is_file`` says so.
    """
    path = shipped_dialect_path(written)
    if path is not None:
        return path
    if not is_file:
        hint = did_you_mean(written, shipped_dialect_names())
        report.add(unknown, place, f"pymavlink ships no dialect {written}", hint)
        return None
    return os.path.normpath(os.path.join(folder, written))


@cache
def _shipped() -> dict[str, str]:
    # find_spec on the top-level package locates it without importing it, which would cost more than reading the XML.
    try:
        found = find_spec("pymavlink")
    except (ImportError, ValueError):
        return {}
    paths: dict[str, str] = {}
    for location in (found.submodule_search_locations or ()) if found else ():
        folder = os.path.abspath(os.path.join(location, "dialects", "v20"))
        try:
            files = os.listdir(folder)
        except OSError:
            continue
        for file in sorted(files):
            stem, extension = os.path.splitext(file)
            if extension == ".xml":
                paths.setdefault(stem, os.path.join(folder, file))
    return paths
