"""A correction that contradicts the dialect's unit is told, with what that means to others, and can be waived."""

import json
import re
import shutil
from pathlib import Path

import pytest
from in_process import codegen

COMMANDED = Path(__file__).resolve().parents[1] / "projects" / "commanded" / "specs"
DRAFT = """<mavlink>
  <messages>
    <message id="50123" name="TANK">
      <description>A tank.</description>
      <field type="uint16_t" name="level" units="m" invalid="UINT16_MAX">Level.</field>
    </message>
  </messages>
</mavlink>
"""


def told(folder: Path, correction: str, rule: str = "corrected-unit") -> list[str]:
    """What a rule says of one correction of a project that has an overlay."""
    shutil.copytree(COMMANDED, folder / "specs")
    (folder / "specs" / "dialects" / "tank.xml").write_text(DRAFT)
    (folder / "specs" / "fix.yaml").write_text(f"corrections:\n  - {{{correction}, reason: so, source: me}}\n")
    project = folder / "specs" / "codegen.yaml"
    overlays = "overlays: [dialects/command_cancel.xml"
    assert overlays in project.read_text()
    text = project.read_text().replace(overlays, f"{overlays}, dialects/tank.xml")
    project.write_text(f"{text.rstrip()}\ncorrections: [fix.yaml]\n")
    done = codegen(folder, "check")
    assert done.returncode == 0, done.stdout
    return re.findall(rf"(?m)^specs/fix.yaml:2:5: warning {rule}: (.*)$", done.stdout)


@pytest.mark.parametrize(
    ("correction", "words"),
    [
        (
            "message: ALTITUDE, fields: altitude_*, set: {units: cm}",
            "ALTITUDE.altitude_monotonic: the dialect says units 'm', and 'cm' takes the place of it: "
            "to others it is 100 times as much",
        ),
        (
            "enum: MAV_CMD, entry: MAV_CMD_NAV_LOITER_TIME, param: 1, set: {units: min}",
            "MAV_CMD_NAV_LOITER_TIME 1: the dialect says units 's', and 'min' takes the place of it: "
            "to others it is 1/60 times as much",
        ),
        (
            "message: ATTITUDE, field: roll, set: {units: m}",
            "ATTITUDE.roll: the dialect says units 'rad', and 'm' takes the place of it, "
            "which is a length and not an angle",
        ),
        (
            "message: ATTITUDE, field: roll, set: {units: deg}",
            "ATTITUDE.roll: the dialect says units 'rad', and 'deg' takes the place of it",
        ),
        (
            'message: ATTITUDE, field: roll, set: {units: ""}',
            "ATTITUDE.roll: the dialect says units 'rad', and the correction takes it away",
        ),
        (
            'message: GPS_RAW_INT, field: eph, set: {multiplier: "1E-1"}',
            "GPS_RAW_INT.eph: the dialect says multiplier '1E-2', and '1E-1' takes the place of it",
        ),
    ],
)
def test_another_unit_is_told(tmp_path: Path, correction: str, words: str) -> None:
    """Once for all fields of a pattern, and whatever the project does with the message."""
    assert told(tmp_path, correction) == [words]


@pytest.mark.parametrize(
    "correction",
    [
        'message: RC_CHANNELS, field: rssi, set: {units: "%"}',  # the dialect says it in words only
        'message: GPS_RAW_INT, field: eph, set: {multiplier: "0.01"}',
        "message: HIGHRES_IMU, field: xacc, set: {units: m/s^2}",
        "message: ALTITUDE, field: altitude_local, set: {description: In metres.}",
        "message: TANK, field: level, set: {units: cm}",
    ],
)
def test_what_contradicts_nobody_is_not(tmp_path: Path, correction: str) -> None:
    """A unit where there was none, other spellings of numbers and units, other attributes, and drafts of a project."""
    assert told(tmp_path, correction) == []


