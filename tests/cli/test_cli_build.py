"""``codegen build`` and its options: what is written, what is printed where, and the exit code."""

import json
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Rule, Severity

BROKEN = Rule("broken-table", "")
UNREADABLE = Rule("unreadable-table", "", unreadable=True)
DOUBTFUL = Rule("doubtful-table", "", Severity.WARNING)


def listing(folder: Path) -> dict[str, tuple[bytes, int]]:
    """Content and time stamp of every file below ``folder``."""
    files = [path for path in folder.rglob("*") if path.is_file()]
    return {str(path.relative_to(folder)): (path.read_bytes(), path.stat().st_mtime_ns) for path in files}


def test_build_writes_and_sums_up_on_stderr(pipeline: Any, run: Any) -> None:
    assert run("build") == (0, "", "2 files written, 0 unchanged\n")
    assert run("build") == (0, "", "up to date: 2 files\n")
    pipeline.files = {"a.py": "2\n"}
    code, out, err = run("build", "--clean")
    assert (code, out, err) == (0, "", "1 file written, 0 unchanged, 1 removed\n")
    assert not (pipeline.folder / "b").exists()


@pytest.mark.parametrize(("rule", "code"), [(BROKEN, 1), (UNREADABLE, 2)])
def test_nothing_is_written_while_the_specification_is_broken(pipeline: Any, run: Any, rule: Rule, code: int) -> None:
    pipeline.findings = [(rule, 3, "it is wrong")]
    for option in ([], ["--force"], ["--check"], ["--diff"], ["--dry-run"]):
        expected = f"specs/codegen.yaml:3:1: error {rule.id}: it is wrong\n"
        assert run("build", *option) == (code, expected, "1 error\n")
    assert not pipeline.folder.exists()


def test_warnings_do_not_stop_a_build(pipeline: Any, run: Any) -> None:
    pipeline.findings = [(DOUBTFUL, 3, "it is odd")]
    code, out, err = run("build")
    assert (code, out) == (0, "specs/codegen.yaml:3:1: warning doubtful-table: it is odd\n")
    assert err == "1 warning\n2 files written, 0 unchanged\n"


def test_a_hand_edit_is_a_finding_and_force_gives_it_up(pipeline: Any, run: Any) -> None:
    run("build")
    (pipeline.folder / "a.py").write_text("mine\n")
    code, out, err = run("build")
    assert (code, err) == (1, "1 error\n")
    assert out.startswith("generated/a.py:1:1: error edited-by-hand: ")
    assert "--force" in out
    assert (pipeline.folder / "a.py").read_text() == "mine\n"
    assert run("build", "--force") == (0, "", "1 file written, 1 unchanged\n")


def test_an_output_folder_that_is_a_file_ends_with_2(pipeline: Any, run: Any) -> None:
    pipeline.folder.write_text("mine\n")
    code, out, _ = run("build")
    assert code == 2
    assert out.startswith("generated:1:1: error output-blocked: ")


def test_check_names_every_kind_of_stale_file_and_writes_nothing(pipeline: Any, run: Any) -> None:
    pipeline.files = dict.fromkeys(("changed.py", "edited.py", "missing.py", "orphan.py", "same.py"), "1\n")
    run("build")
    assert run("build", "--check") == (0, "", "")
    (pipeline.folder / "edited.py").write_text("mine\n")
    (pipeline.folder / "missing.py").unlink()
    (pipeline.folder / "foreign.py").write_text("somebody's\n")
    pipeline.files = dict.fromkeys(("edited.py", "foreign.py", "missing.py", "same.py"), "1\n")
    pipeline.files["changed.py"] = "2\n"
    before = listing(pipeline.folder)
    code, out, err = run("build", "--check")
    assert code == 1
    named = [line.split(": error stale-output: ") for line in out.splitlines() if not line.startswith("  hint: ")]
    assert named == [
        ["generated/changed.py:1:1", "it is out of date"],
        ["generated/edited.py:1:1", "it was edited by hand"],
        ["generated/foreign.py:1:1", "it was not written by codegen"],
        ["generated/manifest.json:1:1", "it is out of date"],
        ["generated/missing.py:1:1", "it is missing"],
        ["generated/orphan.py:1:1", "it is no longer generated"],
    ]
    assert err == "6 errors\n"
    assert listing(pipeline.folder) == before


def test_check_of_a_folder_that_is_not_there_makes_none(pipeline: Any, run: Any) -> None:
    code, out, _ = run("build", "--check")
    assert (code, out.count("error stale-output: it is missing")) == (1, 3)
    assert not pipeline.folder.exists()


