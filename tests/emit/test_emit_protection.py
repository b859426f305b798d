"""A build never overwrites files that people wrote, or touches anything outside its folder."""

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Tree = Callable[[], dict[str, bytes]]


def test_one_hand_edit_stops_the_whole_build(output: Path, build: Any, tree: Tree) -> None:
    build({"a.py": "1\n", "b.py": "1\n", "c.py": "1\n"})
    (output / "b.py").write_text("mine\n")
    refused = build({"a.py": "2\n", "b.py": "2\n", "c.py": "2\n", "d.py": "2\n"})
    assert (refused.code, refused.rules) == (1, [("edited-by-hand", "b.py")])
    place = next(iter(refused.report)).place
    assert (place.line, place.column) == (1, 1)
    assert tree() == {"a.py": b"1\n", "b.py": b"mine\n", "c.py": b"1\n"}


def test_every_hand_edit_is_named(output: Path, build: Any) -> None:
    build({"a.py": "1\n", "b.py": "1\n"})
    (output / "a.py").write_text("mine\n")
    (output / "b.py").write_text("")
    assert build({"a.py": "2\n", "b.py": "1\n"}).rules == [("edited-by-hand", "a.py"), ("edited-by-hand", "b.py")]


def test_force_gives_up_hand_edits(output: Path, build: Any, tree: Tree) -> None:
    build({"a.py": "1\n"})
    (output / "a.py").write_text("mine\n")
    assert build({"a.py": "2\n"}, force=True).rules == []
    assert tree() == {"a.py": b"2\n"}
    assert build({"a.py": "3\n"}).rules == []


def test_a_hand_edit_that_the_specification_caught_up_with_is_none(output: Path, build: Any) -> None:
    """Whoever writes by hand what would be generated now has nothing to lose."""
    build({"a.py": "1\n"})
    (output / "a.py").write_text("2\n")
    caught_up = build({"a.py": "2\n"})
    assert (caught_up.rules, caught_up.outcome.written) == ([], 0)
    assert build({"a.py": "3\n"}).rules == []


def test_a_deleted_file_is_written_again(output: Path, build: Any, tree: Tree) -> None:
    build({"a.py": "1\n", "b.py": "1\n"})
    (output / "a.py").unlink()
    assert build({"a.py": "1\n", "b.py": "1\n"}).outcome.written == 1
    assert tree() == {"a.py": b"1\n", "b.py": b"1\n"}


def test_a_foreign_file_is_not_overwritten(output: Path, build: Any, tree: Tree) -> None:
    output.mkdir()
    (output / "a.py").write_text("somebody's\n")
    refused = build({"a.py": "1\n", "b.py": "1\n"})
    assert (refused.code, refused.rules) == (1, [("foreign-file", "a.py")])
    assert tree() == {"a.py": b"somebody's\n"}
    assert build({"a.py": "1\n", "b.py": "1\n"}, force=True).rules == []
    assert tree() == {"a.py": b"1\n", "b.py": b"1\n"}


def test_a_folder_without_manifest_that_is_right_already_is_adopted(output: Path, build: Any) -> None:
    build({"a.py": "1\n"})
    (output / "manifest.json").unlink()
    adopted = build({"a.py": "1\n"})
    assert (adopted.rules, adopted.outcome.written) == ([], 0)
    assert list(json.loads((output / "manifest.json").read_text())["files"]) == ["a.py"]


def test_orphans_are_reported_and_remembered_until_they_are_cleaned(output: Path, build: Any, tree: Tree) -> None:
    build({"a.py": "1\n", "old/b.py": "1\n"})
    for _ in range(2):
        assert build({"a.py": "1\n"}).rules == [("no-longer-generated", "old/b.py")]
        assert list(json.loads((output / "manifest.json").read_text())["orphans"]) == ["old/b.py"]
    cleaned = build({"a.py": "1\n"}, clean=True)
    assert (cleaned.rules, cleaned.outcome.removed) == ([], 1)
    assert tree() == {"a.py": b"1\n"}
    assert not (output / "old").exists(), "the folder that is empty now goes with it"
    assert "orphans" not in json.loads((output / "manifest.json").read_text())


def test_an_orphan_that_was_edited_is_removed_only_by_force(output: Path, build: Any, tree: Tree) -> None:
    build({"a.py": "1\n", "b.py": "1\n"})
    (output / "b.py").write_text("mine\n")
    for flags in ({}, {"clean": True}, {"force": True}):
        assert build({"a.py": "1\n"}, **flags).rules == [("no-longer-generated", "b.py")]
        assert tree() == {"a.py": b"1\n", "b.py": b"mine\n"}
    assert build({"a.py": "1\n"}, clean=True, force=True).rules == []
    assert tree() == {"a.py": b"1\n"}


