"""An empty folder for each test, always at one path: where a conftest imports this, it is ``tmp_path``."""

import shutil
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def place_of_projects(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same for every test of a worker."""
    return tmp_path_factory.mktemp("projects") / "project"


@pytest.fixture(name="tmp_path")
def folder_at_one_path(place_of_projects: Path) -> Path:
    """An empty folder: a file that no test changes is read once, not for every copy of a project."""
    shutil.rmtree(place_of_projects, ignore_errors=True)
    place_of_projects.mkdir()
    return place_of_projects
