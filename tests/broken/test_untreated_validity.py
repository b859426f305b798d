"""A table that takes a field although other fields say that it is no value, or in which frame it is, is told so.

The rules are untreated-validity, untreated-frame, untreated-mask and untreated-value. The cases add one table to
tests/projects/flagged, whose own tables look at all of these.
"""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diagnostics import Report
from codegen.model.dialect.stated_frames import stated_frames
from codegen.model.dialect.stated_validity import stated_validities
from codegen.model.dialect.stated_values import stated_below
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "flagged" / "specs"
ADDED = """  added:
    doc: What a case takes.
    quantities:
      figure: {doc: A number.}
      metres: {doc: A length., unit: m}
      speed: {doc: A speed., unit: m/s}
      judge: {doc: What is looked at by code.}
      turn: {doc: How fast it turns., unit: deg/s}
      push: {doc: An acceleration., unit: m/s/s}
      bytes: {doc: A size., unit: MiB}
      degrees: {doc: An angle., unit: deg}
      percent: {doc: A share., unit: "%"}
"""
FRAMES = {
    "MISSION_ITEM.frame": "x y z",
    "SAFETY_SET_ALLOWED_AREA.frame": "p1x p1y p1z p2x p2y p2z",
    "SAFETY_ALLOWED_AREA.frame": "p1x p1y p1z p2x p2y p2z",
    "MISSION_ITEM_INT.frame": "x y z",
    "COMMAND_INT.frame": "x y z",
    "SET_POSITION_TARGET_LOCAL_NED.coordinate_frame": "x y z vx vy vz afx afy afz yaw yaw_rate",
    "POSITION_TARGET_LOCAL_NED.coordinate_frame": "x y z vx vy vz afx afy afz yaw yaw_rate",
    "SET_POSITION_TARGET_GLOBAL_INT.coordinate_frame": "alt",
    "POSITION_TARGET_GLOBAL_INT.coordinate_frame": "alt",
    "LANDING_TARGET.frame": "angle_x angle_y x y z q",
    "OBSTACLE_DISTANCE.frame": "distances angle_offset",
    "ODOMETRY.frame_id": "x y z q pose_covariance",
    "ODOMETRY.child_frame_id": "vx vy vz rollspeed pitchspeed yawspeed velocity_covariance",
    "ORBIT_EXECUTION_STATUS.frame": "x y z",
}
_SENSED = "xacc yacc zacc xgyro ygyro zgyro xmag ymag zmag abs_pressure diff_pressure pressure_alt temperature"
VALIDITIES = {
    "PARAM_REQUEST_READ.param_index": "param_id",
    "PARAM_MAP_RC.param_index": "param_id",
    "MANUAL_CONTROL.enabled_extensions": "s t aux1 aux2 aux3 aux4 aux5 aux6",
    "COMMAND_ACK.result": "progress",
    "HIGHRES_IMU.fields_updated": _SENSED,
    "OPTICAL_FLOW_RAD.quality": "integrated_x integrated_y distance",
    "HIL_SENSOR.fields_updated": _SENSED,
    "HIL_OPTICAL_FLOW.quality": "integrated_x integrated_y distance",
    "DISTANCE_SENSOR.signal_quality": "current_distance",
    "FOLLOW_TARGET.est_capabilities": "lat lon alt vel acc attitude_q rates position_cov",
    "LANDING_TARGET.position_valid": "x y z q type",
    "ESTIMATOR_STATUS.flags": "pos_horiz_accuracy pos_vert_accuracy",
    "ADSB_VEHICLE.flags": "lat lon altitude heading hor_velocity ver_velocity squawk callsign",
    "STORAGE_INFORMATION.status": "total_capacity used_capacity available_capacity",
    "CAMERA_TRACKING_IMAGE_STATUS.tracking_mode": (
        "point_x point_y radius rec_top_x rec_top_y rec_bottom_x rec_bottom_y"
    ),
    "GIMBAL_MANAGER_SET_ATTITUDE.flags": "q",
    "AUTOPILOT_STATE_FOR_GIMBAL_DEVICE.estimator_status": (
        "q vx vy vz feed_forward_angular_velocity_z angular_velocity_z"
    ),
    "AIRSPEED.flags": "airspeed raw_press temperature",
    "GLOBAL_POSITION_SENSOR.flags": "lat lon alt_ellipsoid alt eph epv",
    "AIS_VESSEL.flags": (
        "COG velocity dimension_bow dimension_stern turn_rate dimension_port dimension_starboard callsign name"
    ),
    "PARAM_EXT_REQUEST_READ.param_index": "param_id",
    "OBSTACLE_DISTANCE.increment_f": "increment",
    "ODOMETRY.quality": "x y z q vx vy vz rollspeed pitchspeed yawspeed pose_covariance velocity_covariance",
    "TRAJECTORY_REPRESENTATION_WAYPOINTS.valid_points": (
        "pos_x pos_y pos_z vel_x vel_y vel_z acc_x acc_y acc_z pos_yaw vel_yaw"
    ),
    "TRAJECTORY_REPRESENTATION_BEZIER.valid_points": "pos_x pos_y pos_z pos_yaw",
    "UTM_GLOBAL_POSITION.flags": (
        "time lat lon alt relative_alt next_lat next_lon next_alt vx vy vz h_acc v_acc uas_id"
    ),
    "OPEN_DRONE_ID_SYSTEM.classification_type": "category_eu class_eu",
}
"""All that is found in common.xml, and has been read there: the field that says so, and those of which it does."""
NEGATIVES = [
    "OPTICAL_FLOW.ground_distance", "OPTICAL_FLOW_RAD.distance", "HIL_OPTICAL_FLOW.distance",
    "ALTITUDE.altitude_terrain",
    "ALTITUDE.bottom_clearance",
]  # fmt: skip


