"""Files that were decoded before, by this run or an earlier one: while they are as they were, so is what they state.

Only what is right is kept: of what is not, there is something to report every time.
"""

import json
from collections.abc import Callable
from typing import TypeVar, cast

from codegen.cache import entry, keep, keep_object, kept, kept_object, pickled
from codegen.diagnostics import Report
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path
from codegen.load.text import found_at, noting
from codegen.tool import tool_digest

_Stated = TypeVar("_Stated")


def decoded(
    kind: str, content: str | bytes, path: str, decode: Callable[[Report], _Stated | None], report: Report
) -> _Stated | None:
    """What ``decode`` makes of the ``content`` of the file ``path`` (absolute, as places name it).

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
    kind: str, inputs: object, decode: Callable[[Report], _Stated | None], report: Report
) -> tuple[_Stated | None, str]:
    """What ``decode`` returns, which depends on ``inputs``, on which dialects are shipped, and on files that it reads.

    Which files these are shows while it reads them; later they are compared before anything is decoded again. The
    second value is a hash of all that it depends on, which is empty where there was something to report.
    """
    shipped = "\n".join(f"{name} {shipped_dialect_path(name)}" for name in shipped_dialect_names())
    name = entry("files", tool_digest(), kind, pickled(inputs), shipped)
    noted = kept(name)
    if noted is not None and all(found_at(path) == found for path, found in json.loads(noted).items()):
        known = kept_object(digest := entry(name, noted))
        if known is not None:
            return cast(_Stated, known), digest
    new = Report()
    with noting() as files:
        stated = decode(new)
    report.extend(new)
    if stated is None or list(new):
        return stated, ""
    noted = json.dumps(files, sort_keys=True).encode()
    digest = entry(name, noted)
    keep(name, noted)
    keep_object(digest, stated)
    return stated, digest
