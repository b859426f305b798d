"""templates/firmware/texts.py under both interpreters: the checks of texts_checks.py."""

import pytest
from firmware_runs import failed_checks


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_texts(interpreter: str) -> None:
    """Texts are kept with their severity and number; nothing that is said stops the vehicle."""
    assert failed_checks(interpreter, "texts_checks.py") == ""