@pytest.fixture
def checked(tmp_path, monkeypatch, capsys):
    """Check the project with one table more; return what is printed about it, and about the others."""
    shutil.copytree(SPECS, tmp_path / "specs")
    monkeypatch.chdir(tmp_path)

    def check(message="", fields=(), head=""):
        state = tmp_path / "specs" / "state.yaml"
        if message:
            state.write_text((SPECS / "state.yaml").read_text() + ADDED)
            lines = "".join(f"  {line}\n" for line in fields)
            text = f"receive: {message}\nas: added\nrequirement: FR-1.2\n{head}fields:\n{lines}"
            (tmp_path / "specs" / "receives" / "zz.yaml").write_text(text)
        main(["check"])
        out = capsys.readouterr().out
        assert " error " not in out
        return [line for line in out.splitlines() if "untreated-" in line or line.startswith("  hint:")]

    return check


def test_tables_that_look_at_what_others_say_are_right(checked):
    """Flags, bits, numbers, masks and frames, each under when, unless or where, or taken for code."""
    assert checked() == []


@pytest.mark.parametrize(
    ("message", "field", "rule", "says", "hint"),
    [
        ("MANUAL_CONTROL", "aux1: {state: added.figure%s}", "validity", "Valid data if bit 2 of enabled_extensions field is set", "write when: {enabled_extensions: bit 2}, or take it"),
        ("LANDING_TARGET", "y: {state: added.metres%s}", "validity", "contain valid target position information", "write when: {position_valid: MAV_BOOL_TRUE}, or take it"),
        ("AIS_VESSEL", "turn_rate: {state: added.turn%s}", "validity", "AIS_FLAGS_VALID_TURN_RATE", "write when: {flags: AIS_FLAGS_VALID_TURN_RATE}"),
        ("UTM_GLOBAL_POSITION", "alt: {state: added.metres%s}", "validity", "fields alt and v_acc contain valid data", "write when: {flags: UTM_DATA_AVAIL_FLAGS_ALTITUDE_AVAILABLE}"),
        ("HIGHRES_IMU", "pressure_alt: {state: added.figure%s}", "validity", "value in the pressure_alt field has been updated", "when: {fields_updated: HIGHRES_IMU_UPDATED_PRESSURE_ALT}, otherwise: unchanged"),
        ("STORAGE_INFORMATION", "used_capacity: {state: added.bytes%s}", "validity", "If storage is not ready (STORAGE_STATUS_READY", "write when: {status: STORAGE_STATUS_READY}"),
        ("DISTANCE_SENSOR", "current_distance: {state: added.metres%s}", "validity", "1 = invalid signal", "write unless: {signal_quality: 1}"),
        ("AIRSPEED", "airspeed: {state: added.speed%s}", "validity", "AIRSPEED_SENSOR_UNHEALTHY", "write unless: {flags: AIRSPEED_SENSOR_UNHEALTHY}"),
        ("OBSTACLE_DISTANCE", "increment: {state: added.degrees%s}", "validity", "ignored if increment_f is non-zero", "take it, for code to look at: increment_f: {state: ...}"),
        ("SET_POSITION_TARGET_GLOBAL_INT", "alt: {state: added.metres%s}", "frame", "is taken whatever frame coordinate_frame says", "write where: {coordinate_frame: MAV_FRAME_GLOBAL}"),
        ("ORBIT_EXECUTION_STATUS", "z: {state: added.metres%s}", "frame", "is taken whatever frame frame says", "write where: {frame: MAV_FRAME_LOCAL_NED}"),
        ("SET_POSITION_TARGET_LOCAL_NED", "vx: {state: added.speed%s}", "mask", "says with POSITION_TARGET_TYPEMASK_X_IGNORE", "unless: {type_mask: ...}"),
        ("DISTANCE_SENSOR", "signal_quality: {state: added.percent%s}", "value", "'1 = invalid signal', and it is taken as a value", "write unknown: [1]"),
        ("OPTICAL_FLOW", "ground_distance: {state: added.metres%s}", "value", "'Negative value: Unknown distance', and takes them as values", "write min: 0"),
        ("ALTITUDE", "altitude_terrain: {state: added.metres, min: -2000%s}", "value", "'Values smaller than -1000 should be interpreted as unknown'", "write min: -1000 m"),
        ("ALTITUDE", "bottom_clearance: {state: added.metres, min: -5%s}", "value", "'negative value indicates no measurement available'", "write min: 0"),
    ],
)  # fmt: skip
def test_a_field_that_is_taken_whatever_others_say_is_told(checked, message, field, rule, says, hint):
    """At its table, with the dialect's words and with what to write; the keys that say that it is meant end that."""
    found = checked(message, [field % ""])
    meant = checked(message, [field % (", unknown: []" if rule == "value" else ", when: {}")])
    told = [line for line in found if f"warning untreated-{rule}:" in line]
    assert told
    assert says in told[0]
    assert any(hint in line for line in found if line.startswith("  hint:")), found
    assert not [line for line in meant if f"warning untreated-{rule}:" in line]


