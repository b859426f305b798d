"""Files as the stages find them: those of the disk, and those of trees that hang in it while a command runs.

A tree is anything that knows contents by path: a revision of a git repository, an archive. It hangs at an absolute path
that does not exist on the disk, such as ``/project/HEAD~1:``; what lies below it is read from the tree.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

from codegen.load.confined import is_outside


class Tree(Protocol):
    """Files by their path below the tree, with ``/`` between the parts."""

    @property
    def folder(self) -> str | None:
        """The absolute path of the folder of the disk that the tree is a version of, if it is one."""

    @property
    def version(self) -> str:
        """Return what tells its files from those of any other tree, such as the hash of
        a commit; empty where nothing does.
        """

    def holds(self, path: str) -> bool:
        """Return whether there is such a file."""

    def read(self, path: str) -> bytes | None:
        """The content of a file, or None where there is none."""

    def names(self, folder: str) -> tuple[str, ...] | None:
        """The names in a folder (``""`` is the tree itself), sorted, or None where there is none."""


_HUNG: dict[str, Tree] = {}


@contextmanager
def hung(root: str, tree: Tree) -> Iterator[None]:
    """Let ``tree`` hang at the absolute path ``root``."""
    _HUNG[root] = tree
    try:
        yield
    finally:
        del _HUNG[root]


def is_in_tree(path: str) -> bool:
    """Return whether a path lies in a tree, and so not on the disk."""
    return _found(path) is not None


def tree_content(path: str) -> bytes | None:
    """The content of a file of a tree, or None where the path is none."""
    found = _found(path)
    return None if found is None else found[0].read(found[1])


def exists(path: str) -> bool:
    """Return whether there is a file, a folder, or a link, even a broken one."""
    found = _found(path)
    if found is None:
        return os.path.lexists(path)
    return found[0].holds(found[1]) or found[0].names(found[1]) is not None


def is_file(path: str) -> bool:
    """Return whether there is a file, or a link to one."""
    found = _found(path)
    return os.path.isfile(path) if found is None else found[0].holds(found[1])


def file_names(folder: str) -> list[str]:
    """The names in a folder, sorted; none where it cannot be read, or may not be."""
    found = _found(folder)
    if found is not None:
        return list(found[0].names(found[1]) or ())
    if is_outside(folder):
        return []
    try:
        return sorted(os.listdir(folder))
    except OSError:
        return []


def why_not_listed(folder: str) -> str | None:
    """Return why the names in a folder cannot be read; None where they can, and where there is no folder."""
    if _found(folder) is not None or not os.path.lexists(folder):
        return None
    try:
        with os.scandir(folder):
            return None
    except NotADirectoryError:
        return None
    except OSError as problem:
        return problem.strerror or str(problem)


def is_folder(path: str) -> bool:
    """Return whether there is a folder, or a link to one."""
    found = _found(path)
    return os.path.isdir(path) if found is None else found[0].names(found[1]) is not None


def version_of(path: str) -> str:
    """The version of the tree that a path lies in; empty for the disk, whose files may change."""
    found = _found(path)
    return "" if found is None else found[0].version


def on_disk(path: str) -> str:
    """The path of the file of the disk that a file of a tree is a version of; any other path as it is."""
    found = _found(path)
    if found is None or found[0].folder is None:
        return path
    return os.path.join(found[0].folder, *found[1].split("/"))


def _found(path: str) -> tuple[Tree, str] | None:
    """The tree that a path lies in, and the path below it."""
    for root, tree in _HUNG.items():
        if path == root or path.startswith(root + os.sep):
            return tree, path[len(root) + 1 :].replace(os.sep, "/")
    return None
