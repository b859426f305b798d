"""templates/firmware/storage.py under both interpreters: the checks of storage_checks.py."""

from pathlib import Path

import pytest
from firmware_runs import failed_checks


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_storage(interpreter: str, tmp_path: Path) -> None:
    """A power cut at any byte, any flipped bit and a full flash leave the old payload or the new one."""
    assert failed_checks(interpreter, "storage_checks.py", str(tmp_path)) == ""
