"""How far a project reaches: the folders that its files may lie in."""

import os
from functools import lru_cache

from codegen.decode.board_model import FOLDER as BOARDS
from codegen.decode.record_file import decode_record_text
from codegen.decode.shipped_corrections import FOLDER as CORRECTIONS
from codegen.diagnostics import Report
from codegen.load.shipped import shipped_folders
from codegen.load.text import decode_text, read_bytes
from codegen.model.spec.spec import Project


def folders_of(project_file: str) -> tuple[str, ...]:
    """The folder above that of the project file, those that it lists under ``outside``, and what comes with codegen."""
    folder = os.path.dirname(os.path.abspath(project_file))
    data = read_bytes(os.path.abspath(project_file), Report())
    outside = () if data is None else _outside(os.path.abspath(project_file), data)
    listed = (os.path.normpath(os.path.join(folder, each)) for each in outside)
    return (folder, os.path.dirname(folder), *listed, *shipped_folders(), BOARDS, CORRECTIONS)


@lru_cache(maxsize=1)
def _outside(path: str, data: bytes) -> tuple[str, ...]:
    """Return what the project file lists; each step of a command asks for it."""
    text = decode_text(data, path, Report())
    project = None if text is None else decode_record_text(text, path, Project, Report())
    return project.outside if project else ()
