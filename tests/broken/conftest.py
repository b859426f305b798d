"""One folder for the projects of all cases, and builds that write nothing."""

import pytest
from one_path import folder_at_one_path, place_of_projects  # noqa: F401  fixtures

from codegen.commands import build
from codegen.targets.shared_files import Output


@pytest.fixture
def without_output(monkeypatch: pytest.MonkeyPatch) -> None:
    """A build finds what it finds, and writes no file of a project that has no error: that takes most of its time."""
    monkeypatch.setattr(build, "render_systems", lambda _systems: Output({}, {}, ()))
