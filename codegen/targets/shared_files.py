"""The layout of the output: modules that all programs of a project have alike lie once, in a common folder."""

import os
import re
from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.program_folders import COMMON, SHARED_PARTS
from codegen.targets.origin import united

_SHAREABLE = re.compile(rf"({'|'.join(SHARED_PARTS)})/(?!conftest|test_)[^/]+\.py")
"""Modules. Tests stay with each program, since pytest looks for them in the folder that it is given, and so does what
they expect, which is data."""


@dataclass(frozen=True, slots=True)
class Output:
    """The files of an output folder, by path.

    ``shared`` has, for each file that programs share, the path that it would have in each of them -> the one that it
    has. ``vacated`` are the folders, each with a slash at its end, in which nothing of an earlier build may be left:
    what lies there is imported, or run, because it is there.
    """

    files: Mapping[str, str]
    shared: Mapping[str, str]
    vacated: tuple[str, ...]


def laid_out(programs: Mapping[str, Mapping[str, str]]) -> Output:
    """Return where the files of all programs go; ``programs`` are the texts of each by path, by its name.

    A further program goes to the folder of its name, and what all of them have to the common folder.
    """
    common = _common([*programs.values()])
    own = {
        os.path.join(name, path): text
        for name, files in programs.items()
        for path, text in files.items()
        if path not in common
    }
    shared = {os.path.join(name, path): os.path.join(COMMON, path) for name in programs for path in common}
    return Output(
        files=own | {os.path.join(COMMON, path): text for path, text in common.items()},
        shared=shared,
        vacated=tuple(os.path.join(name, part, "") for name in (*programs, COMMON) for part in SHARED_PARTS),
    )


def _common(programs: list[Mapping[str, str]]) -> dict[str, str]:
    """The files that all of several programs have, but for the sources that their headers tell, by path."""
    if len(programs) < 2:
        return {}
    paths = [path for path in programs[0] if _SHAREABLE.fullmatch(path)]
    found = {
        path: united([files[path] for files in programs]) for path in paths if all(path in files for files in programs)
    }
    return {path: text for path, text in found.items() if text is not None}
