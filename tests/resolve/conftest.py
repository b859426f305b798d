"""Copies of projects that tests of resolving change."""

import shutil
from pathlib import Path

import pytest
from one_path import folder_at_one_path, place_of_projects  # noqa: F401  fixtures


@pytest.fixture
def folder(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A copy of the specification that the module of the test names PROJECT."""
    return Path(shutil.copytree(request.module.PROJECT, tmp_path / "specs"))
