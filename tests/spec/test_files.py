"""Files as commands hand them down: each says what may be read and what hangs in it, and none changes another."""

from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path


class Held:
    """A tree of contents by path."""

    def __init__(self, folder: str | None, **contents: str) -> None:
        self.folder, self.version, self.contents = folder, "1", contents

    def holds(self, path: str) -> bool:
        return path in self.contents

    def read(self, path: str) -> bytes | None:
        return self.contents[path].encode() if path in self.contents else None

    def names(self, folder: str) -> tuple[str, ...] | None:
        return None if folder else tuple(sorted(self.contents))


def test_a_tree_hangs_only_in_the_files_that_it_was_hung_into(tmp_path: Path) -> None:
    root = str(tmp_path / "HEAD~1:")
    files = DISK.with_tree(root, Held("/project", a="1"))
    assert files.read_text(f"{root}/a", Report()) == "1"
    assert (files.names(root, Report()), files.is_file(f"{root}/a"), files.is_folder(root)) == (["a"], True, True)
    assert files.on_disk(f"{root}/a") == "/project/a"
    assert (files.version_of(root), files.version_of(str(tmp_path))) == ("1", "")
    report = Report()
    assert DISK.read_text(f"{root}/a", report) is None
    assert not DISK.exists(root)
    assert [finding.rule.id for finding in report] == ["file-not-found"]


def test_files_may_have_two_trees(tmp_path: Path) -> None:
    """Both sides of a comparison: neither hides the other, nor the disk."""
    first, second = (str(tmp_path / name) for name in ("a:", "b:"))
    files = DISK.with_tree(first, Held(None, x="1")).with_tree(second, Held(None, x="2"))
    (tmp_path / "x").write_text("3")
    read = [files.read_text(str(Path(folder) / "x"), Report()) for folder in (first, second, str(tmp_path))]
    assert read == ["1", "2", "3"]


def test_confined_files_have_nothing_of_other_folders(tmp_path: Path) -> None:
    """Neither a text nor a name; the files that they were made of still have both."""
    inside, outside = tmp_path / "inside", tmp_path / "outside"
    for folder in (inside, outside):
        folder.mkdir()
        (folder / "a").write_text(folder.name)
    (inside / "link").symlink_to(outside / "a")
    files = DISK.confined([str(inside)])
    assert files.read_text(str(inside / "a"), Report()) == "inside"
    report = Report()
    assert files.read_text(str(outside / "a"), report) is None
    assert files.read_text(str(inside / "link"), report) is None
    assert files.names(str(outside), report) == []
    assert [finding.rule.id for finding in report] == ["outside-project"] * 3
    assert DISK.read_text(str(inside / "link"), Report()) == "outside"


def test_a_folder_that_cannot_be_listed_is_not_an_empty_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulated, because the superuser may list everything. One that is not there has no names, and no finding."""

    def refuse(_folder: str) -> list[str]:
        raise PermissionError(13, "Permission denied")

    report = Report()
    assert DISK.names(str(tmp_path / "none"), report) == []
    assert list(report) == []
    monkeypatch.setattr("os.listdir", refuse)
    assert DISK.names(str(tmp_path), report) == []
    (finding,) = report
    assert (finding.rule.id, finding.place.file) == ("file-not-readable", str(tmp_path))


def test_other_dialects_are_shipped_only_where_they_are_given() -> None:
    files = DISK.with_dialects({"own": "/own.xml"})
    assert (shipped_dialect_names(files), shipped_dialect_path("own", files)) == (("own",), "/own.xml")
    assert "common" in shipped_dialect_names(DISK)
    assert shipped_dialect_path("own", DISK) is None
