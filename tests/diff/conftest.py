"""An older release of pymavlink, which `make test` fetches: there is no other way to have two real releases."""

import sys
from pathlib import Path

import pytest
from one_path import folder_at_one_path, place_of_projects  # noqa: F401  fixtures


@pytest.fixture(scope="session")
def older_pymavlink() -> Path:
    """The wheel of the older release."""
    found = sorted((Path(sys.prefix) / "releases").glob("pymavlink-*.whl"))
    assert found, "the older pymavlink is missing: make test fetches it (make .venv/.releases does only that)"
    return found[0]
