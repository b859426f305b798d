"""beyond-stated-range tells a quantity whose limits go beyond what the words of its field allow, and no other.

The cases add a quantity and a table to tests/projects/satellites.
"""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diagnostics import Report
from codegen.model.dialect.stated_range import stated_range
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "satellites" / "specs"
NMEA = "sources:\n  sky: {driver: nmea, uart: 1, tx: 8, rx: 9, requirement: FR-1.1}\n"
RANGES = {
    (0, 1000): ["SYS_STATUS.load"],
    (0, 35999): [
        "GPS_RAW_INT.cog", "GLOBAL_POSITION_INT.hdg", "HIL_GPS.cog", "GPS2_RAW.cog", "OPEN_DRONE_ID_LOCATION.direction",
    ],
    (-3.14159, 3.14159): ["ATTITUDE.roll", "ATTITUDE.pitch", "ATTITUDE.yaw"],
    (0, 254): [
        "RC_CHANNELS_SCALED.rssi", "RC_CHANNELS_RAW.rssi", "RC_CHANNELS.rssi", "HIL_RC_INPUTS_RAW.rssi",
        "RADIO_STATUS.rssi", "RADIO_STATUS.remrssi", "RADIO_STATUS.noise", "RADIO_STATUS.remnoise",
    ],
    (-1000, 1000): [
        "MANUAL_CONTROL.x", "MANUAL_CONTROL.y", "MANUAL_CONTROL.z", "MANUAL_CONTROL.r", "MANUAL_CONTROL.s",
        "MANUAL_CONTROL.t", "MANUAL_CONTROL.aux1", "MANUAL_CONTROL.aux2", "MANUAL_CONTROL.aux3",
        "MANUAL_CONTROL.aux4", "MANUAL_CONTROL.aux5", "MANUAL_CONTROL.aux6",
    ],
    (0, 360): ["VFR_HUD.heading"],
    (0, 100): [
        "VFR_HUD.throttle", "BATTERY_STATUS.battery_remaining", "CAMERA_SETTINGS.zoomLevel",
        "CAMERA_SETTINGS.focusLevel",
    ],
    (0, 255): ["MANUAL_SETPOINT.mode_switch", "MANUAL_SETPOINT.manual_override_switch"],
    (0, 1): [
        "MANUAL_SETPOINT.thrust", "HIL_CONTROLS.throttle", "CAMERA_TRACKING_IMAGE_STATUS.point_x",
        "CAMERA_TRACKING_IMAGE_STATUS.point_y", "CAMERA_TRACKING_IMAGE_STATUS.radius",
        "CAMERA_TRACKING_IMAGE_STATUS.rec_top_x", "CAMERA_TRACKING_IMAGE_STATUS.rec_top_y",
        "CAMERA_TRACKING_IMAGE_STATUS.rec_bottom_x", "CAMERA_TRACKING_IMAGE_STATUS.rec_bottom_y",
        "CAMERA_THERMAL_RANGE.max_point_x", "CAMERA_THERMAL_RANGE.max_point_y", "CAMERA_THERMAL_RANGE.min_point_x",
        "CAMERA_THERMAL_RANGE.min_point_y",
    ],
    (-1, 1): [
        "SET_ATTITUDE_TARGET.thrust", "ATTITUDE_TARGET.thrust", "HIL_CONTROLS.roll_ailerons",
        "HIL_CONTROLS.pitch_elevator", "HIL_CONTROLS.yaw_rudder", "HIL_CONTROLS.aux1", "HIL_CONTROLS.aux2",
        "HIL_CONTROLS.aux3", "HIL_CONTROLS.aux4", "HIL_ACTUATOR_CONTROLS.controls",
        "SET_ACTUATOR_CONTROL_TARGET.controls", "ACTUATOR_CONTROL_TARGET.controls",
        "GIMBAL_MANAGER_SET_MANUAL_CONTROL.pitch", "GIMBAL_MANAGER_SET_MANUAL_CONTROL.yaw",
        "GIMBAL_MANAGER_SET_MANUAL_CONTROL.pitch_rate", "GIMBAL_MANAGER_SET_MANUAL_CONTROL.yaw_rate",
    ],
    (1, 100): ["DATA_TRANSMISSION_HANDSHAKE.jpg_quality"],
    (0, 5): ["ISBD_LINK_STATUS.signal_quality"],
    (0, 15): ["OPEN_DRONE_ID_AUTHENTICATION.data_page", "OPEN_DRONE_ID_AUTHENTICATION.last_page_index"],
    (1, 9): ["OPEN_DRONE_ID_MESSAGE_PACK.msg_pack_size"],
}  # fmt: skip
"""All that is found in common.xml, and has been read there, by the ends on the wire."""


@pytest.fixture(scope="module")
def dialect():
    """The dialect of the project."""
    (system, *_) = read_systems(str(SPECS / "codegen.yaml"), Report())
    return system.dialect


@pytest.fixture
def checked(dialect, tmp_path, monkeypatch, capsys):
    """Check the project with one field that a quantity fills; return the warnings and hints of the rule."""
    shutil.copytree(SPECS, tmp_path / "specs")
    monkeypatch.chdir(tmp_path)

    def check(message, field, quantity, keys=""):
        state = tmp_path / "specs" / "state.yaml"
        state.write_text(
            state.read_text() + f"  way:\n    doc: w\n    quantities:\n      told: {{doc: d, {quantity}}}\n"
        )
        if "source:" in quantity:
            board = tmp_path / "specs" / "board.yaml"
            board.write_text(board.read_text() + NMEA)
        text = f"message: {message}\nas: told\nrequirement: FR-1.1\nstream: only\nfields:\n"
        text += f"  {field}: {{state: way.told{keys}}}\n"
        for other in dialect.messages[message].fields:
            if other.name != field:
                text += f"  {other.name}: {'{constant: 0}' if other.sentinel is None else 'unknown'}\n"
            elif other.sentinel is None:
                text = f"send: while_known\n{text}"
        (tmp_path / "specs" / "messages" / "told.yaml").write_text(text)
        main(["check"])
        out = capsys.readouterr().out.splitlines()
        assert not [line for line in out if " error " in line], out
        return [" ".join(out[at : at + 2]) for at, line in enumerate(out) if "warning beyond-stated-range:" in line]

    return check


