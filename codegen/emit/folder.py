"""Lists the other files of an output folder, and finds paths that lead out of it."""

import os
from collections.abc import Collection

MANIFEST = "manifest.json"
"""The file that says which others codegen wrote there."""

OWN_FOLDER = ".codegen"
"""The folder that git and the comparison with what is generated leave out."""


UNFINISHED = (".codegen-", ".tmp")
"""Beginning and end of the name of a file while it is being written."""

_IGNORED = frozenset({OWN_FOLDER, "__pycache__", ".pytest_cache", ".hypothesis", ".mypy_cache", ".ruff_cache", ".git"})


def link_outside(folder: str, path: str) -> str | None:
    """Return the first link in ``path`` (relative to ``folder``) where it leads out of the folder, else None.

    The folder itself may be a link.
    """
    part = folder
    for name in path.split("/"):
        part = f"{part}/{name}"
        if os.path.islink(part):
            break
    else:
        return None
    root = os.path.realpath(folder)
    is_outside = os.path.commonpath([root, os.path.realpath(os.path.join(root, path))]) != root
    return part if is_outside else None


def other_files(folder: str, known: Collection[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The files below ``folder`` that are not ``known``, and those that an interrupted build left unfinished.

    Both as sorted relative posix paths. What running the generated code leaves behind is not looked at, and neither
    are empty folders. A link to a folder is not followed: it is a file of its own, unless known files lie behind it.
    """
    folders = {path[:end] for path in known for end, character in enumerate(path) if character == "/"}
    strays: list[str] = []
    leftovers: list[str] = []
    for where, inner, names in os.walk(folder):
        inner[:] = [name for name in inner if name not in _IGNORED]
        below = os.path.relpath(where, folder).replace(os.sep, "/")
        links = [name for name in inner if os.path.islink(os.path.join(where, name))]
        for name in (*names, *links):
            path = name if below == "." else f"{below}/{name}"
            if path in known or path in folders or name.endswith(".pyc") or name in _IGNORED:
                continue
            is_unfinished = name.startswith(UNFINISHED[0]) and name.endswith(UNFINISHED[1])
            (leftovers if is_unfinished else strays).append(path)
    return tuple(sorted(strays)), tuple(sorted(leftovers))
