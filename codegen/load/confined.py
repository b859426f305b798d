"""Where the files of a specification may lie: a finding quotes what it is about, and must not quote anything else."""

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

_ALLOWED: list[tuple[str, ...]] = []
_REAL: dict[str, str] = {}  # where links lead, by folder: each has many files, and is asked for with each


@contextmanager
def confined(folders: Iterable[str]) -> Iterator[None]:
    """Let only files below these folders be read meanwhile, wherever links lead."""
    _REAL.clear()
    _ALLOWED.append(tuple(sorted({os.path.realpath(folder) for folder in folders})))
    try:
        yield
    finally:
        _ALLOWED.pop()


def is_outside(path: str) -> bool:
    """Return whether a file of the disk lies, links followed, in none of the folders that may be read."""
    if not _ALLOWED:
        return False
    try:
        real = _real(path)
    except (OSError, ValueError):
        return False  # it cannot be read either
    return not any(real == folder or real.startswith(folder.rstrip(os.sep) + os.sep) for folder in _ALLOWED[-1])


def _real(path: str) -> str:
    """Return the path without links."""
    folder, name = os.path.split(path)
    if name in ("", os.curdir, os.pardir) or os.path.islink(path):
        return os.path.realpath(path)
    if folder not in _REAL:
        _REAL[folder] = os.path.realpath(folder)
    return os.path.join(_REAL[folder], name)
