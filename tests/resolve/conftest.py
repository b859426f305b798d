"""Copies of projects that tests of resolving change."""

import shutil
from pathlib import Path

import pytest


@pytest.fixture
def folder(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A copy of the specification that the module of the test names PROJECT."""
    return Path(shutil.copytree(request.module.PROJECT, tmp_path / "specs"))