@pytest.mark.parametrize(
    ("message", "fields", "head"),
    [
        ("MANUAL_CONTROL", ["aux1: {state: added.figure, when: {enabled_extensions: bit 2}}"], ""),
        ("MANUAL_CONTROL", ["s: {state: added.figure, when: {enabled_extensions: bit 0}}"], ""),  # "0 if invalid"
        ("MANUAL_CONTROL", ["aux1: {state: added.figure}", "enabled_extensions: {state: added.judge}"], ""),
        ("MANUAL_CONTROL", ["aux1: {state: added.figure}"], "where: {enabled_extensions: 4}\n"),
        ("ORBIT_EXECUTION_STATUS", ["z: {state: added.metres, when: {frame: MAV_FRAME_GLOBAL}}"], ""),
        ("ORBIT_EXECUTION_STATUS", ["z: {state: added.metres}"], "where: {frame: MAV_FRAME_GLOBAL}\n"),
        ("OPTICAL_FLOW", ["ground_distance: {state: added.metres, min: 0}"], ""),
    ],
)
def test_a_field_whose_judge_is_looked_at_is_right(checked, message, fields, head):
    """By the field, by the table, or by code that is given the other field."""
    assert checked(message, fields, head) == []


def test_where_one_field_looks_at_the_mask_others_are_told_by_their_bits(checked):
    """A field that no bit names is right then."""
    unless = "unless: {type_mask: POSITION_TARGET_TYPEMASK_VX_IGNORE}"
    fields = [f"vx: {{state: added.speed, {unless}}}", "afx: {state: added.push}", "z: {state: added.metres}"]
    found = checked("SET_POSITION_TARGET_LOCAL_NED", fields, "where: {coordinate_frame: MAV_FRAME_LOCAL_NED}\n")
    assert [line.partition("hint: ")[2] for line in found if "hint" in line] == [
        "write unless: {type_mask: POSITION_TARGET_TYPEMASK_AX_IGNORE}",
        "write unless: {type_mask: POSITION_TARGET_TYPEMASK_Z_IGNORE}",
    ]


def test_what_is_found_in_common_is_what_was_read_there():
    """Nothing more and nothing less: by fields that say so, in wire order."""
    (system, *_) = read_systems(str(SPECS / "codegen.yaml"), Report())
    dialect = system.dialect
    for stated, known in ((stated_validities, VALIDITIES), (stated_frames, FRAMES)):
        found: dict[str, str] = {}
        for message in dialect.messages.values():
            for each in stated(message, dialect.enums):
                judge = f"{message.name}.{each.judge}"
                found[judge] = f"{found.get(judge, '')} {each.field}".lstrip()
        assert found == known
    negatives = [
        f"{message.name}.{field.name}"
        for message in dialect.messages.values()
        for field in message.fields
        if stated_below(field.definition.description)
    ]
    assert negatives == NEGATIVES
