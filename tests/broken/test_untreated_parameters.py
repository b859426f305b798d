"""A number of a parameter to which the dialect's words give another meaning is told, and limits can be corrected.

The cases change tests/projects/commanded.
"""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main

SPECS = Path(__file__).resolve().parents[1] / "projects" / "commanded" / "specs"
SPEED = "2: {name: speed, unit: km/h, min: 0, max: 40, unchanged: [-1], default: null}"
CAPTURE = """  MAV_CMD_IMAGE_START_CAPTURE:
    doc: Takes pictures.
    method: capture
    params: {4: {name: sequence, min: 0, whole: true}}
"""
CORRECTION = """corrections:
  - enum: MAV_CMD
    entry: MAV_CMD_IMAGE_START_CAPTURE
    param: 4
    set: {%s}
    reason: Its words say that it is 0 otherwise.
    source: common.xml
"""


@pytest.fixture
def checked(tmp_path, monkeypatch, capsys):
    """Check the project with a text of commands.yaml in place of another one; return what is said."""
    shutil.copytree(SPECS, tmp_path / "specs")
    monkeypatch.chdir(tmp_path)
    commands = tmp_path / "specs" / "commands.yaml"

    def check(old, new, correction=None):
        text = commands.read_text()
        assert text.count(old) == 1
        commands.write_text(text.replace(old, new))
        if correction is not None:
            (tmp_path / "specs" / "fixed.yaml").write_text(CORRECTION % correction)
            project = tmp_path / "specs" / "codegen.yaml"
            project.write_text(project.read_text() + "corrections: [fixed.yaml]\n")
        main(["check"])
        return capsys.readouterr().out

    return check


@pytest.mark.parametrize(
    ("new", "told"),
    [
        (SPEED, []),
        ("2: {name: speed, unit: km/h}", ["-1", "-2"]),
        ("2: {name: speed}", ["-1", "-2"]),
        ("2: {name: speed, unit: km/h, unchanged: [-1]}", ["-2"]),
        ("2: {name: speed, unchanged: [-1]}", []),
        ("2: {name: speed, unit: km/h, unchanged: []}", []),
        ("2: {name: speed, unit: km/h, min: 0}", []),
        ("2: {name: speed, unit: km/h, min: -3.6}", ["-1"]),
    ],
)
def test_numbers_with_a_meaning_of_their_own_are_told(checked, new, told):
    """Unless the table lists them, denies them by its limits, or gets them as the dialect has them and lists others."""
    found = checked(SPEED, new)
    lines = [line for line in found.splitlines() if "untreated-parameter" in line]
    assert len(lines) == len(told)
    for line, number in zip(lines, told, strict=True):
        assert f"MAV_CMD_DO_CHANGE_SPEED 2 has a number with a meaning of its own, '{number} indicates" in line
        assert ("converted from m/s to km/h" in line) == ("km/h" in new)
        assert f"write unchanged: [{number}]" in found


@pytest.mark.parametrize(
    ("keys", "is_told"),
    [
        ("", True),
        (", unit: deg, min: 0, max: 360", True),
        (", unchanged: [-1]", True),
        (", default: 0", False),
        (", default: null", False),
        (", unchanged: [NaN]", False),
        (", unchanged: []", False),
    ],
)
def test_nan_with_a_meaning_that_is_denied_is_told(checked, keys, is_told):
    """The yaw of a position has NaN for the present heading, as ground stations send it: it would be refused."""
    found = checked("      2: {name: options}\n", f"      2: {{name: options}}\n      4: {{name: yaw{keys}}}\n")
    said = (
        "MAV_CMD_DO_REPOSITION 4 has a meaning for NaN, 'NaN to use the current system yaw heading mode', and without"
    )
    assert (said in found) == is_told
    assert ("write default: null (the method is then given None), or a number" in found) == is_told


