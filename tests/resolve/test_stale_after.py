"""``stale_after`` of quantities that code sets: where it means something, and who is told."""

from pathlib import Path

import pytest
from edited_project import edited

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.explain.story import explain
from codegen.targets.firmware.words import word_layout
from codegen.targets.suite.behaviour import checks_of_behaviour

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "named_tables" / "specs"
ALTITUDE = "stored: mm, stale_after: 2 s"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "{doc: Depth of the water.}",
            "{doc: d, initial: 0, stale_after: 1 s}",
            "an initial value in place of unknown",
        ),
        (
            "boolean: true, initial: false}\n      mode",
            "boolean: true, initial: false, stale_after: 1 s}\n      mode",
            "boolean",
        ),
        ("{doc: Depth of the water.}", "{doc: d, estimate_from: uptime, stale_after: 1 s}", "not set by code"),
        ("{doc: Depth of the water.}", "{doc: d, elements: cells, stale_after: 1 s}", "each of which"),
        ("{doc: Depth of the water.}", "{doc: d, invalid_after: 3}", "invalid_after says nothing"),
    ],
)
def test_where_it_says_nothing_it_is_an_error_at_its_line(old: str, new: str, said: str, folder: Path) -> None:
    """With the reason, never ignored."""
    _, findings = edited(folder, ("state.yaml", old, new))
    found = [finding for finding in findings if said in finding.message]
    assert [finding.rule.id for finding in found] == ["bad-quantity"], findings
    line = (folder / "state.yaml").read_text().splitlines()[found[0].place.line - 1]
    assert line[found[0].place.column - 1 :].startswith(("1 s", "3")), line


def test_a_word_is_kept_of_those_that_age_only(folder: Path) -> None:
    """Their time of expiry; the one of the readings stays as it is."""
    system, findings = edited(folder, ("state.yaml", "doc: The boat.", "doc: A boat."))
    assert not findings
    assert system is not None
    words = {name: block.offsets for name, block in word_layout(system).blocks.items()}
    assert {name for name in words["gps"] if name.endswith("expires_ms")} == {
        "altitude_mm_expires_ms",
        "satellites_number_expires_ms",
    }
    assert "expires_ms" in words["pack"]
    assert not any("expires" in name for name in words["vehicle"])


def test_it_is_told(folder: Path) -> None:
    """By explain, in reports of changes, and by a test of the generated suite for each."""
    system, _ = edited(folder, ("state.yaml", "doc: The boat.", "doc: A boat."))
    assert system is not None
    story = explain("gps.altitude", system, Report())
    assert story is not None
    assert "2000 ms after it was set\n" in story
    names = {check.name for check in checks_of_behaviour(system)}
    assert {"gps_altitude_is_forgotten", "gps_satellites_is_forgotten"} <= names
    other, _ = edited(folder, ("state.yaml", ALTITUDE, "stored: mm, stale_after: 3 s"))
    assert other is not None
    changes = [change for change in compare_systems((system,), (other,)).changes if change.subject == "gps.altitude"]
    assert [(change.rule.id, change.old, change.new) for change in changes] == [
        ("quantity-trust-changed", "unknown after 2000 ms", "unknown after 3000 ms")
    ]
