"""A generated program in one folder: what it has for itself, and what all programs of its project have alike."""

import shutil
from pathlib import Path

from codegen.model.program_folders import SHARED_PARTS, program_folders


def module_folders(output: Path, *parts: str, program: str = "") -> list[Path]:
    """Return the folders with the modules of a program below an output folder, in the order of a path of modules."""
    return [Path(folder) for folder in program_folders(str(output), program).of(*parts)]


def whole_program(output: Path, folder: Path, program: str = "") -> Path:
    """Copy firmware, mocks and tests of a program below an output folder into ``folder``, and return that."""
    for part in SHARED_PARTS:
        for source in reversed(module_folders(output, part, program=program)):
            if source.exists():
                shutil.copytree(source, folder / part, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
    return folder
