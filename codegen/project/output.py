"""Reads the output folder that a project file names, without reading the specification.

A build that has nothing to do asks this first, and reading YAML would take longer than all else that it does. So what
a project file states is kept under its content.
"""

import os

from codegen.tool.cache import entry, keep, kept
from codegen.tool.digest import tool_digest


def stated_output(project_file: str) -> str | None:
    """Return the absolute path of the folder that a project file (an absolute path) names for its output.

    None where the file cannot be read or has errors, and where it or the folder lies out of the project: there nothing
    is looked for.
    """
    specification = os.path.dirname(project_file)
    above = os.path.realpath(os.path.dirname(specification))
    if not _is_inside(project_file, above):
        return None
    try:
        with open(project_file, "rb") as file:
            name = entry("output", tool_digest(), project_file, file.read())
    except OSError:
        return None
    known = kept(name)
    written = os.fsdecode(known) if known is not None else _read(project_file)
    if written is None:
        return None
    if known is None:
        keep(name, os.fsencode(written))
    folder = os.path.normpath(os.path.join(specification, written))
    return folder if _is_inside(folder, above) else None


def _is_inside(path: str, above: str) -> bool:
    try:
        return os.path.commonpath([above, os.path.realpath(path)]) == above
    except ValueError:  # a name with a NUL, or another drive
        return False


def _read(project_file: str) -> str | None:
    from codegen.decode.record_file import decode_record_file  # noqa: PLC0415  only for a file that is a new one
    from codegen.diagnostics import Report  # noqa: PLC0415
    from codegen.load.files import DISK  # noqa: PLC0415
    from codegen.model.spec.spec import Project  # noqa: PLC0415

    project = decode_record_file(project_file, Project, DISK, Report())
    return None if project is None else project.output
