"""The stamp of a build: what went in and what came out, by their hashes, so that an unchanged build need not run again.

It lies in the output folder, where git does not look at it. Everything counts that can change the output or what a
build says: the specification and every file beside it, the dialect, codegen itself with its templates, the installed
packages, and the output files. A build that had anything to report leaves no stamp, for it has to report it again.
"""

import hashlib
import json
import os
import re
import sys
from collections.abc import Iterable, Iterator
from contextlib import suppress
from typing import Any

from codegen.emit.folder import other_files
from codegen.template_files import templates_folder

FOLDER = ".codegen"
"""The folder of the stamp below the output folder."""

_OUTPUT = re.compile(rb"""^output:[ \t]*["']?([^"'#\s]+)""", re.MULTILINE)


def unchanged(project: str) -> int | None:
    """How many files the last build of ``project`` wrote, if a build would do nothing now; else None."""
    try:
        folder = _likely_output(project)
        with open(os.path.join(folder, FOLDER, "stamp.json"), encoding="utf-8") as file:
            kept = json.load(file)
        outputs = kept["outputs"]
        if kept["project"] != project or kept["inputs"] != _inputs(project, kept["read"]):
            return None
        if other_files(folder, outputs) != ((), ()):
            return None
        paths = [os.path.join(folder, path) for path in outputs]
        return len(outputs) - 1 if kept["written"] == _digest(paths) else None  # the manifest does not count
    except (OSError, ValueError, KeyError, TypeError):
        return None


def keep(project: str, read: Iterable[str], folder: str, outputs: Iterable[str]) -> None:
    """Note a build that had nothing to report: the files ``read``, and ``outputs`` below ``folder``, as they are now.

    A disk that does not take the stamp costs the next build its time, and nothing else.
    """
    with suppress(OSError):
        if _likely_output(project) != folder:
            return
        where = os.path.join(folder, FOLDER)
        read, outputs = sorted(read), sorted(outputs)
        stamp: dict[str, Any] = {"project": project, "read": read, "inputs": _inputs(project, read), "outputs": outputs}
        stamp["written"] = _digest(os.path.join(folder, path) for path in outputs)
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


def _inputs(project: str, read: Iterable[str]) -> str:
    package = os.path.dirname(os.path.abspath(__file__))
    own = [*_files(package), *_files(templates_folder())]
    return _digest([*sorted({*read, *_files(os.path.dirname(project))}), *own], sys.version, *_libraries())


def _libraries() -> list[str]:
    """The installed packages with their versions, by the names of the folders that describe them."""
    found: list[str] = []
    for folder in sys.path:
        with suppress(OSError):
            found += [name for name in os.listdir(folder or ".") if name.endswith((".dist-info", ".egg-info"))]
    return sorted(found)


def _files(folder: str) -> Iterator[str]:
    for where, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name != "__pycache__" and not name.startswith("."))
        yield from (os.path.join(where, name) for name in sorted(names))


def _digest(paths: Iterable[str], *words: str) -> str:
    digest = hashlib.sha256("\n".join(words).encode())
    for path in paths:
        with open(path, "rb") as file:
            content = file.read()
        digest.update(f"\n{path}\n{len(content)}\n".encode())
        digest.update(content)
    return digest.hexdigest()
