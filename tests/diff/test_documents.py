"""docs/diff.md: its example is what the command prints, and its rules are all there are."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diff.change import ChangeRule
from codegen.findings.catalogue import rule_catalogue

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs" / "diff.md").read_text()


@pytest.mark.draft("battery_upstream")
def test_the_example_is_what_the_command_prints(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The edit of the document is made in a copy of the specification."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    for command in (["init", "-q"], ["add", "-A"], ["-c", "user.name=T", "-c", "user.email=t@e", "commit", "-qm", "m"]):
        subprocess.run(["git", *command], cwd=tmp_path, check=True)
    old, new = re.findall(r"(?m)^[-+]      (<field .*>)$", TEXT)
    overlay = tmp_path / "specs" / "dialects" / "battery_upstream.xml"
    written = overlay.read_text()
    assert written.count(old) == 1
    overlay.write_text(written.replace(old, new))
    monkeypatch.chdir(tmp_path)
    assert main(["diff", "HEAD"]) == 1
    printed = capsys.readouterr()
    shown = re.search(r"\$ codegen diff HEAD\n(.*?)\n```", TEXT, re.DOTALL)
    assert shown is not None
    assert shown[1] == f"{printed.out}{printed.err}".rstrip("\n")


def test_every_rule_is_listed_in_its_area() -> None:
    rows = dict(re.findall(r"(?m)^\| (wire|behaviour|requirements|documentation)[^|]*\| (.*) \|$", TEXT))
    rows["trace"] = rows.pop("requirements")
    listed = {area: set(re.findall(r"`([a-z-]+)`", row)) for area, row in rows.items()}
    rules = [rule for rule in rule_catalogue().values() if isinstance(rule, ChangeRule)]
    for area, names in listed.items():
        assert names == {rule.id for rule in rules if rule.area.value == area}


def test_explain_says_who_notices_and_who_breaks(capsys: pytest.CaptureFixture[str]) -> None:
    """Beside the text of the rule."""
    assert main(["explain", "field-units-changed"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("field-units-changed (codegen diff, behaviour, silent on the wire; breaks old ground ")
