"""Reading a source file into bytes or text; whatever is wrong with the file becomes a diagnostic with a place."""

import hashlib
import os
import re
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeVar

from codegen.diagnostics import Report, Rule
from codegen.load.confined import is_outside
from codegen.load.trees import is_in_tree, tree_content
from codegen.source import Place, shown_path

MAX_BYTES = 10_000_000
"""Largest file that is read, in bytes: a specification stays far below it, a mistaken path may not."""

FILE_NOT_FOUND = Rule(
    "file-not-found",
    "A file that the specification needs does not exist. Create it, or correct the path that names it.",
    unreadable=True,
)
FILE_NOT_READABLE = Rule(
    "file-not-readable",
    "The path exists but cannot be read as a file: it is a folder or a device, or its permissions forbid it.",
    unreadable=True,
)
FILE_NOT_UTF8 = Rule(
    "file-not-utf8",
    "Specifications are UTF-8 text. The place is the first byte that is not; save the file as UTF-8.",
    unreadable=True,
)
FILE_TOO_LARGE = Rule(
    "file-too-large",
    "The file is far larger than any specification. Check that the path names the intended file.",
    unreadable=True,
)

OUTSIDE_PROJECT = Rule(
    "outside-project",
    "A path of the specification leads out of the project: out of the folder above that of codegen.yaml, by its own or "
    "by a link. Nothing there is read, so that no report quotes a file that is not the project's. Where it is meant, "
    "list the folder under outside in codegen.yaml.",
    unreadable=True,
)

_LINE_END = re.compile(rb"\r\n?|\n")
_BYTE_ORDER_MARK = b"\xef\xbb\xbf"
_UTF16_MARKS = (b"\xff\xfe", b"\xfe\xff")

_Found = TypeVar("_Found")

_noted: list[dict[str, str]] = []


@contextmanager
def noting() -> Iterator[dict[str, str]]:
    """Collect which files are read meanwhile: their paths with a hash of what was found there."""
    found: dict[str, str] = {}
    _noted.append(found)
    try:
        yield found
    finally:
        _noted[:] = [noted for noted in _noted if noted is not found]  # another one may be equal


def asked_once(find: Callable[[], _Found]) -> Callable[[], _Found]:
    """Return what asks ``find`` only once.

    Whoever notes files at a later question gets those that were read at the first.
    """
    known: list[tuple[_Found, dict[str, str]]] = []

    def found() -> _Found:
        if not known:
            with noting() as files:
                made = find()
            known.append((made, files))
        made, files = known[0]
        for noted in _noted:
            noted.update(files)
        return made

    return found


def found_at(path: str) -> str:
    """The hash of what is found at a path: of the file that it leads to and of its content, or that there is none."""
    return _found_at(path, read_bytes(path, Report()))


def _found_at(path: str, content: bytes | None) -> str:
    if content is None:
        return ""
    return hashlib.sha256(f"{real_path(path)}\n".encode("utf-8", "surrogateescape") + content).hexdigest()


def real_path(path: str) -> str:
    """Return what makes two paths the same file, whatever links lead there."""
    try:
        return os.path.realpath(path)
    except (OSError, ValueError):
        return path


def read_bytes(path: str, report: Report, asked_at: Place | None = None, most: int | None = None) -> bytes | None:
    """The content of a regular file of at most ``most`` bytes (default: ``MAX_BYTES``), or None after a diagnostic.

    ``asked_at`` is the place that names the file: a missing or unreadable file is reported there, or at the file
    itself where nothing names it.
    """
    content = _read_bytes(path, report, asked_at, most)
    for noted in _noted:
        noted[path] = _found_at(path, content)
    return content


def _read_bytes(path: str, report: Report, asked_at: Place | None, most: int | None) -> bytes | None:
    most = MAX_BYTES if most is None else most
    place = asked_at or Place(os.path.abspath(path))
    shown = shown_path(path)
    if is_in_tree(path):
        content = tree_content(path)
        if content is None:
            report.add(FILE_NOT_FOUND, place, f"{shown} does not exist")
        return content
    if is_refused(path, place, report):
        return None
    try:
        # Looking first keeps a pipe or a device from blocking the run.
        mode = os.stat(path).st_mode
        if not stat.S_ISREG(mode):
            kind = "a folder" if stat.S_ISDIR(mode) else "a device or a pipe"
            report.add(FILE_NOT_READABLE, place, f"{shown} is {kind}, not a file")
            return None
        with open(path, "rb") as file:
            data = file.read(most + 1)
    except (FileNotFoundError, NotADirectoryError):
        report.add(FILE_NOT_FOUND, place, f"{shown} does not exist")
        return None
    except PermissionError:
        report.add(FILE_NOT_READABLE, place, f"{shown} may not be read", "check the permissions of the file")
        return None
    except (OSError, ValueError) as problem:  # ValueError: a name with a NUL or a lone surrogate
        reason = getattr(problem, "strerror", None) or str(problem)
        report.add(FILE_NOT_READABLE, place, f"{shown!r} cannot be read: {reason}")
        return None
    if len(data) > most:
        report.add(FILE_TOO_LARGE, place, f"{shown} is larger than {most // 1_000_000} MB")
        return None
    return data


def is_refused(path: str, place: Place, report: Report) -> bool:
    """Return whether a file or a folder of the disk lies where nothing may be read; then a finding says so."""
    if is_in_tree(path) or not is_outside(path):
        return False
    hint = "if it is meant, list its folder in codegen.yaml: outside: [...]"
    report.add(OUTSIDE_PROJECT, place, f"{shown_path(path)} lies outside of the project", hint)
    return True


def decode_text(data: bytes, path: str, report: Report) -> str | None:
    """``data`` as UTF-8 text, or None after a diagnostic at the first byte that is not UTF-8."""
    start = len(_BYTE_ORDER_MARK) if data.startswith(_BYTE_ORDER_MARK) else 0
    try:
        return data[start:].decode("utf-8")
    except UnicodeDecodeError as problem:
        position = start + problem.start
        hint = "save the file as UTF-8"
        if data.startswith(_UTF16_MARKS):
            hint = "the file looks like UTF-16; save it as UTF-8"
        place = _place_of_byte(data, start, position, os.path.abspath(path))
        report.add(FILE_NOT_UTF8, place, f"byte 0x{data[position]:02x} is not UTF-8", hint)
        return None


def read_text(path: str, report: Report, asked_at: Place | None = None) -> str | None:
    """The text of a file, as ``read_bytes`` and ``decode_text`` read it; None after a diagnostic."""
    data = read_bytes(path, report, asked_at)
    return None if data is None else decode_text(data, path, report)


def _place_of_byte(data: bytes, start: int, position: int, path: str) -> Place:
    """The line and column (in characters, as editors count) of a byte; everything before it is valid UTF-8."""
    line, line_start = 1, start
    for line_end in _LINE_END.finditer(data, start, position):
        line, line_start = line + 1, line_end.end()
    return Place(path, line, len(data[line_start:position].decode("utf-8")) + 1)
