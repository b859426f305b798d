"""A link that obeys others than before is a change that breaks somebody, or lets somebody in."""

import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "guarded" / "specs"

EDITS = [
    (
        "wifi: signed, cable: open, radio: listed",
        "wifi: signed, cable: listed, radio: listed",
        "access-changed",
        "cable",
    ),
    ("wifi: signed, cable: open", "wifi: listed, cable: signed", "access-changed", "wifi"),
    ("radio: listed}\n  stations: [255, 254]", "radio: signed}", "access-changed", "radio"),
    ("stations: [255, 254]", "stations: [255]", "access-changed", "radio"),
    ("setup: [cable]", "setup: []", "program-changed", "access"),
    ("setup: [cable]", "setup: [cable]\n  key: other.key", "program-changed", "access"),
]


@pytest.mark.parametrize(("old", "new", "rule", "about"), EDITS)
def test_who_is_obeyed_is_told(old: str, new: str, rule: str, about: str, tmp_path: Path) -> None:
    """Link by link; so are the key's file and the way that a new one comes."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    before = read_systems(str(SPECS / "codegen.yaml"), Report())
    path = specs / "vehicle.yaml"
    text = path.read_text()
    assert old in text
    text = text.replace(old, new)
    path.write_text(text.replace("  setup: [cable]\n", "") if "cable: open" not in text else text)
    report = Report()
    changes = compare_systems(before, read_systems(str(specs / "codegen.yaml"), report)).changes
    assert not report.has_errors
    assert [change for change in changes if change.rule.id == rule and about in str(change)], changes


def test_the_same_without_access_is_open(tmp_path: Path) -> None:
    """To take access away opens each link that was not."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    path = specs / "vehicle.yaml"
    head, _, rest = path.read_text().partition("access:\n")
    path.write_text(head + "code:" + rest.partition("code:")[2])
    before = read_systems(str(SPECS / "codegen.yaml"), Report())
    changes = compare_systems(before, read_systems(str(specs / "codegen.yaml"), Report())).changes
    found = [str(change) for change in changes if change.rule.id == "access-changed"]
    assert found
    assert all("everybody" in each for each in found)
