"""One folder for the projects of all cases."""

import shutil
from pathlib import Path

import pytest

_MADE: dict[str, object] = {}


@pytest.fixture(scope="session")
def place_of_projects(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same for every test of a worker."""
    return tmp_path_factory.mktemp("broken") / "project"


@pytest.fixture(autouse=True)
def made_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a case does not change is decoded once for all of them: these tests exchange no part of codegen."""
    for name in ("kept", "kept_object"):
        monkeypatch.setattr(f"codegen.decode.decoded.{name}", _MADE.get)
    for name in ("keep", "keep_object"):
        monkeypatch.setattr(f"codegen.decode.decoded.{name}", _MADE.__setitem__)


@pytest.fixture
def tmp_path(place_of_projects: Path) -> Path:
    """An empty folder, always at one path: a document that no case changes is parsed once, not for every case."""
    shutil.rmtree(place_of_projects, ignore_errors=True)
    place_of_projects.mkdir()
    return place_of_projects
