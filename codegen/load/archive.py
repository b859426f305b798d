"""A wheel or a source archive as a tree: its files are read where they are, and nothing is unpacked."""

import lzma
import os
import posixpath
import re
import tarfile
import zipfile
import zlib
from collections.abc import Iterable
from contextlib import suppress

from codegen.load.text import MAX_BYTES

_DAMAGE = (
    OSError,
    EOFError,
    RuntimeError,
    ValueError,
    zipfile.BadZipFile,
    tarfile.TarError,
    zlib.error,
    lzma.LZMAError,
)


class ArchiveTree:
    """The files of an archive, each of at most MAX_BYTES."""

    folder = None
    version = ""

    def __init__(self, contents: dict[str, bytes]) -> None:
        self._contents = contents
        self._folders: dict[str, set[str]] = {}
        for path in contents:
            folder, name = posixpath.split(path)
            self._folders.setdefault(folder, set()).add(name)
            while folder:
                folder, name = posixpath.split(folder)
                self._folders.setdefault(folder, set()).add(name)

    def holds(self, path: str) -> bool:
        """Return whether there is such a file."""
        return path in self._contents

    def read(self, path: str) -> bytes | None:
        """The content of a file, or None where there is none."""
        return self._contents.get(path)

    def names(self, folder: str) -> tuple[str, ...] | None:
        """The names in a folder, sorted; None where there is none."""
        names = self._folders.get(folder)
        return None if names is None else tuple(sorted(names))

    def paths(self) -> Iterable[str]:
        """The path of every file."""
        return self._contents.keys()


def read_archive(path: str, wanted: re.Pattern[str]) -> ArchiveTree | str:
    """The files of an archive whose paths match, or why it cannot be read."""
    try:
        if zipfile.is_zipfile(path):
            return ArchiveTree(_zipped(path, wanted))
        return ArchiveTree(_tarred(path, wanted))
    except _DAMAGE:
        return f"{os.path.basename(path)} is no archive that can be read"


def _is_wanted(name: str, wanted: re.Pattern[str]) -> bool:
    """Return whether the name matches, and lies below the tree: an absolute one, or
    one with ``..``, is of no release.
    """
    return bool(wanted.search(name)) and not name.startswith("/") and ".." not in name.split("/")


def _zipped(path: str, wanted: re.Pattern[str]) -> dict[str, bytes]:
    with zipfile.ZipFile(path) as archive:
        return {
            member.filename: archive.read(member)
            for member in archive.infolist()
            if _is_wanted(member.filename, wanted) and member.file_size <= MAX_BYTES
        }


def _tarred(path: str, wanted: re.Pattern[str]) -> dict[str, bytes]:
    contents = {}
    with tarfile.open(path) as archive:
        for member in archive:
            if member.isfile() and _is_wanted(member.name, wanted) and member.size <= MAX_BYTES:
                with suppress(KeyError):
                    file = archive.extractfile(member)
                    contents[member.name.removeprefix("./")] = file.read() if file else b""
    return contents
