"""What trace finds out of all programs together is kept for as long as their specification is as it was."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from codegen.commands.trace import shared_modules
from codegen.diagnostics import Report
from codegen.project.systems import read_systems
from codegen.targets import firmware
from codegen.tool import cache


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A cache of the test's own."""
    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache"))
    cache.cache_folder.cache_clear()
    cache._new.clear()
    yield
    cache.cache_folder.cache_clear()
    cache._new.clear()


def test_firmware_is_not_rendered_again_to_find_the_modules_that_programs_share(
    built: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rendered = []
    render = firmware.render_firmware
    monkeypatch.setattr(firmware, "render_firmware", lambda system: rendered.append(system) or render(system))
    project = str(built / "specs" / "codegen.yaml")
    systems = read_systems(project, Report())
    shared = shared_modules(systems)
    assert rendered == list(systems)
    assert shared["firmware/storage.py"] == "common/firmware/storage.py"
    rendered.clear()
    cache.write_new()  # as at the end of a run
    assert shared_modules(read_systems(project, Report())) == shared
    assert not rendered
    streams = built / "specs" / "streams.yaml"
    streams.write_text(streams.read_text() + "# edited\n")
    shared_modules(read_systems(project, Report()))
    assert len(rendered) == len(systems)
