"""One folder for the projects of all cases."""

import shutil
from pathlib import Path

import pytest

from codegen.commands import build
from codegen.targets.shared_files import Output


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


@pytest.fixture
def without_output(monkeypatch: pytest.MonkeyPatch) -> None:
    """A build finds what it finds, and writes no file of a project that has no error: that takes most of its time."""
    monkeypatch.setattr(build, "render_systems", lambda _systems: Output({}, {}, ()))
