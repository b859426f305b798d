"""The stamp of a build: what went in and what came out, by their hashes, so that an unchanged build need not run again.

It lies in the output folder, where git does not look at it. Everything counts that can change the output or what a
build says: the specification and the names of the files beside it, the dialect, codegen itself with its templates, the
installed packages, and the output files. A build that had anything to report leaves no stamp, for it has to report it
again.
"""

import errno
import hashlib
import json
import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from typing import Any

from codegen.emit.folder import leads_outside, other_files
from codegen.frozen import dataclass
from codegen.manifest import MANIFEST
from codegen.template_files import templates_folder

FOLDER = ".codegen"
"""The folder of the stamp below the output folder."""

LISTED = ("", "messages", "dialects", "requirements")
"""The folders of a specification in which codegen looks for files."""

MARGIN_S = 1.0
"""How much older than a build its input has to be: some disks keep times in large steps."""

_OUTPUT = re.compile(rb"""^output:[ \t]*["']?([^"'#\s]+)""", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Unchanged:
    """A build that need not run again: how many files it wrote, and what it read, as ``everything_read`` has it."""

    count: int
    read: tuple[str, ...]


def unchanged(project: str) -> Unchanged | None:
    """The last build of ``project``, if a build would do nothing now; else None."""
    try:
        folder = _likely_output(project)
        with open(os.path.join(folder, FOLDER, "stamp.json"), encoding="utf-8") as file:
            kept = json.load(file)
        outputs = kept["outputs"]
        if kept["project"] != project or kept["inputs"] != _inputs(project, kept["read"], kept["folders"]):
            return None
        if other_files(folder, outputs) != ((), ()):
            return None
        if kept["written"] != _digest(_below(folder, outputs)):
            return None
        return Unchanged(len(outputs) - 1, tuple(everything_read(project, kept["read"], kept["folders"])))
    except (OSError, ValueError, KeyError, TypeError):
        return None


def keep(
    project: str,
    started: float,
    read: Iterable[str],
    folder: str,
    rendered: Mapping[str, str | bytes],
    specifications: Iterable[str],
) -> None:
    """Note a build that had nothing to report: the files ``read`` and what was ``rendered`` into ``folder``.

    ``specifications`` are the folders in which files of the specification, and of further programs, are looked for.
    ``started`` is the time (Unix) before the first file was read: what was written later, or just before, may not be
    what was read, and then nothing is noted. A disk that does not take the stamp costs the next build its time.
    """
    with suppress(OSError):
        read = sorted(read)
        outputs = sorted({*rendered, MANIFEST})
        if _likely_output(project) != folder or not _are_older(_everything_read(project, read), started - MARGIN_S):
            return
        for path, text in rendered.items():
            with open(os.path.join(folder, path), "rb") as file:
                if file.read() != (text.encode() if isinstance(text, str) else text):
                    return
        folders = sorted({os.path.dirname(project), *specifications})
        inputs = _inputs(project, read, folders)
        stamp: dict[str, Any] = {
            "project": project,
            "read": read,
            "folders": folders,
            "inputs": inputs,
            "outputs": outputs,
        }
        stamp["written"] = _digest(_below(folder, outputs))
        where = os.path.join(folder, FOLDER)
        os.makedirs(where, exist_ok=True)
        with open(os.path.join(where, ".gitignore"), "w", encoding="utf-8") as file:
            file.write("*\n")
        unfinished = os.path.join(where, f"stamp.{os.getpid()}")
        with open(unfinished, "w", encoding="utf-8") as file:
            json.dump(stamp, file)
        os.replace(unfinished, os.path.join(where, "stamp.json"))


def _likely_output(project: str) -> str:
    """Where the project file seems to put its output; whether it does is settled by the hash of that file."""
    with open(project, "rb") as file:
        found = _OUTPUT.search(file.read())
    written = os.fsdecode(found[1]) if found else "../generated"
    return os.path.normpath(os.path.join(os.path.dirname(project), written))


def _inputs(project: str, read: Iterable[str], specifications: Iterable[str]) -> str:
    """The hash of what is read, and of the names of what lies beside it and might be read next time."""
    folders = [os.path.join(specification, folder) for specification in specifications for folder in LISTED]
    names = [line for folder in folders for line in (folder, *sorted(_names(folder)))]
    return _digest(_everything_read(project, read), sys.version, *_libraries(), *names)


def everything_read(project: str, read: Iterable[str], specifications: Iterable[str]) -> list[str]:
    """The absolute paths of what decides over the output: files, and folders in which a new file would be read.

    That is the specification, codegen itself and its templates; folders that are not there are left out.
    """
    folders = [os.path.normpath(os.path.join(one, name)) for one in specifications for name in LISTED]
    there = [folder for folder in folders if os.path.isdir(folder)]
    return list(dict.fromkeys([*_everything_read(project, read), *there]))


def tool_files() -> list[str]:
    """The absolute paths of codegen's own files, its templates included."""
    package = os.path.dirname(os.path.abspath(__file__))
    return sorted({*_files(package), *_files(templates_folder())})


def _everything_read(project: str, read: Iterable[str]) -> list[str]:
    return [project, *read, *tool_files()]


def _are_older(paths: Iterable[str], time: float) -> bool:
    return all(os.stat(path).st_mtime < time for path in paths)


def _below(folder: str, paths: Iterable[str]) -> Iterator[str]:
    """The files of the output; OSError for one that is a link, and may lead anywhere."""
    for path in paths:
        full = os.path.join(folder, path)
        if leads_outside(folder, path):
            raise OSError(errno.ELOOP, "a link leads out of the output folder", full)
        yield full


def _libraries() -> list[str]:
    """The installed packages with their versions, by the names of the folders that describe them."""
    found = {name for folder in sys.path for name in _names(folder or ".")}
    return sorted(name for name in found if name.endswith((".dist-info", ".egg-info")))


def _names(folder: str) -> list[str]:
    try:
        return os.listdir(folder)
    except OSError:
        return []


def _files(folder: str) -> Iterator[str]:
    for where, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name != "__pycache__")
        yield from (os.path.join(where, name) for name in sorted(names))


def _digest(paths: Iterable[str], *words: str) -> str:
    digest = hashlib.sha256("\n".join(words).encode("utf-8", "surrogateescape"))
    for path in paths:
        with open(path, "rb") as file:
            content = file.read()
        digest.update(f"\n{path}\n{len(content)}\n".encode("utf-8", "surrogateescape"))
        digest.update(content)
    return digest.hexdigest()