def test_check_sees_an_edit_of_a_file_that_would_not_change(pipeline: Any, run: Any) -> None:
    """Output that people changed must not pass because its specification did not."""
    run("build")
    (pipeline.folder / "a.py").write_text("mine\n")
    assert run("build", "--check")[0] == 1


def test_a_remembered_orphan_keeps_the_output_stale(pipeline: Any, run: Any) -> None:
    run("build")
    pipeline.files = {"a.py": "1\n"}
    code, out, _ = run("build")
    assert (code, out.splitlines()[0].split(": ")[1]) == (0, "warning no-longer-generated")
    code, out, _ = run("build", "--check")
    assert (code, out.splitlines()[0]) == (1, "generated/b/b.py:1:1: error stale-output: it is no longer generated")
    run("build", "--clean")
    assert run("build", "--check") == (0, "", "")


def test_diff_prints_a_patch_and_writes_nothing(pipeline: Any, run: Any) -> None:
    run("build")
    assert run("build", "--diff") == (0, "", "")
    pipeline.files = {"a.py": "2\n", "b/b.py": "1\n"}
    before = listing(pipeline.folder)
    code, out, err = run("build", "--diff")
    assert (code, err) == (1, "")
    start = "diff --git a/generated/a.py b/generated/a.py\n--- a/generated/a.py\n+++ b/generated/a.py\n"
    assert out.startswith(f"{start}@@ -1 +1 @@\n-1\n+2\n")
    assert listing(pipeline.folder) == before


def test_check_and_diff_together_print_both(pipeline: Any, run: Any) -> None:
    run("build")
    pipeline.files = {"a.py": "2\n", "b/b.py": "1\n"}
    code, out, _ = run("build", "--check", "--diff")
    assert code == 1
    assert out.index("error stale-output") < out.index("diff --git")


def test_diff_shows_an_empty_file_that_would_be_new(pipeline: Any, run: Any) -> None:
    pipeline.files = {"empty.py": ""}
    code, out, _ = run("build", "--diff")
    assert code == 1
    assert "diff --git a/generated/empty.py b/generated/empty.py\nnew file mode 100644\n" in out


def test_dry_run_lists_and_writes_nothing(pipeline: Any, run: Any) -> None:
    run("build")
    pipeline.files = {"a.py": "2\n", "c.py": "1\n"}
    before = listing(pipeline.folder)
    code, out, err = run("build", "--dry-run", "--clean")
    assert (code, err) == (0, "")
    assert out.splitlines() == [
        "write generated/a.py (changed)",
        "write generated/c.py (new)",
        "write generated/manifest.json (changed)",
        "remove generated/b/b.py (no longer generated)",
    ]
    assert listing(pipeline.folder) == before


def test_dry_run_tells_that_the_build_would_be_refused(pipeline: Any, run: Any) -> None:
    run("build")
    (pipeline.folder / "a.py").write_text("mine\n")
    code, out, _ = run("build", "--dry-run")
    assert code == 1
    assert "write " not in out


@pytest.mark.parametrize("options", [["--check", "--dry-run"], ["--diff", "--dry-run"], ["--check", "--force"],
                                     ["--check", "--clean"], ["--nonsense"], ["extra"]])  # fmt: skip
def test_nonsense_is_refused_before_anything_is_read(pipeline: Any, run: Any, options: list[str]) -> None:
    code, out, err = run("build", *options)
    assert (code, out) == (2, "")
    assert "codegen" in err
    assert pipeline.projects == []


def test_findings_have_the_forms_of_check(pipeline: Any, run: Any) -> None:
    """One document for each run, about the specification and about the output."""
    assert json.loads(run("build", "--format", "json")[1])["findings"] == []
    assert json.loads(run("build", "--format", "json")[1])["findings"] == []  # nothing to do
    pipeline.findings = [(DOUBTFUL, 3, "it is odd")]
    code, out, err = run("build", "--format", "github")
    assert (code, "1 warning" in err) == (0, False)
    assert out == "::warning file=specs/codegen.yaml,line=3,col=1,title=doubtful-table::it is odd\n"
    (pipeline.folder / "a.py").write_text("mine\n")
    for options in (["--check"], []):
        code, out, _ = run("build", "--format", "json", *options)
        assert code == 1
        assert {each["file"] for each in json.loads(out)["findings"]} > {"generated/a.py"}
    for option in ("--diff", "--dry-run", "--mpy=bytecode"):
        assert run("build", "--format", "json", option)[0] == 2
