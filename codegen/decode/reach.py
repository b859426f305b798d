"""How far a project reaches: the folders that its files may lie in."""

import os

from codegen.decode.board_model import FOLDER as BOARDS
from codegen.decode.record_file import decode_record_file
from codegen.decode.shipped_corrections import FOLDER as CORRECTIONS
from codegen.diagnostics import Report
from codegen.load.shipped import shipped_folders
from codegen.model.spec import Project


def folders_of(project_file: str) -> tuple[str, ...]:
    """The folder above that of the project file, those that it lists under ``outside``, and what comes with codegen."""
    folder = os.path.dirname(os.path.abspath(project_file))
    project = decode_record_file(os.path.abspath(project_file), Project, Report())
    outside = project.outside if project else ()
    listed = (os.path.normpath(os.path.join(folder, each)) for each in outside)
    return (folder, os.path.dirname(folder), *listed, *shipped_folders(), BOARDS, CORRECTIONS)
