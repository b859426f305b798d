"""One folder for the projects of all cases."""

import shutil
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def place_of_projects(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same for every test of a worker."""
    return tmp_path_factory.mktemp("broken") / "project"


@pytest.fixture
def tmp_path(place_of_projects: Path) -> Path:
    """An empty folder, always at one path: a document that no case changes is parsed once, not for every case."""
    shutil.rmtree(place_of_projects, ignore_errors=True)
    place_of_projects.mkdir()
    return place_of_projects
