"""Finds project files: in the folder of a project, and the nearest one above a folder."""

import os

PROJECT_FILES = ("specs/codegen.yaml", "codegen.yaml")
"""Its paths; the first that exists is meant."""


def project_in(folder: str) -> str | None:
    """The project file of a folder; None where it has none."""
    candidates = (os.path.join(folder, name) for name in PROJECT_FILES)
    return next((path for path in candidates if os.path.isfile(path)), None)


def nearest_project(folder: str) -> str | None:
    """The project file that lies nearest, in ``folder`` (absolute) or one above it."""
    while True:
        path = project_in(folder)
        if path is not None:
            return path
        above = os.path.dirname(folder)
        if above == folder:
            return None
        folder = above
