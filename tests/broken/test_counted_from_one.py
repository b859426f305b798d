"""A number of an instance that begins with 0 is told where the dialect's words count from 1: counted-from-one."""

import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.findings.text import finding_text
from codegen.project.systems import read_systems
from codegen.rules.counted_from_one import _words, check

SPECS = Path(__file__).resolve().parents[1] / "projects" / "three_cameras" / "specs"


def found(folder: Path, *edits: tuple[str, str, str]) -> list[str]:
    shutil.copytree(SPECS, folder / "specs")
    for file, old, new in edits:
        path = folder / "specs" / file
        assert path.read_text().count(old) == 1, old
        path.write_text(path.read_text().replace(old, new))
    report = Report()
    systems = read_systems(str(folder / "specs" / "codegen.yaml"), report)
    assert systems, [finding_text(each) for each in report]
    return [finding_text(each) for system in systems for each in check(system)]


def test_a_parameter_with_the_first_number_is_right(tmp_path: Path) -> None:
    """Its default is 1."""
    assert found(tmp_path) == []


@pytest.mark.parametrize(
    "edits",
    [
        [("state.yaml", "    first_number: CAM_FIRST\n", "")],
        [("messages/video_stream_information.yaml", "{state: camera.instance}", "{constant: 0}")],
    ],
)
def test_a_number_that_begins_with_0_is_told(tmp_path: Path, edits: list[tuple[str, str, str]]) -> None:
    """Counted or written."""
    (text,) = found(tmp_path, *edits)
    assert "warning counted-from-one: VIDEO_STREAM_INFORMATION.stream_id is 0" in text
    assert "the dialect says '1 for first, 2 for second, etc'" in text


@pytest.mark.parametrize(
    ("description", "words"),
    [
        ("Storage ID (1 for first, 2 for second, etc.)", "1 for first, 2 for second, etc"),
        ("The current mode index within number_modes, indexed from 1.", "indexed from 1"),
        ("Point index (first point is 1, 0 is for return point).", "first point is 1, 0 is for return point"),
        ("Gimbal ID (component ID or 1-6 for non-MAVLink gimbal)", "1-6 for non-MAVLink gimbal"),
        ("Camera id (1-6). 0 if it is a MAVLink camera.", "1-6"),
        ("Network ID (0 for broadcast)", "0 for broadcast"),
        ("Ids are numbered from 0 and map to IMUs numbered from 1 (e.g. IMU1 has id=0)", None),
        ("Index of this RPM sensor (0-indexed)", None),
        ("Battery ID", None),
        ("Servo output port. 0 = first 8, 1 = second 8.", None),
        ("Sensor ID, up to 10 for all", None),
    ],
)
def test_words_about_the_first_one(description: str, words: str | None) -> None:
    """Those that give the first instance another number than 0, or 0 a meaning of its own."""
    assert _words(description, is_counted=True) == words
