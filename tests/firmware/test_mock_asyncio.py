"""templates/mocks/mock_asyncio.py under both interpreters: the checks of mock_asyncio_checks.py."""

import pytest
from firmware_runs import failed_checks


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_mock_asyncio(interpreter: str) -> None:
    """Tasks run on the virtual clock alike, and a simulator can pace it."""
    assert failed_checks(interpreter, "mock_asyncio_checks.py") == ""
