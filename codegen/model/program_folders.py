"""The folders of a program: one of its own and, where a project has several programs, one that is common to them.

The firmware asks with ``try: import x`` whether a module is there. So the common folder has only what all programs of
the project have alike, and a program looks into its own folder first.
"""

import os

from codegen.frozen import dataclass
from codegen.model.spec.spec import Spec

COMMON = "common"
"""The folder of the output in which the files lie that all programs of a project have alike."""

SPECIFICATION_FOLDERS = ("messages", "receives", "dialects", "requirements")
"""The folders beside a project file in which files of the specification lie."""

SHARED_PARTS = ("firmware", "mocks", "tests")
"""The folders of a program that it may share files of; its pages and its receiver are complete in its own folder."""


@dataclass(frozen=True, slots=True)
class ProgramFolders:
    """The folders of a program: ``own`` is its output folder, ``common`` that of all programs, None for one alone."""

    own: str
    common: str | None = None

    @property
    def all(self) -> tuple[str, ...]:
        """The folders in the order in which a file of the program is looked for."""
        return (self.own,) if self.common is None else (self.own, self.common)

    def of(self, *parts: str) -> tuple[str, ...]:
        """Return the folders of parts, such as ``firmware``, for a path of modules: those of the first part first."""
        return tuple(os.path.join(folder, part) for part in parts for folder in self.all)

    def find(self, *path: str) -> str | None:
        """Return where a file of the program lies, None where it has none of that path below its folders."""
        places = (os.path.join(folder, *path) for folder in self.all)
        return next((place for place in places if os.path.isfile(place)), None)


def program_folders(output: str, program: str = "", *, has_common: bool = True) -> ProgramFolders:
    """Return the folders of a program below ``output``, the output folder of its project.

    ``program`` is the name of a further program, empty for the project's own. Several programs ``has_common``: there
    is a folder of what they share.
    """
    own = os.path.join(output, program) if program else output
    return ProgramFolders(own, os.path.join(output, COMMON) if has_common else None)


def is_one_of_several(spec: Spec) -> bool:
    """Return whether the project of a specification has several programs."""
    return bool(spec.program or spec.project.programs)
