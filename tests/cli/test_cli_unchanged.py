"""A build that would change nothing is over at once, and only then: whatever could matter makes it run."""

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.emit import stamp
from codegen.project.output import stated_output


def build(folder: Path, *options: str) -> str:
    command = [sys.executable, "-m", "codegen", "build", *options]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr


def known(folder: Path) -> int | None:
    project = str(folder / "specs" / "codegen.yaml")
    output = stated_output(project)
    assert output is not None
    return stamp.unchanged(project, output)


def test_the_second_build_is_known_to_change_nothing(built: Path) -> None:
    count = (
        len([path for path in (built / "generated").rglob("*") if path.is_file()]) - 3
    )  # manifest, stamp, .gitignore
    assert known(built) == count
    assert build(built) == f"up to date: {count} files\n"


@pytest.mark.parametrize("written", ['"../made by codegen"', "'../it''s'", '"..\\u002fmade"', "../made#1  # here"])
def test_the_output_is_where_the_project_says(built: Path, written: str) -> None:
    """Quotes, escapes, spaces and comments are read as YAML has them: a build finds its stamp again."""
    project = built / "specs" / "codegen.yaml"
    text = project.read_text()
    shutil.rmtree(built / "generated")
    project.write_text(text.replace("output: ../generated\n", f"output: {written}\n"))
    os.utime(project, (1, 1))
    assert "up to date" not in build(built)
    count = known(built)
    assert count is not None
    assert build(built) == f"up to date: {count} files\n"


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
        pytest.param(edit("specs/dialects/corrections_rfc_0018.yaml"), id="corrections"),
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
def test_whatever_could_matter_makes_it_run(built: Path, change: Callable[[Path], None]) -> None:
    assert known(built) is not None
    change(built)
    assert known(built) is None


def test_codegen_and_the_dialect_matter(built: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another version of codegen, of its templates, of a library or of the dialect may render something else."""
    assert known(built) is not None
    with monkeypatch.context() as patch:
        patch.setattr(stamp, "tool_digest", lambda: "another")
        assert known(built) is None
    read = stamp.json.loads((built / "generated" / ".codegen" / "stamp.json").read_text())["read"]
    assert [path for path in read if path.endswith("common.xml")]


def test_a_build_with_warnings_is_never_skipped(built: Path) -> None:
    """The warnings are printed at every build."""
    path = built / "specs" / "streams.yaml"
    path.write_text(
        path.read_text().replace("streams:\n", "streams:\n  SPARE: {rate: 1 Hz, doc: Nothing uses it}\n", 1)
    )
    first, second = build(built), build(built)
    assert "warning" in first
    assert "warning" in second
    assert known(built) is None


def test_what_changed_during_the_build_is_not_taken_for_what_was_read(built: Path) -> None:
    """An edit between reading and noting belongs to the next build."""
    path = str(built / "specs" / "codegen.yaml")
    folder = built / "generated"
    made = [one for one in folder.rglob("*") if one.is_file() and ".codegen" not in one.parts]
    rendered = {one.relative_to(folder).as_posix(): one.read_bytes() for one in made if one.name != "manifest.json"}
    read = stamp.json.loads((folder / ".codegen" / "stamp.json").read_text())["read"]
    shutil.rmtree(folder / ".codegen")
    stamp.keep(path, Path(path).stat().st_mtime, read, str(folder), rendered, [])
    assert known(built) is None
    stamp.keep(path, time.time(), read, str(folder), {**rendered, "firmware/state.py": b"another\n"}, [])
    assert known(built) is None
    stamp.keep(path, time.time(), read, str(folder), rendered, [])
    assert known(built) is not None


def test_things_beside_the_specification_do_not_matter(built: Path) -> None:
    """A pipe would never end, and a large file would be read at every build: only their names count."""
    (built / "specs" / "pictures").mkdir()
    os.mkfifo(built / "specs" / "pictures" / "pipe")
    assert known(built) is None
    build(built)
    assert known(built) is not None
