"""A change of a driver of the project's own is told: of its code, which only a person can judge, and of its YAML."""

import json
import shutil
from pathlib import Path

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "sensors"
CODE, YAML = "drivers/compass.py", "drivers/compass.yaml"


@pytest.fixture
def compared(tmp_path, capsys):
    """Return the changes after an edit of a file, as JSON has them."""

    def compare(file, old, new):
        for side in ("old", "new"):
            shutil.copytree(PROJECT / "specs", tmp_path / side / "specs")
            board = tmp_path / side / "specs" / "board.yaml"
            board.write_text(board.read_text().replace("{driver: compass,", "{driver: compass, requirement: FR-9.6,"))
            code = tmp_path / side / "specs" / CODE
            code.write_text(code.read_text() + "\n\nNeedle = Compass\n")
            sent = tmp_path / side / "specs" / "messages" / "gps_raw_int.yaml"
            sent.write_text(sent.read_text().replace("{state: gps.course}", "{state: compass.heading}"))
        path = tmp_path / "new" / "specs" / file
        text = path.read_text()
        assert text.count(old) == 1
        path.write_bytes(text.replace(old, new).encode())
        main(["diff", str(tmp_path / "old" / "specs"), str(tmp_path / "new" / "specs"), "--format", "json"])
        return json.loads(capsys.readouterr().out)["changes"]

    return compare


def test_other_code_needs_a_person(compared):
    """With what it reaches: the quantities' messages, their criteria, and the tests of these."""
    (change,) = compared(CODE, "begin(self)", "begin(self )")
    assert change["rule"] == "driver-code-changed"
    assert change["subject"] == "driver compass"
    assert change["weight"] == "person"
    assert change["old"] != change["new"]
    assert set(change["requirements"]) >= {"FR-9.4", "FR-9.6"}
    assert any("build_gps_raw_int" in symbol for symbol in change["symbols"])
    assert any("test_frames" in test for test in change["tests"])


def test_the_ends_of_lines_are_no_change(compared):
    """A checkout on another system has others."""
    text = (PROJECT / "specs" / CODE).read_text()
    assert compared(CODE, text, text.replace("\n", "\r\n")) == []


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("max: 359.9", "max: 180", "heading"),
        ("unit: uT, min: 0, max: 1000", "unit: uT, min: 0, max: 900", "field"),
        ("class: Compass", "class: Needle", "Needle"),
        ("stored: ddeg", "stored: cdeg", ""),
    ],
)
def test_other_yaml_is_told(compared, old, new, says):
    """What it gives, and the class that is made."""
    changes = compared(YAML, old, new)
    told = [change for change in changes if change["rule"] == "sensor-changed"]
    assert told
    assert says in str(told)
