"""Files as a command finds them: those of the disk, and those of trees that hang in it.

A tree hangs at an absolute path that does not exist on the disk, such as ``/project/HEAD~1:``; what lies below it is
read from the tree. A command makes a ``Files`` of what it is about, and hands it to all that reads: nothing is global.
"""

import hashlib
import os
import stat
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import TypeVar

from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.load.bounds import Bounds
from codegen.load.text import (
    FILE_NOT_FOUND,
    FILE_NOT_READABLE,
    FILE_TOO_LARGE,
    MAX_BYTES,
    OUTSIDE_PROJECT,
    decode_text,
    real_path,
)
from codegen.load.tree import Tree
from codegen.source import Place, shown_path

_Found = TypeVar("_Found")


@dataclass(frozen=True, slots=True)
class Files:
    """The files that a command can read: the disk within ``bounds`` (None: all of it), and ``trees`` by their roots.

    ``notes`` get by path a hash of each file that is read. ``dialects`` are the XML files by the names of dialects that
    take the place of those of the installed pymavlink.
    """

    trees: tuple[tuple[str, Tree], ...] = ()
    bounds: Bounds | None = None
    notes: tuple[dict[str, str], ...] = ()
    dialects: Mapping[str, str] | None = None

    def with_tree(self, root: str, tree: Tree) -> "Files":
        """Return these files with ``tree`` hanging at the absolute path ``root``."""
        return replace(self, trees=(*self.trees, (root, tree)))

    def confined(self, folders: Iterable[str]) -> "Files":
        """Return these files of which only those below ``folders`` may be read, wherever links lead."""
        return replace(self, bounds=Bounds(tuple(sorted({os.path.realpath(folder) for folder in folders}))))

    def with_dialects(self, dialects: Mapping[str, str]) -> "Files":
        """Return these files with other dialects that are shipped, by name the absolute paths of their XML files."""
        return replace(self, dialects=dialects)

    def noting(self) -> "tuple[Files, dict[str, str]]":
        """Return files that note what is read from them, and the notes: paths with a hash of what was found there."""
        found: dict[str, str] = {}
        return replace(self, notes=(*self.notes, found)), found

    def note(self, found: Mapping[str, str]) -> None:
        """Note what was read before, in place of whoever asks now."""
        for noted in self.notes:
            noted.update(found)

    def is_in_tree(self, path: str) -> bool:
        """Return whether a path lies in a tree, and so not on the disk."""
        return self._in_tree(path) is not None

    def exists(self, path: str) -> bool:
        """Return whether there is a file, a folder, or a link, even a broken one."""
        found = self._in_tree(path)
        if found is None:
            return os.path.lexists(path)
        return found[0].holds(found[1]) or found[0].names(found[1]) is not None

    def is_file(self, path: str) -> bool:
        """Return whether there is a file, or a link to one."""
        found = self._in_tree(path)
        return os.path.isfile(path) if found is None else found[0].holds(found[1])

    def is_folder(self, path: str) -> bool:
        """Return whether there is a folder, or a link to one."""
        found = self._in_tree(path)
        return os.path.isdir(path) if found is None else found[0].names(found[1]) is not None

    def names(self, folder: str, report: Report) -> list[str]:
        """Return the names in a folder, sorted; none where there is no folder, or after a finding that says why."""
        found = self._in_tree(folder)
        if found is not None:
            return list(found[0].names(found[1]) or ())
        place = Place(os.path.abspath(folder))
        if self.is_refused(folder, place, report):
            return []
        try:
            return sorted(os.listdir(folder))
        except (FileNotFoundError, NotADirectoryError):
            return []
        except (OSError, ValueError) as problem:
            why = getattr(problem, "strerror", None) or str(problem)
            report.add(FILE_NOT_READABLE, place, f"the folder {shown_path(folder)} cannot be read: {why}")
            return []

    def version_of(self, path: str) -> str:
        """Return the version of the tree that a path lies in; empty for the disk, whose files may change."""
        found = self._in_tree(path)
        return "" if found is None else found[0].version

    def on_disk(self, path: str) -> str:
        """Return the path of the file of the disk that a file of a tree is a version of; any other path as it is."""
        found = self._in_tree(path)
        if found is None or found[0].folder is None:
            return path
        return os.path.join(found[0].folder, *found[1].split("/"))

    def is_refused(self, path: str, place: Place, report: Report) -> bool:
        """Return whether a file or a folder of the disk lies where nothing may be read; then a finding says so."""
        if self.bounds is None or self.is_in_tree(path) or not self.bounds.are_left_by(path):
            return False
        hint = "if it is meant, list its folder in codegen.yaml (outside: [...]), or be in a folder above both"
        report.add(OUTSIDE_PROJECT, place, f"{shown_path(path)} lies outside of the project", hint)
        return True

    def read_text(self, path: str, report: Report, asked_at: Place | None = None) -> str | None:
        """Return the text of a file, as ``read_bytes`` and ``decode_text`` read it; None after a diagnostic."""
        data = self.read_bytes(path, report, asked_at)
        return None if data is None else decode_text(data, path, report)

    def read_bytes(
        self, path: str, report: Report, asked_at: Place | None = None, most: int | None = None
    ) -> bytes | None:
        """Return the content of a regular file of at most ``most`` bytes (default: ``MAX_BYTES``).

        None after a diagnostic. ``asked_at`` is the place that names the file: a missing or unreadable file is reported
        there, or at the file itself where nothing names it.
        """
        content = self._content(
            path, report, asked_at or Place(os.path.abspath(path)), MAX_BYTES if most is None else most
        )
        for noted in self.notes:
            noted[path] = self._hash(path, content)
        return content

    def found_at(self, path: str) -> str:
        """Return the hash of what is at a path: of the file that it leads to and its content, or that there is none."""
        return self._hash(path, self.read_bytes(path, Report()))

    def _hash(self, path: str, content: bytes | None) -> str:
        if content is None:
            return ""
        real = real_path(path) if self.bounds is None else real_path(path, self.bounds.real_path)
        return hashlib.sha256(f"{real}\n".encode("utf-8", "surrogateescape") + content).hexdigest()

    def _content(self, path: str, report: Report, place: Place, most: int) -> bytes | None:
        found = self._in_tree(path)
        if found is not None:
            content = found[0].read(found[1])
            if content is None:
                report.add(FILE_NOT_FOUND, place, f"{shown_path(path)} does not exist")
            return content
        if self.is_refused(path, place, report):
            return None
        return _content_on_disk(path, report, place, most)

    def _in_tree(self, path: str) -> tuple[Tree, str] | None:
        """Return the tree that a path lies in, and the path below it."""
        for root, tree in self.trees:
            if path == root or path.startswith(root + os.sep):
                return tree, path[len(root) + 1 :].replace(os.sep, "/")
        return None