@pytest.mark.parametrize(("keys", "is_told"), [("", True), (", default: 0", False), (", default: null", False)])
def test_what_stands_for_nan_in_whole_parameters_is_told(checked, keys, is_told):
    """Words about INT32_MAX of parameters 5 and 6 are words about NaN, whatever COMMAND_LONG has."""
    flap = "5: {name: flap, min: -1, max: 1, scaled: 1e7, default: null}"
    found = checked(flap, f"5: {{name: flap, min: -1, max: 1, scaled: 1e7{keys}}}")
    assert ("MAV_CMD_DO_SET_ACTUATOR 5 has a meaning for NaN, 'NaN to ignore'" in found) == is_told


def test_a_limit_of_the_dialect_can_be_corrected(checked):
    """The error about the limit says how, and with that correction it is none."""
    found = checked("  MAV_CMD_USER_2:\n", CAPTURE + "  MAV_CMD_USER_2:\n")
    assert "bad-command-parameter: 0 is beyond what the dialect allows for MAV_CMD_IMAGE_START_CAPTURE 4" in found
    assert "{enum: MAV_CMD, entry: MAV_CMD_IMAGE_START_CAPTURE, param: 4, set: {minValue: 0}}" in found


def test_a_corrected_limit_holds(checked):
    """A limit of 0 is within it."""
    found = checked("  MAV_CMD_USER_2:\n", CAPTURE + "  MAV_CMD_USER_2:\n", "minValue: 0")
    assert "error" not in found.replace("0 errors", "")


@pytest.mark.parametrize("is_answered", [True, False])
def test_a_corrected_parameter_is_explained(checked, capsys, is_answered):
    """Of a command of the project as of another one: what was set, in place of what, why, and where that stands."""
    checked("  MAV_CMD_USER_2:\n", (CAPTURE if is_answered else "") + "  MAV_CMD_USER_2:\n", "minValue: 0")
    assert main(["explain", "MAV_CMD_IMAGE_START_CAPTURE"]) == 0
    told = capsys.readouterr().out.splitlines()
    of_four = next(index for index, line in enumerate(told) if line.startswith("param 4"))
    assert "corrected    minValue: 0 in place of '1'  (specs/fixed.yaml:2:5)" in told[of_four:]
    assert "reason       Its words say that it is 0 otherwise." in told[of_four:]
    assert "stated in    common.xml" in told[of_four:]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("minValues: 0", "correction-attribute: MAV_CMD_IMAGE_START_CAPTURE 4: minValues cannot be corrected"),
        ("minValue: none", "correction-value: MAV_CMD_IMAGE_START_CAPTURE 4: minValue cannot be 'none'"),
        ("units: metres", "unknown-unit: MAV_CMD_IMAGE_START_CAPTURE 4: 'metres' is not a known unit"),
        ("enum: MAV_NONE", "correction-value: MAV_CMD_IMAGE_START_CAPTURE 4: there is no enum MAV_NONE"),
        ("minValue: 1", "obsolete-correction: the dialect already has minValue '1' for MAV_CMD_IMAGE_START_CAPTURE 4"),
    ],
)
def test_a_correction_with_a_fault_is_reported(checked, text, says):
    """At the correction."""
    found = checked("  MAV_CMD_USER_2:\n", "  MAV_CMD_USER_2:\n", text)
    assert says in found
    assert "specs/fixed.yaml:5:" in found


def test_a_correction_of_no_parameter_is_reported(checked, tmp_path):
    """With those that the command has."""
    checked("  MAV_CMD_USER_2:\n", "  MAV_CMD_USER_2:\n", "minValue: 0")
    fixed = tmp_path / "specs" / "fixed.yaml"
    fixed.write_text(fixed.read_text().replace("param: 4", "param: 9"))
    found = checked("  MAV_CMD_USER_2:\n", "  MAV_CMD_USER_2:\n")
    assert "specs/fixed.yaml:4:12: error correction-unknown: MAV_CMD_IMAGE_START_CAPTURE has no parameter 9" in found
