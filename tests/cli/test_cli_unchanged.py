"""A build that would change nothing is over at once, and only then: whatever could matter makes it run."""

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen import stamp

ROOT = Path(__file__).parents[2]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """The rover's specification, built."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    for path in (tmp_path / "specs").rglob("*"):
        os.utime(path, (1, 1))  # long before the build
    build(tmp_path)
    return tmp_path


def build(folder: Path, *options: str) -> str:
    command = [sys.executable, "-m", "codegen", "build", *options]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr


def known(folder: Path) -> int | None:
    kept = stamp.unchanged(str(folder / "specs" / "codegen.yaml"))
    return None if kept is None else kept.count


def test_the_second_build_is_known_to_change_nothing(project: Path) -> None:
    count = (
        len([path for path in (project / "generated").rglob("*") if path.is_file()]) - 3
    )  # manifest, stamp, .gitignore
    assert known(project) == count
    assert build(project) == f"0 files written, {count} unchanged\n"


def edit(path: str, text: str = "# more\n") -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        with (folder / path).open("a") as file:
            file.write(text)

    return change


def link(folder: Path, path: str, new: str = "") -> None:
    """Move something elsewhere, leave a link to it, and put a new file behind it."""
    elsewhere = folder / "elsewhere"
    shutil.move(folder / path, elsewhere)
    (folder / path).symlink_to(elsewhere)
    if new:
        (elsewhere / new).write_text("")


@pytest.mark.parametrize(
    "change",
    [
        pytest.param(edit("specs/codegen.yaml"), id="project"),
        pytest.param(edit("specs/messages/heartbeat.yaml"), id="table"),
        pytest.param(edit("specs/messages/new.yaml"), id="new-table"),
        pytest.param(edit("specs/dialects/corrections.yaml"), id="corrections"),
        pytest.param(edit("generated/firmware/state.py"), id="hand-edit"),
        pytest.param(edit("generated/firmware/stray.py"), id="stray"),
        pytest.param(edit("generated/manifest.json", " "), id="manifest"),
        pytest.param(edit("generated/.codegen/stamp.json"), id="stamp"),
        pytest.param(lambda folder: (folder / "generated" / "firmware" / "state.py").unlink(), id="missing-output"),
        pytest.param(lambda folder: (folder / "specs" / "messages" / "heartbeat.yaml").unlink(), id="missing-table"),
        pytest.param(lambda folder: shutil.rmtree(folder / "generated"), id="no-output"),
        pytest.param(lambda folder: link(folder, "generated/firmware/state.py"), id="output-that-is-a-link"),
        pytest.param(lambda folder: link(folder, "specs/messages", "new.yaml"), id="new-table-behind-a-link"),
    ],
)
def test_whatever_could_matter_makes_it_run(project: Path, change: Callable[[Path], None]) -> None:
    change(project)
    assert known(project) is None


def test_codegen_and_the_dialect_matter(project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another version of codegen, of its templates, of a library or of the dialect may render something else."""
    assert known(project) is not None
    with monkeypatch.context() as patch:
        patch.setattr(stamp, "templates_folder", lambda: str(tmp_path / "specs"))
        assert known(project) is None
    with monkeypatch.context() as patch:
        patch.setattr(stamp, "_libraries", lambda: ["jinja2-9.9.dist-info"])
        assert known(project) is None
    read = stamp.json.loads((project / "generated" / ".codegen" / "stamp.json").read_text())["read"]
    assert [path for path in read if path.endswith("common.xml")]


def test_a_build_with_warnings_is_never_skipped(project: Path) -> None:
    """What there is to say is said at every build."""
    path = project / "specs" / "streams.yaml"
    path.write_text(
        path.read_text().replace("streams:\n", "streams:\n  SPARE: {rate: 1 Hz, doc: Nothing uses it}\n", 1)
    )
    first, second = build(project), build(project)
    assert "warning" in first
    assert "warning" in second
    assert known(project) is None


def test_what_changed_during_the_build_is_not_taken_for_what_was_read(project: Path) -> None:
    """An edit between reading and noting belongs to the next build."""
    path = str(project / "specs" / "codegen.yaml")
    folder = project / "generated"
    made = [one for one in folder.rglob("*") if one.is_file() and ".codegen" not in one.parts]
    rendered = {one.relative_to(folder).as_posix(): one.read_bytes() for one in made if one.name != "manifest.json"}
    read = stamp.json.loads((folder / ".codegen" / "stamp.json").read_text())["read"]
    shutil.rmtree(folder / ".codegen")
    stamp.keep(path, Path(path).stat().st_mtime, read, str(folder), rendered, [])
    assert known(project) is None
    stamp.keep(path, time.time(), read, str(folder), {**rendered, "firmware/state.py": b"another\n"}, [])
    assert known(project) is None
    stamp.keep(path, time.time(), read, str(folder), rendered, [])
    assert known(project) is not None


def test_things_beside_the_specification_do_not_matter(project: Path) -> None:
    """A pipe would never end, and a large file would be read at every build: only their names count."""
    (project / "specs" / "pictures").mkdir()
    os.mkfifo(project / "specs" / "pictures" / "pipe")
    assert known(project) is None
    build(project)
    assert known(project) is not None
