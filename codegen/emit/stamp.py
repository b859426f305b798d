"""The stamp of a build: what went in and what came out, by their hashes, so that an unchanged build need not run again.

It lies in the output folder, where git does not look at it. Everything counts that can change the output or what a
build says: the specification and the names of the files beside it, the dialect, codegen itself with its templates, the
installed packages, and the output files. A build that had anything to report leaves no stamp, for it has to report it
again.
"""

import errno
import json
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress

from codegen.emit.folder import MANIFEST, OWN_FOLDER, link_outside, other_files
from codegen.tool.digest import content_digest, digest_of, names_in, tool_digest, tool_files

TYPE_CHECKING = False  # a build with nothing to do takes too little time to import typing in it
if TYPE_CHECKING:
    from typing import Any

LISTED = ("", "messages", "receives", "dialects", "requirements")
"""The folders of a specification in which codegen looks for files."""

MARGIN_S = 1.0
"""The least age of a build's input at the build: some disks keep times in large steps."""


def unchanged(project: str, folder: str) -> int | None:
    """Return how many files the last build of ``project`` wrote into ``folder``, or None where a build may do more."""
    try:
        kept = _kept(folder)
        outputs = kept["outputs"]
        if kept["project"] != project or kept["inputs"] != _inputs(project, kept["read"], kept["folders"]):
            return None
        if other_files(folder, outputs) != ((), ()):
            return None
        if kept["written"] != content_digest(_below(folder, outputs)):
            return None
        return len(outputs) - 1
    except (OSError, ValueError, KeyError, TypeError):
        return None


def read_last_time(project: str, folder: str) -> list[str]:
    """Return what that build read, as ``everything_read`` has it. May raise OSError."""
    kept = _kept(folder)
    return everything_read(project, kept["read"], kept["folders"])


def _kept(folder: str) -> "dict[str, Any]":
    """The stamp of an output folder. May raise OSError and ValueError."""
    with open(os.path.join(folder, OWN_FOLDER, "stamp.json"), encoding="utf-8") as file:
        found: dict[str, Any] = json.load(file)
    return found


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
    with suppress(OSError, ValueError):
        read = sorted(read)
        outputs = sorted({*rendered, MANIFEST})
        if not _are_older([project, *read], started - MARGIN_S):
            return
        with open(os.path.join(folder, MANIFEST), "rb") as file:
            contents = {**rendered, MANIFEST: file.read()}
        written = content_digest(_below(folder, outputs))
        if written != digest_of((os.path.join(folder, path), contents[path]) for path in outputs):
            return
        folders = sorted({os.path.dirname(project), *specifications})
        inputs = _inputs(project, read, folders)
        stamp: dict[str, object] = {
            "project": project,
            "read": read,
            "folders": folders,
            "inputs": inputs,
            "outputs": outputs,
        }
        stamp["written"] = written
        where = os.path.join(folder, OWN_FOLDER)
        os.makedirs(where, exist_ok=True)
        with open(os.path.join(where, ".gitignore"), "w", encoding="utf-8") as file:
            file.write("*\n")
        unfinished = os.path.join(where, f"stamp.{os.getpid()}")
        with open(unfinished, "w", encoding="utf-8") as file:
            json.dump(stamp, file)
        os.replace(unfinished, os.path.join(where, "stamp.json"))


def _inputs(project: str, read: Iterable[str], specifications: Iterable[str]) -> str:
    """The hash of what is read, and of the names of what lies beside it and might be read next time."""
    folders = [os.path.join(specification, folder) for specification in specifications for folder in LISTED]
    names = [line for folder in folders for line in (folder, *sorted(names_in(folder)))]
    return content_digest([project, *read], tool_digest(), *names)


def everything_read(project: str, read: Iterable[str], specifications: Iterable[str]) -> list[str]:
    """The absolute paths of what decides over the output: files, and folders in which a new file would be read.

    That is the specification, codegen itself and its templates; folders that are not there are left out.
    """
    folders = [os.path.normpath(os.path.join(one, name)) for one in specifications for name in LISTED]
    there = [folder for folder in folders if os.path.isdir(folder)]
    return list(dict.fromkeys([project, *read, *tool_files(), *there]))


def _are_older(paths: Iterable[str], time: float) -> bool:
    return all(os.stat(path).st_mtime < time for path in paths)


def _below(folder: str, paths: Iterable[str]) -> Iterator[str]:
    """The files of the output; OSError for one that is a link, and may lead anywhere."""
    for path in paths:
        full = os.path.join(folder, path)
        if link_outside(folder, path):
            raise OSError(errno.ELOOP, "a link leads out of the output folder", full)
        yield full
