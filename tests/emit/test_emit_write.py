"""A build leaves whole files on the disk, also when it is stopped half-way."""

import json
import os
import re
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.emit.manifest import Manifest
from codegen.emit.plan import plan_output
from codegen.emit.write import write_output

FILES = {"firmware/state.py": "a = 1\n", "docs/battery.md": "# Battery\n", "firmware/mavlink.py": "b = 2\n"}

Tree = Callable[[], dict[str, bytes]]


def stamps(folder: Path) -> dict[str, tuple[int, int]]:
    """Time stamp and inode of every file: either shows that a file was written anew."""
    found = [path for path in folder.rglob("*") if path.is_file()]
    return {str(path): (path.stat().st_mtime_ns, path.stat().st_ino) for path in found}


def test_first_build_writes_every_file_and_a_manifest_of_their_hashes(output: Path, build: Any, tree: Tree) -> None:
    assert build(FILES).outcome.written == 3
    assert tree() == {path: text.encode() for path, text in sorted(FILES.items())}
    expected = {"files": {path: sha256(text.encode()).hexdigest() for path, text in FILES.items()}}
    assert json.loads((output / "manifest.json").read_text()) == expected


def test_manifest_has_one_sorted_line_a_file_and_nothing_of_this_machine(output: Path, build: Any) -> None:
    build(FILES)
    lines = (output / "manifest.json").read_text().splitlines()
    assert lines[:2] == ["{", '  "files": {']
    assert lines[-2:] == ["  }", "}"]
    entries = lines[2:-2]
    assert all(re.fullmatch(r'    "[a-z/.]+": "[0-9a-f]{64}",?', line) for line in entries)
    assert entries == sorted(entries)


def test_second_build_touches_no_file(output: Path, build: Any) -> None:
    build(FILES)
    before = stamps(output)
    again = build(FILES)
    assert stamps(output) == before
    assert (again.outcome.written, again.outcome.unchanged, again.rules) == (0, 3, [])


def test_a_file_that_was_deleted_comes_back(output: Path, build: Any, tree: Tree) -> None:
    """With nothing left to do after that: the manifest is the one that knew it."""
    build(FILES)
    before = (output / "manifest.json").read_bytes()
    (output / "docs" / "battery.md").unlink()
    assert build(FILES).outcome.written == 1
    assert (output / "manifest.json").read_bytes() == before
    assert tree() == {path: text.encode() for path, text in sorted(FILES.items())}


def test_only_the_file_that_changed_is_written(output: Path, build: Any) -> None:
    build(FILES)
    before = stamps(output)
    assert build({**FILES, "docs/battery.md": "# Batteries\n"}).outcome.written == 1
    after = stamps(output)
    changed = {Path(path).name for path in after if after[path] != before[path]}
    assert changed == {"battery.md", "manifest.json"}


def test_text_is_written_as_it_is_rendered(build: Any, tree: Tree) -> None:
    """Neither line ends nor characters are translated on the way to the disk."""
    text = "\ufeffµA\r\nno end\f"
    build({"a.md": text, "empty.txt": ""})
    assert tree() == {"a.md": text.encode("utf-8"), "empty.txt": b""}


def test_a_new_file_gets_the_usual_permissions_and_a_replaced_one_keeps_its_own(output: Path, build: Any) -> None:
    umask = os.umask(0o022)
    try:
        build({"a.py": "1\n", "b.py": "1\n"})
        assert (output / "a.py").stat().st_mode & 0o777 == 0o644
        (output / "a.py").chmod(0o755)
        build({"a.py": "2\n", "b.py": "2\n"})
        assert (output / "a.py").stat().st_mode & 0o777 == 0o755
        assert (output / "b.py").stat().st_mode & 0o777 == 0o644
    finally:
        os.umask(umask)


def test_manifest_is_sorted_whatever_the_order_of_its_making() -> None:
    one, other = (
        Manifest({"b": "2", "a": "1"}, {"d": "4", "c": "3"}),
        Manifest({"a": "1", "b": "2"}, {"c": "3", "d": "4"}),
    )
    assert one.text() == other.text()


def failing(monkeypatch: pytest.MonkeyPatch, name: str, fault: BaseException) -> None:
    """From now on ``os.replace`` fails for the file called ``name``."""
    real = os.replace

    def replace(source: str, target: str) -> None:
        if os.path.basename(target) == name:
            raise fault
        real(source, target)

    monkeypatch.setattr(os, "replace", replace)


