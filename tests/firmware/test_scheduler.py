"""templates/firmware/scheduler.py under both interpreters: the checks of scheduler_checks.py."""

import pytest
from firmware_runs import failed_checks


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_scheduler(interpreter: str) -> None:
    """Rates without drift, late slots counted, failures survived, nothing allocated."""
    assert failed_checks(interpreter, "scheduler_checks.py") == ""
