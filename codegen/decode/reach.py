"""The folders that the files of a project may lie in."""

import os
from functools import lru_cache

from codegen.decode.board_model import FOLDER as BOARDS
from codegen.decode.record_file import decode_record_text
from codegen.decode.shipped_corrections import FOLDER as CORRECTIONS
from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.load.shipped import shipped_folders
from codegen.load.text import decode_text
from codegen.model.spec.spec import Project


def within(project_file: str, files: Files) -> Files:
    """Return the files of a project alone: those below its folders, and what comes with codegen."""
    return files.confined(folders_of(project_file, files))


def folders_of(project_file: str, files: Files) -> tuple[str, ...]:
    """The folder above that of the project file, those that it lists under ``outside``, and what comes with codegen."""
    folder = os.path.dirname(os.path.abspath(project_file))
    own = (folder, os.path.dirname(folder))  # a project file that leads out of them is not asked what may lie outside
    data = files.confined(own).read_bytes(os.path.abspath(project_file), Report())
    outside = () if data is None else _outside(os.path.abspath(project_file), data)
    listed = (os.path.normpath(os.path.join(folder, each)) for each in outside)
    return (*own, *listed, *shipped_folders(files), BOARDS, CORRECTIONS)


@lru_cache(maxsize=1)
def _outside(path: str, data: bytes) -> tuple[str, ...]:
    """Return what the project file lists; each step of a command asks for it."""
    text = decode_text(data, path, Report())
    project = None if text is None else decode_record_text(text, path, Project, Report())
    return project.outside if project else ()
