"""Files that were decoded before, by this run or an earlier one: while they are as they were, so is what they state.

Only what is right is kept: of what is not, there is something to report every time.
"""

import json
from collections.abc import Callable
from typing import TypeVar, cast

from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path
from codegen.tool.cache import entry, keep, keep_object, kept, kept_object, pickled
from codegen.tool.digest import tool_digest

_Stated = TypeVar("_Stated")


def decoded(
    kind: str, content: str | bytes, path: str, decode: Callable[[Report], _Stated | None], report: Report
) -> _Stated | None:
    """Return what ``decode`` makes of the ``content`` of the file ``path`` (absolute, as places name it).

    ``decode`` depends on nothing else, and ``kind`` tells it from others.
    """
    name = entry("decoded", tool_digest(), kind, path, content)
    known = kept_object(name)
    if known is not None:
        return cast(_Stated, known)
    found = Report()
    stated = decode(found)
    if stated is not None and not list(found):
        keep_object(name, stated)
    report.extend(found)
    return stated


def decoded_with_includes(
    kind: str, inputs: object, decode: Callable[[Files, Report], _Stated | None], files: Files, report: Report
) -> tuple[_Stated | None, str]:
    """Return what ``decode`` returns, which depends on ``inputs``, on which dialects are shipped, and on files that it
    reads.

    Which files these are shows while it reads them; later they are compared before anything is decoded again. The
    second value is a hash of all that it depends on, which is empty where there was something to report.
    """
    name = _name(kind, inputs, files)
    digest = _digest(name, {}, files)
    known = None if digest is None else kept_object(digest)
    if known is not None:
        return cast(_Stated, known), digest or ""
    new = Report()
    noting, read = files.noting()
    stated = decode(noting, new)
    report.extend(new)
    if stated is None or list(new):
        return stated, ""
    return stated, _keep(name, read, stated)


def with_files_read(inputs: object, find: Callable[[Files], _Stated], seen: dict[str, str], files: Files) -> _Stated:
    """Return what ``find`` returns, whether it is good or bad; it depends on the same things.

    ``seen`` has by path what was found at files that were compared before, for whoever asks often.
    """
    name = _name("found", inputs, files)
    digest = _digest(name, seen, files)
    known = None if digest is None else kept_object(digest)
    if known is not None:
        return cast(_Stated, known)
    noting, read = files.noting()
    found = find(noting)
    _keep(name, read, found)
    return found


def _name(kind: str, inputs: object, files: Files) -> str:
    """The name under which the files are noted that were read for something."""
    shipped = "\n".join(f"{name} {shipped_dialect_path(name, files)}" for name in shipped_dialect_names(files))
    return entry("files", tool_digest(), kind, pickled(inputs), shipped)


def _digest(name: str, seen: dict[str, str], files: Files) -> str | None:
    """The name of what was made of the noted files, if all of them are as they were; else None."""
    noted = kept(name)
    if noted is None:
        return None
    for path, found in json.loads(noted).items():
        if path in seen:
            files.note({path: seen[path]})
        else:
            seen[path] = files.found_at(path)
        if seen[path] != found:
            return None
    return entry(name, noted)


def _keep(name: str, read: dict[str, str], made: object) -> str:
    """Keep what was made of files; returns its name."""
    noted = json.dumps(read, sort_keys=True).encode()
    keep(name, noted)
    digest = entry(name, noted)
    keep_object(digest, made)
    return digest
