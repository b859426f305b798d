"""The folders that a specification may be read from: findings quote their subject, and must not quote other files."""

import os
from dataclasses import field

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Bounds:
    """The folders, links followed, below which files of the disk may be read.

    ``real`` has where links lead, by folder: each has many files, and is asked for with each.
    """

    folders: tuple[str, ...]
    real: dict[str, str] = field(default_factory=dict, compare=False)

    def are_left_by(self, path: str) -> bool:
        """Return whether a file lies, links followed, in none of the folders."""
        try:
            real = self.real_path(path)
        except (OSError, ValueError):
            return False  # it cannot be read either
        return not any(real == folder or real.startswith(folder.rstrip(os.sep) + os.sep) for folder in self.folders)

    def real_path(self, path: str) -> str:
        """Return where the links of a path lead; an OSError or a ValueError where the system cannot tell."""
        folder, name = os.path.split(path)
        if name in ("", os.curdir, os.pardir) or os.path.islink(path):
            return os.path.realpath(path)
        if folder not in self.real:
            self.real[folder] = os.path.realpath(folder)
        return os.path.join(self.real[folder], name)