def test_a_disk_fault_half_way_leaves_every_file_whole(
    output: Path, build: Any, tree: Tree, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Files before the fault are new, the others old, nothing is cut off and no unfinished file stays behind."""
    build({"a": "old a\n", "b": "old b\n", "c": "old c\n"})
    with monkeypatch.context() as patched:
        failing(patched, "b", OSError(28, "No space left on device"))
        failed = build({"a": "new a\n", "b": "new b\n", "c": "new c\n"})
    assert failed.rules == [("output-unwritable", "b")]
    assert failed.code == 2
    assert tree() == {"a": b"new a\n", "b": b"old b\n", "c": b"old c\n"}
    healed = build({"a": "new a\n", "b": "new b\n", "c": "new c\n"})
    assert (healed.rules, healed.outcome.written) == ([], 2)
    assert "pending" not in json.loads((output / "manifest.json").read_text())


def test_a_build_that_was_killed_is_not_mistaken_for_hand_edits(
    build: Any, tree: Tree, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The specification may change before the next build: what the killed one wrote is still known as generated."""
    build({"a": "old a\n", "b": "old b\n", "gone": "old\n"})
    with monkeypatch.context() as patched:
        failing(patched, "b", KeyboardInterrupt())
        with pytest.raises(KeyboardInterrupt):
            build({"a": "new a\n", "added": "new\n", "b": "new b\n"})
    assert tree() == {"a": b"new a\n", "added": b"new\n", "b": b"old b\n", "gone": b"old\n"}
    after = build({"a": "newer a\n", "added": "newer\n", "b": "newer b\n"}, clean=True)
    assert after.rules == []
    assert tree() == {"a": b"newer a\n", "added": b"newer\n", "b": b"newer b\n"}


def test_a_fault_at_the_manifest_comes_before_any_file_is_written(
    build: Any, tree: Tree, monkeypatch: pytest.MonkeyPatch
) -> None:
    build({"a": "old\n"})
    failing(monkeypatch, "manifest.json", OSError(5, "Input/output error"))
    failed = build({"a": "new\n"})
    assert failed.rules == [("output-unwritable", "manifest.json")]
    assert tree() == {"a": b"old\n"}


def test_manifest_is_written_last(build: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Until every file is there the manifest on the disk says that the build is not finished."""
    seen = []
    real = os.replace

    def replace(source: str, target: str) -> None:
        seen.append(os.path.basename(target))
        real(source, target)

    monkeypatch.setattr(os, "replace", replace)
    build({"b": "1\n", "a": "1\n"})
    assert seen == ["manifest.json", "a", "b", "manifest.json"]


def test_what_a_killed_build_left_unfinished_is_named_and_cleaned(output: Path, build: Any) -> None:
    build(FILES)
    left = output / "firmware" / ".codegen-0123456789abcdef.tmp"
    left.write_text("half of a f")
    assert build(FILES).rules == [("stray-file", "firmware/.codegen-0123456789abcdef.tmp")]
    assert left.exists()
    assert build(FILES, clean=True).rules == []
    assert not left.exists()


@pytest.mark.parametrize(
    "path",
    ["/etc/passwd", "../a.py", "a/../../b.py", "a/./b.py", "", ".", "a//b", "a\\b", "a\0b", "manifest.json", "a/"],
)
def test_a_target_cannot_render_outside_the_folder(path: str, build: Any, output: Path) -> None:
    """Such a path is a fault in a target, not in an input: it is raised, and nothing is written."""
    with pytest.raises(ValueError, match="a target rendered"):
        build({"fine.py": "", path: ""})
    assert not output.exists()


def test_a_target_cannot_render_below_a_file(build: Any) -> None:
    with pytest.raises(ValueError, match="below a file"):
        build({"a": "", "a/b": ""})


@pytest.mark.parametrize("rendered", [{"a/b.py": "2\n"}, {}], ids=["write", "remove"])
def test_a_link_that_appears_after_the_plan_is_not_followed(output: Path, build: Any, rendered: dict[str, str]) -> None:
    build({"a/b.py": "1\n"})
    plan = plan_output(rendered, str(output), Report(), clean=True)
    outside = output.parent / "outside"
    os.rename(output / "a", outside)
    (output / "a").symlink_to(outside, target_is_directory=True)
    report = Report()
    assert plan is not None
    write_output(plan, report)
    assert [found.rule.id for found in report] == ["output-unwritable"]
    assert (outside / "b.py").read_text() == "1\n"
