"""Projects with a receiver, each built once."""

from collections.abc import Callable
from pathlib import Path

import pytest
from projects import shipped, two_packs


@pytest.fixture(scope="session")
def packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The generated files of a project with both generations and information, for each of two packs."""
    return two_packs(tmp_path_factory.mktemp("packs"))


@pytest.fixture(scope="session")
def generated(packs: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The generated files of a project by its name."""
    found = {"two_packs": packs, "shipped": shipped(tmp_path_factory.mktemp("shipped"))}
    return found.__getitem__
