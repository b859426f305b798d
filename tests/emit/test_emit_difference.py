"""The patch that ``build --diff`` prints."""

import subprocess
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.emit.difference import differences
from codegen.emit.plan import plan_output

OLD = {"a.py": "one\ntwo\nthree\n", "gone.py": "gone\n", "end.txt": "no end", "same.py": "same\n", "ff.txt": "a\fb\n"}
NEW = {"a.py": "one\n2\nthree\n", "new/n.py": "n\n", "end.txt": "an end\n", "same.py": "same\n", "empty.txt": "",
       "ff.txt": "a\fb\x85c\n"}  # fmt: skip


def patches(rendered: dict[str, str], folder: Path, **flags: bool) -> str:
    plan = plan_output(rendered, str(folder), Report(), **flags)
    assert plan is not None
    return "".join(differences(plan, str(folder.parent)))


@pytest.mark.parametrize("program", [["git", "apply", "-"], ["patch", "-p1"]])
def test_applying_the_patch_equals_building(program: list[str], output: Path, build: Any, tree: Any) -> None:
    """Changed, new, removed and empty files, and files without a last line end: all of it is in the patch."""
    build(OLD)
    patch = patches(NEW, output, clean=True)
    subprocess.run(program, cwd=output.parent, input=patch.encode(), check=True, capture_output=True)
    assert tree() == {path: text.encode() for path, text in sorted(NEW.items())}
    assert not patches(NEW, output, clean=True), "the manifest is part of the patch"


def test_no_difference_is_no_text(output: Path, build: Any) -> None:
    build(OLD)
    assert patches(OLD, output) == ""


def test_a_hand_edit_is_shown_and_an_orphan_only_if_it_would_go(output: Path, build: Any) -> None:
    build(OLD)
    (output / "a.py").write_text("one\ntwo and a half\nthree\n")
    patch = patches({path: text for path, text in OLD.items() if path != "gone.py"}, output)
    assert "-two and a half\n+two\n" in patch
    assert "generated/gone.py" not in patch


def test_bytes_that_are_no_text_are_named_and_not_shown(output: Path, build: Any) -> None:
    build(OLD)
    (output / "a.py").write_bytes(b"\xff\xfe")
    assert "Binary files a/generated/a.py and b/generated/a.py differ\n" in patches(OLD, output)
