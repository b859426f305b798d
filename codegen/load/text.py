"""Reads source files as text: whatever is wrong with one becomes a diagnostic with a place."""

import os
import re
from collections.abc import Callable

from codegen.conflict import line_of_conflict
from codegen.diagnostics import Report, Rule
from codegen.source import Place

MAX_BYTES = 10_000_000
"""Largest file that is read, in bytes: a specification stays far below it, a mistaken path may not."""

FILE_NOT_FOUND = Rule(
    "file-not-found",
    "A file that the specification needs does not exist. Create it, or correct the path that names it.",
    unreadable=True,
    remedy="create it, or correct the path that names it",
)
FILE_NOT_READABLE = Rule(
    "file-not-readable",
    "The path exists but cannot be read as a file: it is a folder or a device, or its permissions forbid it.",
    unreadable=True,
    remedy="name what can be read, or give yourself the right to read it",
)
FILE_NOT_UTF8 = Rule(
    "file-not-utf8",
    "Specifications are UTF-8 text. The place is the first byte that is not; save the file as UTF-8.",
    unreadable=True,
)
OPEN_CONFLICT = Rule(
    "open-conflict",
    "Git has left both sides of a conflict in the file, between lines that begin with <<<<<<<, ======= and >>>>>>>. "
    "Nothing of it is read: a requirement would have the markers in its text, and a table both values. Take what is "
    "meant of both sides, and remove these three lines.",
    unreadable=True,
    remedy="take what is meant of both sides, and remove the lines with <<<<<<<, ======= and >>>>>>>",
)
FILE_TOO_LARGE = Rule(
    "file-too-large",
    "The file is far larger than any specification. Check that the path names the intended file.",
    unreadable=True,
    remedy="name the file that is meant: no specification is so large",
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


def real_path(path: str, follow: Callable[[str], str] = os.path.realpath) -> str:
    """Return what makes two paths the same file, whatever links lead there; ``follow`` follows them."""
    try:
        return follow(path)
    except (OSError, ValueError):
        return path


def decode_text(data: bytes, path: str, report: Report) -> str | None:
    """``data`` as UTF-8 text; None after a diagnostic at the first byte that is not UTF-8, or at an open conflict."""
    start = len(_BYTE_ORDER_MARK) if data.startswith(_BYTE_ORDER_MARK) else 0
    try:
        text = data[start:].decode("utf-8")
    except UnicodeDecodeError as problem:
        position = start + problem.start
        hint = "save the file as UTF-8"
        if data.startswith(_UTF16_MARKS):
            hint = "the file looks like UTF-16; save it as UTF-8"
        place = _place_of_byte(data, start, position, os.path.abspath(path))
        report.add(FILE_NOT_UTF8, place, f"byte 0x{data[position]:02x} is not UTF-8", hint)
        return None
    line = line_of_conflict(text)
    if line is not None:
        report.add(OPEN_CONFLICT, Place(os.path.abspath(path), line), "a conflict of a merge is open here")
        return None
    return text


def _place_of_byte(data: bytes, start: int, position: int, path: str) -> Place:
    """The line and column (in characters, as editors count) of a byte; everything before it is valid UTF-8."""
    line, line_start = 1, start
    for line_end in _LINE_END.finditer(data, start, position):
        line, line_start = line + 1, line_end.end()
    return Place(path, line, len(data[line_start:position].decode("utf-8")) + 1)
