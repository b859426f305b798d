"""The dialects that pymavlink ships as XML inside its package: of the installed one, or of another that is given."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib.util import find_spec

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.load.trees import file_names
from codegen.source import Place

_GIVEN: list[str] = []


@contextmanager
def shipped_in(folder: str) -> Iterator[None]:
    """Let the XML files of ``folder`` (absolute) be the dialects that are shipped, in place of the installed ones."""
    _GIVEN.append(folder)
    try:
        yield
    finally:
        _GIVEN.pop()


def is_another_given() -> bool:
    """Return whether the dialects are those of another pymavlink than the installed one."""
    return bool(_GIVEN)


def shipped_dialect_path(name: str) -> str | None:
    """The absolute path of the XML file of a shipped dialect (``common``), or None where pymavlink has no such."""
    return _shipped().get(name)


def shipped_dialect_names() -> tuple[str, ...]:
    """The names of all shipped dialects, sorted; empty where pymavlink is not installed."""
    return tuple(_shipped())


def is_shipped(path: str) -> bool:
    """Return whether the absolute ``path`` is the XML file of a shipped dialect."""
    return path in _shipped().values()


def shipped_folders() -> tuple[str, ...]:
    """The folders that the XML files of the shipped dialects lie in."""
    return tuple({os.path.dirname(path) for path in _shipped().values()})


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


def _shipped() -> dict[str, str]:
    return dialects_in(_GIVEN[-1]) if _GIVEN else _installed()


def dialects_in(folder: str) -> dict[str, str]:
    """The absolute path of each XML file of a folder by the name of its dialect, sorted."""
    names = (name for name in file_names(folder) if name.endswith(".xml"))
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
        paths = {**dialects_in(os.path.abspath(os.path.join(location, "dialects", "v20"))), **paths}
    return dict(sorted(paths.items()))