def test_what_is_run_because_it_is_there_goes_with_what_it_was_for(output: Path, build: Any, tree: Tree) -> None:
    """Without --clean; not what was edited by hand, nor what codegen did not write."""
    old = {f"{folder}/{name}.py": "1\n" for folder in ("tests", "docs") for name in ("a", "whole", "edited")}
    build(old)
    (output / "tests" / "edited.py").write_text("mine\n")
    (output / "tests" / "own.py").write_text("mine\n")
    kept = {path: text for path, text in old.items() if path.endswith("/a.py")}
    built = build(kept, vacated=("tests/",))
    assert built.outcome.removed == 1
    assert [path for rule, path in built.rules if rule == "no-longer-generated"] == [
        "docs/edited.py",
        "docs/whole.py",
        "tests/edited.py",
    ]
    assert tree().keys() == old.keys() - {"tests/whole.py"} | {"tests/own.py"}


def test_an_orphan_that_is_generated_again_is_no_foreign_file(build: Any) -> None:
    build({"a.py": "1\n", "b.py": "1\n"})
    build({"a.py": "1\n"})
    assert build({"a.py": "1\n", "b.py": "2\n"}).rules == []


def test_strays_are_reported_and_never_removed(output: Path, build: Any, tree: Tree) -> None:
    build({"a.py": "1\n"})
    (output / "notes").mkdir()
    (output / "notes" / "todo.txt").write_text("mine\n")
    for flags in ({}, {"clean": True, "force": True}):
        found = build({"a.py": "1\n"}, **flags)
        assert (found.code, found.rules) == (0, [("stray-file", "notes/todo.txt")])
    assert tree() == {"a.py": b"1\n", "notes/todo.txt": b"mine\n"}


def test_a_link_to_a_folder_is_a_stray_that_is_not_entered(output: Path, build: Any) -> None:
    build({"a.py": "1\n"})
    (output.parent / "elsewhere").mkdir()
    (output.parent / "elsewhere" / "many.txt").touch()
    (output / "link").symlink_to(output.parent / "elsewhere", target_is_directory=True)
    assert build({"a.py": "1\n"}).rules == [("stray-file", "link")]


def test_what_running_the_generated_code_leaves_behind_is_no_stray(output: Path, build: Any) -> None:
    build({"a.py": "1\n"})
    for path in ("__pycache__/a.pyc", ".pytest_cache/x/y", ".hypothesis/z", "loose.pyc"):
        (output / path).parent.mkdir(parents=True, exist_ok=True)
        (output / path).write_text("")
    (output / "empty" / "folder").mkdir(parents=True)
    assert build({"a.py": "1\n"}).rules == []


@pytest.mark.parametrize(
    "text", ["", "{", "<<<<<<< ours\n{}", "\xff", '{"files": []}', '{"files": {"a.py": 1}}', "[" * 100_000]
)
def test_a_damaged_manifest_is_reported_and_renewed(output: Path, build: Any, text: str) -> None:
    """Without it codegen knows nothing: files that are right stay, others are protected as foreign."""
    build({"a.py": "1\n"})
    (output / "manifest.json").write_text(text, encoding="latin-1")
    refused = build({"a.py": "2\n"})
    assert refused.rules == [("foreign-file", "a.py"), ("manifest-damaged", "manifest.json")]
    renewed = build({"a.py": "1\n"})
    assert (renewed.code, renewed.rules) == (0, [("manifest-damaged", "manifest.json")])
    assert build({"a.py": "2\n"}).rules == []


def test_after_a_merge_both_manifests_count_and_open_conflicts_are_called_so(
    output: Path, build: Any, tree: Tree
) -> None:
    """What one of two branches has written is no file of somebody else; what git wrote into is not overwritten."""
    build({"a.py": "1\n", "b.py": "1\n", "lost.py": "1\n"})
    theirs = build({"a.py": "2\n", "b.py": "2\n", "firmware/new.py": "2\n"}, clean=True) and tree()
    second = (output / "manifest.json").read_text()
    build({"a.py": "3\n", "b.py": "1\n"}, clean=True)
    first = (output / "manifest.json").read_text()
    (output / "manifest.json").write_text(f"<<<<<<< HEAD\n{first}=======\n{second}>>>>>>> other\n")
    (output / "a.py").write_text("<<<<<<< HEAD\n3\n=======\n2\n>>>>>>> other\n")
    for path in ("b.py", "firmware/new.py"):
        (output / path).parent.mkdir(exist_ok=True)
        (output / path).write_bytes(theirs[path])
    refused = build({"a.py": "4\n", "b.py": "4\n"}, vacated=("firmware/",))
    assert refused.rules == [("edited-by-hand", "a.py")], "b.py and new.py are theirs"
    (finding,) = refused.report
    assert finding.message == "a conflict of a merge is open in it, so nothing is written"
    assert finding.hint == "--force writes it anew: merge the specification alone"
    assert build({"a.py": "4\n", "b.py": "4\n"}, vacated=("firmware/",), force=True).rules == []
    assert tree() == {"a.py": b"4\n", "b.py": b"4\n"}


@pytest.mark.parametrize("text", ["[]", '{"name": "a web application"}', "3"])
def test_a_manifest_of_something_else_is_a_foreign_file(output: Path, build: Any, text: str) -> None:
    output.mkdir()
    (output / "manifest.json").write_text(text)
    assert build({"a.py": "1\n"}).rules == [("foreign-file", "manifest.json")]
    assert (output / "manifest.json").read_text() == text
    assert build({"a.py": "1\n"}, force=True).rules == []


