"""Codegen itself as an input: its own files, its templates, and the Python and the packages that it runs on."""

import hashlib
import os
import sys
import time
from collections.abc import Iterable, Iterator
from functools import cache

from codegen.tool.cache import entry, has_new, keep, kept, write_new
from codegen.tool.pattern_codes import keep_new_codes
from codegen.tool.template_files import templates_folder

SETTLED_NS = 3_000_000_000
"""The age of a file's last change from which its times tell it from its state after another one: some disks keep times
in steps of two seconds.
"""


def tool_files() -> list[str]:
    """The absolute paths of codegen's own files, its templates included."""
    return [path for path, _ in _found_files()]


@cache
def tool_digest() -> str:
    """The hash of everything that decides what codegen makes of its input.

    Reading all files takes longer than a build that has nothing to do. So the hash is kept under the times, sizes and
    numbers of the files, which the system changes with each of them; but not while one of them has just changed.
    """
    found = _files_at_start()
    name = entry("tool", surroundings(), *(f"{path}\n{signature}" for path, signature in found))
    known = kept(name)
    if known is not None:
        return known.decode()
    now = time.time_ns()
    digest = content_digest((path for path, _ in found), surroundings())
    if all(_is_settled(path, now) for path, _ in found):
        keep(name, digest.encode())
    return digest


def keep_what_is_new() -> None:
    """Let later runs have what this one found out, unless codegen was changed meanwhile: what made it is not known."""
    keep_new_codes()
    if has_new() and _files_at_start() == _found_files():
        write_new()


def content_digest(paths: Iterable[str], *words: str) -> str:
    """The hash of words and of the names and contents of files."""
    return digest_of(_contents(paths), *words)


def digest_of(contents: Iterable[tuple[str, bytes | str]], *words: str) -> str:
    """The same for contents that need not be read."""
    digest = hashlib.sha256("\n".join(words).encode("utf-8", "surrogateescape"))
    for path, text in contents:
        content = text.encode() if isinstance(text, str) else text
        digest.update(f"\n{path}\n{len(content)}\n".encode("utf-8", "surrogateescape"))
        digest.update(content)
    return digest.hexdigest()


def _contents(paths: Iterable[str]) -> Iterator[tuple[str, bytes]]:
    for path in paths:
        with open(path, "rb") as file:
            yield path, file.read()


def names_in(folder: str) -> list[str]:
    """The names in a folder; none where it cannot be read."""
    try:
        return os.listdir(folder)
    except OSError:
        return []


@cache
def surroundings() -> str:
    """The version of Python and the installed packages, by the names of the folders that describe them."""
    found = {name for folder in sys.path for name in names_in(folder or ".")}
    return "\n".join([sys.version, *sorted(name for name in found if name.endswith((".dist-info", ".egg-info")))])


@cache
def _files_at_start() -> list[tuple[str, str]]:
    return _found_files()


def _found_files() -> list[tuple[str, str]]:
    """The path and the signature of each of codegen's own files, sorted."""
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    found: dict[str, str] = {}
    open_folders = [package, templates_folder()]
    while open_folders:
        with os.scandir(open_folders.pop()) as files:
            for file in files:
                if file.is_dir():
                    if file.name != "__pycache__":
                        open_folders.append(file.path)
                else:
                    of = file.stat()
                    found[file.path] = f"{of.st_size} {of.st_mtime_ns} {of.st_ctime_ns} {of.st_dev} {of.st_ino}"
    return sorted(found.items())


def _is_settled(path: str, now: int) -> bool:
    of = os.stat(path)
    return max(of.st_mtime_ns, of.st_ctime_ns) < now - SETTLED_NS