DISK = Files()
"""The files of the disk, and all of them."""


def asked_once(find: Callable[[Files], _Found]) -> Callable[[Files], _Found]:
    """Return what asks ``find`` only once. Files that note get, with a later question, what was read at the first."""
    known: list[tuple[_Found, dict[str, str]]] = []

    def found(files: Files) -> _Found:
        if not known:
            noting, read = files.noting()
            known.append((find(noting), read))
        else:
            files.note(known[0][1])
        return known[0][0]

    return found


def _content_on_disk(path: str, report: Report, place: Place, most: int) -> bytes | None:
    try:
        # Looking first keeps a pipe or a device from blocking the run.
        mode = os.stat(path).st_mode
        if not stat.S_ISREG(mode):
            kind = "a folder" if stat.S_ISDIR(mode) else "a device or a pipe"
            report.add(FILE_NOT_READABLE, place, f"{shown_path(path)} is {kind}, not a file")
            return None
        with open(path, "rb") as file:
            data = file.read(most + 1)
    except (FileNotFoundError, NotADirectoryError):
        if os.path.islink(path):
            message = f"{shown_path(path)} is a link to {os.readlink(path)}, which does not exist"
            report.add(FILE_NOT_FOUND, place, message, "let it lead to a file, or remove the link")
        else:
            report.add(FILE_NOT_FOUND, place, f"{shown_path(path)} does not exist")
        return None
    except PermissionError:
        report.add(FILE_NOT_READABLE, place, f"{shown_path(path)} may not be read", "check the permissions of the file")
        return None
    except (OSError, ValueError) as problem:  # ValueError: a name with a NUL or a lone surrogate
        reason = getattr(problem, "strerror", None) or str(problem)
        report.add(FILE_NOT_READABLE, place, f"{shown_path(path)!r} cannot be read: {reason}")
        return None
    if len(data) > most:
        report.add(FILE_TOO_LARGE, place, f"{shown_path(path)} is larger than {most // 1_000_000} MB")
        return None
    return data
