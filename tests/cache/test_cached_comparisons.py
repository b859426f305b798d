"""A comparison that knows what an earlier one read says what one that knows nothing says."""

import json
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from rover_alone import without_programs

from codegen.cli import main
from codegen.tool import cache

ROOT = Path(__file__).resolve().parents[2]
MARKED = 'import pytest\n\n\n@pytest.mark.requirement("FR-00068.3")\ndef test_it() -> None: ...\n'

EDITS = {
    "a table": ("specs/messages/battery_status.yaml", "MAV_BATTERY_FUNCTION_ALL", "MAV_BATTERY_FUNCTION_AVIONICS"),
    "a parameter": ("specs/parameters.yaml", "default: 3.95", "default: 4.05"),
    "a draft": ("specs/dialects/battery_upstream.xml", 'type="uint8_t" name="id"', 'type="uint16_t" name="id"'),
    "a criterion": ("specs/requirements/FR-00068-battery-status-telemetry.md", "default 2 Hz", "default 3 Hz"),
    "what is cited": ("specs/streams.yaml", "requirement: FR-00068.2", "requirement: FR-00068.8"),
    "a mark": ("tests/test_it.py", "FR-00068.3", "FR-00068.4"),
}

Compare = Callable[..., Any]


@pytest.fixture
def compare(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Iterator[Compare]:
    """Yield a call for the output of ``codegen diff``, with a cache of the test's own or with none."""

    def said(*sides: str, knows: bool = True) -> Any:
        monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache") if knows else "off")
        _later_run()
        assert main(["diff", *sides, "--fail-on", "never", "--format", "json"]) == 0
        return json.loads(capsys.readouterr().out)

    yield said
    _later_run()


def _later_run() -> None:
    """Forget what this process knows of the folder."""
    cache.cache_folder.cache_clear()
    cache._new.clear()


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The rover with a test of its own as a commit, which is the working directory."""
    folder = tmp_path / "project"
    shutil.copytree(ROOT / "specs", folder / "specs")
    without_programs(folder / "specs")
    (folder / "tests").mkdir()
    (folder / "tests" / "test_it.py").write_text(MARKED)
    git(folder, "init", "--quiet")
    commit(folder)
    monkeypatch.chdir(folder)
    return folder


def git(folder: Path, *arguments: str) -> None:
    subprocess.run(["git", "-C", folder, *arguments], check=True)


def commit(folder: Path) -> None:
    git(folder, "add", "--all")
    git(folder, "-c", "user.name=a", "-c", "user.email=a@b.c", "commit", "--quiet", "-m", "step")


def told(comparison: Any) -> list[tuple[str, ...]]:
    """Return the changes, without the names of the sides that places begin with."""
    return [tuple(change[key] for key in ("rule", "subject", "old", "new")) for change in comparison["changes"]]


@pytest.mark.long
def test_after_each_edit_and_commit_it_says_what_a_run_that_knows_nothing_says(project: Path, compare: Compare) -> None:
    """The last version stays the one that the edit has changed, and then becomes a revision of the same name."""
    assert compare("HEAD")["changes"] == []
    for path, old, new in EDITS.values():
        text = (project / path).read_text()
        assert old in text, path
        (project / path).write_text(text.replace(old, new, 1))
        now = compare("HEAD")
        assert now == compare("HEAD", knows=False)
        commit(project)
        assert compare("HEAD")["changes"] == [], path
        committed = compare("HEAD~1", "HEAD")
        assert told(committed) == told(now)
    assert committed == compare("HEAD~1", "HEAD")


def test_a_dialect_is_read_again_where_a_file_of_it_differs(tmp_path: Path, compare: Compare) -> None:
    """Also one that it includes, and one that is wrong."""
    old, new, included = (tmp_path / name for name in ("old.xml", "new.xml", "included.xml"))
    text = (ROOT / "specs" / "dialects" / "protocol_version.xml").read_text()
    for path in (old, included):
        path.write_text(text)
    new.write_text("<mavlink><include>included.xml</include></mavlink>")
    for change in ("", 'name="spec_version_hash"', 'name="Else"', 'name="other"'):
        included.write_text(text.replace('name="library_version_hash"', change) if change else text)
        sides = str(old), str(new), "--allow-errors"
        assert compare(*sides) == compare(*sides) == compare(*sides, knows=False)
