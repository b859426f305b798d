"""The share of a link is told with what signatures add to each frame there."""

import shutil
from fractions import Fraction
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.diff.system.bandwidth import bandwidth_changes, compare_bandwidth
from codegen.model.price import price_on
from codegen.model.system import System
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "guarded" / "specs"
THRESHOLD = Fraction(10)
SWAPPED = "vehicle.yaml", "{wifi: signed, cable: open, radio: listed}", "{wifi: listed, cable: open, radio: signed}"


def gate(folder: Path, *changes: tuple[str, str, str]) -> System:
    """The system of the project after changes."""
    shutil.copytree(SPECS, folder)
    for name, old, new in changes:
        text = (folder / name).read_text()
        assert old in text
        (folder / name).write_text(text.replace(old, new))
    report = Report()
    (found,) = read_systems(str(folder / "codegen.yaml"), report)
    assert not report.has_errors, list(report)
    return found


@pytest.fixture
def baud(tmp_path: Path) -> tuple[str, str, str]:
    """A radio that just carries what is streamed by default, as long as nothing is signed."""
    found = gate(tmp_path / "fast")
    (radio,) = (link for link in found.links if link.name == "radio")
    return "board.yaml", "baud: 57600", f"baud: {int(price_on(radio, found).high) * 10}"


def test_a_link_that_is_signed_now_carries_more(tmp_path: Path, baud: tuple[str, str, str]) -> None:
    """Messages and rates are what they were: no row of the table changes, yet the radio carries too little."""
    old = gate(tmp_path / "old", baud)
    new = gate(tmp_path / "new", baud, SWAPPED)
    found = compare_bandwidth(old, new)
    (link,) = found.links
    assert (link.share_before, link.is_overloaded, found.is_changed) == (100, True, False)
    (change,) = bandwidth_changes(found, new, old, THRESHOLD)
    assert change.subject == "link.radio"
    assert f"at most {link.taken} of {link.capacity} bytes/s" in change.effect