@pytest.mark.parametrize(
    "path", ["../precious.txt", "/etc/hostname", "a/../../precious.txt", "manifest.json", "\\ud800"]
)
def test_a_manifest_that_leads_outside_is_not_believed(output: Path, build: Any, path: str) -> None:
    precious = output.parent / "precious.txt"
    precious.write_text("mine\n")
    output.mkdir()
    (output / "manifest.json").write_text(f'{{"files": {{"{path}": "{"0" * 64}"}}}}')
    found = build({"a.py": "1\n"}, clean=True, force=True)
    assert found.rules == [("manifest-damaged", "manifest.json")]
    assert precious.read_text() == "mine\n"


def test_nothing_is_written_through_a_link_that_leads_outside(output: Path, build: Any) -> None:
    """Neither a linked file nor a linked folder is followed out of the output folder, by force or otherwise.

    A link is told once, whatever lies behind it.
    """
    outside = output.parent / "outside"
    outside.mkdir()
    (outside / "file.py").write_text("mine\n")
    output.mkdir()
    (output / "linked").symlink_to(outside, target_is_directory=True)
    (output / "file.py").symlink_to(outside / "file.py")
    (output / "dangling.py").symlink_to(outside / "not-there.py")
    rendered = {"linked/new.py": "1\n", "linked/b.py": "1\n", "file.py": "1\n", "dangling.py": "1\n", "plain.py": "1\n"}
    refused = build(rendered, force=True, clean=True)
    assert refused.code == 2
    assert refused.rules == [("output-blocked", path) for path in ("dangling.py", "file.py", "linked")]
    assert {path.name: path.read_text() for path in outside.iterdir()} == {"file.py": "mine\n"}
    assert not (output / "plain.py").exists()


def test_nothing_is_removed_through_a_link_that_leads_outside(output: Path, build: Any) -> None:
    build({"a.py": "1\n", "old/b.py": "1\n"})
    os.rename(output / "old", output.parent / "outside")
    (output / "old").symlink_to(output.parent / "outside", target_is_directory=True)
    assert build({"a.py": "1\n"}, force=True, clean=True).rules == [("output-blocked", "old")]
    assert (output.parent / "outside" / "b.py").read_text() == "1\n"


def test_the_manifest_is_not_written_through_a_link(output: Path, build: Any) -> None:
    outside = output.parent / "outside.json"
    outside.write_text("{}")
    output.mkdir()
    (output / "manifest.json").symlink_to(outside)
    assert build({"a.py": "1\n"}, force=True).rules == [("output-blocked", "manifest.json")]
    assert outside.read_text() == "{}"


def test_the_output_folder_itself_may_be_a_link(output: Path, build: Any) -> None:
    """The output folder is the user's decision; only links below it are suspect."""
    real = output.parent / "real"
    real.mkdir()
    output.symlink_to(real, target_is_directory=True)
    assert build({"a/b.py": "1\n"}).rules == []
    assert (real / "a" / "b.py").read_text() == "1\n"


def test_a_link_that_stays_inside_is_replaced_by_the_file(output: Path, build: Any) -> None:
    build({"a.py": "1\n", "b.py": "1\n"})
    (output / "b.py").unlink()
    (output / "b.py").symlink_to("a.py")
    build({"a.py": "1\n", "b.py": "2\n"})
    assert not (output / "b.py").is_symlink()
    assert ((output / "a.py").read_text(), (output / "b.py").read_text()) == ("1\n", "2\n")


def test_folders_files_and_pipes_in_the_way_are_all_named(output: Path, build: Any, tree: Tree) -> None:
    output.mkdir()
    (output / "a.py").mkdir()
    (output / "b").write_text("mine\n")
    os.mkfifo(output / "c.py")
    (output / "loop.py").symlink_to("loop.py")
    refused = build({"a.py": "1\n", "b/b.py": "1\n", "c.py": "1\n", "loop.py": "1\n", "d.py": "1\n"}, force=True)
    blocked = [path for rule, path in refused.rules if rule == "output-blocked"]
    assert (refused.code, blocked) == (2, ["a.py", "b/b.py", "c.py", "loop.py"])
    assert tree() == {"b": b"mine\n"}


def test_an_output_folder_that_is_a_file_is_reported(output: Path, build: Any) -> None:
    output.write_text("mine\n")
    assert build({"a.py": "1\n"}, force=True).rules == [("output-blocked", ".")]
    assert output.read_text() == "mine\n"


def test_a_folder_that_cannot_be_made_is_reported(build: Any, monkeypatch: pytest.MonkeyPatch, output: Path) -> None:
    """A read-only place, simulated: permissions do not stop root."""

    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "makedirs", refuse)
    refused = build({"a.py": "1\n"})
    assert (refused.code, refused.rules) == (2, [("output-unwritable", "manifest.json")])
    assert not output.exists()