@pytest.mark.parametrize(
    ("message", "field", "quantity", "says", "hint"),
    [
        ("ATTITUDE", "yaw", "unit: deg, stored: cdeg, source: sky.course, stale_after: 2 s", "way.told goes up to 359.99 deg, and the words of ATTITUDE.yaw say '-pi..+pi'", "fill it with a quantity from -180 to 180 deg"),
        ("ATTITUDE", "roll", "unit: rad, min: -4, max: 4", "goes down to -4 and up to 4 rad", "from -3.14159 to 3.14159 rad"),
        ("GLOBAL_POSITION_INT", "hdg", "unit: deg, stored: cdeg, min: 0, max: 360", "goes up to 360 deg, and the words of GLOBAL_POSITION_INT.hdg say '0.0..359.99 degrees'", "from 0 to 359.99 deg"),
        ("VFR_HUD", "throttle", "unit: '%', min: 0, max: 120", "goes up to 120 %", "from 0 to 100 %"),
        ("MANUAL_SETPOINT", "thrust", "min: -1, max: 1", "goes down to -1, and the words of MANUAL_SETPOINT.thrust say '0 .. 1'", "from 0 to 1;"),
        ("OPEN_DRONE_ID_LOCATION", "direction", "unit: deg, stored: cdeg, min: 0, max: 360", "say '0 - 35999 centi-degrees'", "from 0 to 359.99 deg"),
    ],
)  # fmt: skip
def test_limits_beyond_the_words_are_told(checked, message, field, quantity, says, hint):
    """Those of the table or of a sensor, at each end, at the line of the field, with the range in the quantity's unit."""
    (found,) = checked(message, field, quantity)
    assert found.startswith(("specs/messages/told.yaml:6:", "specs/messages/told.yaml:7:"))
    assert says in found
    assert hint in found


def test_a_constant_and_a_parameter_beyond_the_words(checked, tmp_path):
    """Where no quantity fills the field, too."""
    parameters = tmp_path / "specs" / "parameters.yaml"
    line = "  WAY: {doc: d, unit: deg, default: 0, min: -90, max: 270, step: 1}\n"
    parameters.write_text((parameters.read_text() if parameters.exists() else "parameters:\n") + line)
    other = tmp_path / "specs" / "messages" / "other.yaml"
    other.write_text(
        "message: ATTITUDE\nas: other\nrequirement: FR-1.1\nstream: only\nothers: unknown\nfields:\n"
        "  time_boot_ms: {clock: boot}\n  roll: {constant: 4 rad}\n  pitch: {constant: 180 deg}\n"
        "  yaw: {parameter: WAY}\n  rollspeed: {constant: 9}\n  pitchspeed: {constant: 0}\n  yawspeed: {constant: 0}\n"
    )
    roll, yaw = checked("VFR_HUD", "heading", "unit: deg, min: 0, max: 360")
    assert (
        "roll is 4 rad, and the words of ATTITUDE.roll say '-pi..+pi'   hint: write one from -3.14159 to 3.14159"
        in roll
    )
    assert "WAY goes up to 270 deg, and the words of ATTITUDE.yaw say '-pi..+pi'   hint: fill it with a para" in yaw


@pytest.mark.parametrize(
    ("message", "field", "quantity", "keys"),
    [
        ("ATTITUDE", "yaw", "unit: rad, min: -3.1416, max: 3.1416", ""),
        ("ATTITUDE", "yaw", "unit: deg, stored: cdeg, min: -180, max: 180", ""),
        ("ATTITUDE", "yaw", "unit: rad", ""),
        ("ATTITUDE", "yaw", "unit: deg, stored: cdeg, min: 0, max: 360", ", max: 180"),
        ("ATTITUDE", "yaw", "unit: deg, stored: cdeg, min: -180, max: 360", ", max: 200"),
        ("ATTITUDE", "yawspeed", "unit: rad/s, min: -10, max: 10", ""),
        ("GLOBAL_POSITION_INT", "hdg", "unit: deg, stored: cdeg, min: 0, max: 359.99", ""),
        ("SET_ATTITUDE_TARGET", "thrust", "min: -1, max: 1", ""),
        ("VFR_HUD", "heading", "unit: deg, min: 0, max: 360", ""),
    ],
)
def test_what_keeps_to_the_words_or_says_nothing_is_right(checked, message, field, quantity, keys):
    """Within, rounded ends, no limits at all, a field that its table limits on purpose, and fields without a range."""
    assert checked(message, field, quantity, keys) == []


def test_what_is_found_in_common_is_what_was_read_there(dialect):
    """Nothing more and nothing less: cells 1 to 10, entries 0-1 and ids such as 1-6 are no ranges."""
    found: dict[tuple[float, float], set[str]] = {}
    for message in dialect.messages.values():
        for field in message.fields:
            stated = stated_range(field)
            if stated is not None:
                ends = round(float(stated.low), 5), round(float(stated.high), 5)
                found.setdefault(ends, set()).add(f"{message.name}.{field.name}")
    assert found == {ends: set(names) for ends, names in RANGES.items()}