@pytest.mark.parametrize(
    ("correction", "words"),
    [
        (
            'message: ALTITUDE, fields: altitude_*, set: {invalid: "0"}',
            [],  # the dialect states none
        ),
        (
            'message: SYS_STATUS, field: current_battery, set: {invalid: "0"}',
            ["SYS_STATUS.current_battery: the dialect says invalid '-1', and '0' takes the place of it"],
        ),
        (
            'message: BATTERY_STATUS, field: voltages, set: {invalid: "[UINT16_MAX:]"}',
            ["BATTERY_STATUS.voltages: the dialect says invalid '[UINT16_MAX]', and '[UINT16_MAX:]' takes the place"],
        ),
        ('message: BATTERY_STATUS, field: voltages, set: {invalid: "[65535]"}', []),
        ('message: TANK, field: level, set: {invalid: "0"}', []),
        (
            "message: SYS_STATUS, field: current_battery, set: {invalid: ''}",
            ["SYS_STATUS.current_battery: the dialect says invalid '-1', and the correction takes it away"],
        ),
        (
            "enum: MAV_TYPE, entry: MAV_TYPE_ROCKET, set: {value: 99}",
            ["MAV_TYPE_ROCKET: the dialect says value '9', and '99' takes the place of it"],
        ),
        ("enum: MAV_RESULT, entry: MAV_RESULT_CANCELLED, set: {value: 99}", []),  # an overlay has it
        (
            "message: ADSB_VEHICLE, field: emitter_type, set: {enum: MAV_TYPE}",
            ["ADSB_VEHICLE.emitter_type: the dialect says enum 'ADSB_EMITTER_TYPE', and 'MAV_TYPE' takes"],
        ),
        (
            "enum: MAV_CMD, entry: MAV_CMD_DO_WINCH, param: 2, set: {enum: MAV_STATE}",
            ["MAV_CMD_DO_WINCH.2: the dialect says enum 'WINCH_ACTIONS', and 'MAV_STATE' takes the place of it"],
        ),
    ],
)
def test_another_meaning_is_told(tmp_path: Path, correction: str, words: list[str]) -> None:
    """Of what the dialect states, by which who receives the message goes; in another spelling it is the same."""
    found = told(tmp_path, correction, "corrected-meaning")
    assert len(found) == len(words), found
    assert all(map(str.startswith, found, words)), found


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("minValue: abc", "load: minValue is 'abc'"),
        ("multiplier: 0", "load: multiplier is '0'"),
        ("increment: abc", "load: increment is 'abc'"),
        ("default: abc", "load: default is 'abc'"),
        ("minValue: 5, maxValue: 3", "load: minValue 5 is above maxValue 3"),
    ],
)
def test_a_number_that_cannot_be_is_told_at_the_correction(tmp_path: Path, text: str, says: str) -> None:
    """Not in the file of pymavlink, in which nothing is wrong."""
    shutil.copytree(COMMANDED, tmp_path / "specs")
    correction = f"{{message: SYS_STATUS, field: load, set: {{{text}}}, reason: so, source: me}}"
    (tmp_path / "specs" / "fix.yaml").write_text(f"corrections:\n  - {correction}\n")
    with (tmp_path / "specs" / "codegen.yaml").open("a") as project:
        project.write("\ncorrections: [fix.yaml]\n")
    done = codegen(tmp_path, "check")
    assert f"specs/fix.yaml:2:45: error field-number: {says}" in done.stdout, done.stdout


def test_it_can_be_waived(tmp_path: Path) -> None:
    """As findings of documents can be: by its fingerprint."""
    assert len(told(tmp_path, "message: ALTITUDE, field: altitude_local, set: {units: cm}")) == 1
    found = json.loads(codegen(tmp_path, "check", "--format", "json").stdout)["findings"]
    (fingerprint,) = [each["fingerprint"] for each in found if each["rule"] == "corrected-unit"]
    waiver = {"id": "W-1", "rule": "corrected-unit", "document": "fix.yaml", "fingerprint": fingerprint}
    waiver |= {"reason": "The receiver is ours.", "owner": "Ada", "expires": "2099-01-01"}
    (tmp_path / "specs" / "waivers.yaml").write_text(json.dumps({"waivers": [waiver]}))
    done = codegen(tmp_path, "check")
    assert (done.returncode, done.stdout) == (0, ""), done.stdout
    assert "1 waived" in done.stderr, done.stderr
