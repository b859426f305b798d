"""A field that other fields of its message say to be no value sets none, whatever its number: frames by pymavlink.

Expected values are worked out by hand; the program of tests/projects/flagged receives them, on three interpreters.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite
from in_process import build
from pymavlink.dialects.v10 import common as v1
from pymavlink.dialects.v20 import common

SPECS = Path(__file__).resolve().parent / "flagged" / "specs"
BIN = Path(sys.executable).parent
HERE = 42
SCRIPT = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
from program_bench import Port, Craft, run_passes

results = {}
paths, cases = json.loads(open("frames.json").read())
for name in cases:
    craft = Craft(ports=[Port()])
    for path in paths:  # a vehicle of the bench knows some value of everything
        owner, _, quantity = path.partition(".")
        setattr(getattr(craft.state, owner), quantity, None)
    for frame in cases[name]:
        craft.connections[0].port.arrives(bytes.fromhex(frame))
        run_passes(craft, 4)
    results[name] = [str(getattr(getattr(craft.state, path.split(".")[0]), path.split(".")[1])) for path in paths]
    assert not craft.connections[0].faults
print(json.dumps(results))
"""
PATHS = (
    "stick.first", "stick.sixth", "other.lat_dege7", "other.height_cm", "other.name", "other.has_squawk",
    "sonar.distance_cm", "sonar.w", "sonar.z", "pad.x_mm", "target.north_mm_s", "target.yaw",
)  # fmt: skip


def frame(message, dialect=common):
    """A frame as hexadecimal digits, of some ground station."""
    return message.pack(dialect.MAVLink(None, srcSystem=255, srcComponent=190)).hex()


def stick(enabled, first=0, sixth=0):
    return frame(common.MAVLink_manual_control_message(HERE, 0, 0, 0, 0, 0, 0, enabled, 0, 0, first, 0, 0, 0, 0, sixth))


def other(flags, lat=0, altitude=0, name=b"", kind=0, squawk=0):
    return frame(
        common.MAVLink_adsb_vehicle_message(7, lat, 0, kind, altitude, 0, 0, 0, name, 0, 0, flags, squawk),
    )


def sonar(distance, quality=None, kind=0, turned=(0, 0, 0, 0)):
    if quality is None:  # MAVLink 1 has no quality
        return frame(v1.MAVLink_distance_sensor_message(0, 1, 900, distance, kind, 0, 0, 0), v1)
    return frame(
        common.MAVLink_distance_sensor_message(0, 1, 900, distance, kind, 0, 0, 0, 0, 0, turned, quality),
    )


def pad(x, valid, frame_of=common.MAV_FRAME_LOCAL_NED):
    return frame(
        common.MAVLink_landing_target_message(0, 0, frame_of, 0, 0, 0, 0, 0, x, 0, 0, [1, 0, 0, 0], 0, valid),
    )


def target(mask, north=0.0, yaw=0.0):
    frame_of = common.MAV_FRAME_LOCAL_NED
    return frame(
        common.MAVLink_set_position_target_local_ned_message(
            0, HERE, 1, frame_of, mask, 0, 0, 0, north, 0, 0, 0, 0, 0, yaw, 0
        ),
    )


CASES = {
    "a sender without extensions says nothing of the first axis": (
        [stick(0xFF, 500, 9), stick(0)],
        {"stick.sixth": "9"},
    ),
    "its own bit alone decides": ([stick(4, 500, 7)], {"stick.first": "500"}),
    "of several flags all have to be set": ([stick(0x84, 1, 7)], {"stick.first": "1", "stick.sixth": "7"}),
    "without one of them it stays as it was": (
        [stick(0x84, 1, 7), stick(4, 2, 8)],
        {"stick.first": "2", "stick.sixth": "7"},
    ),
    "a position that is not valid is unknown": (
        [other(1 | 2 | 256 | 16, 10, 5000, b"one", squawk=7), other(256 | 16, 20, 6000, b"two", squawk=0)],
        {"other.name": "two", "other.has_squawk": "False"},
    ),
    "a flag in the high byte counts": ([other(2, 0, 5000)], {"other.has_squawk": "False"}),
    "a flag that may not be set": ([other(2 | 256 | 64, 0, 5000)], {"other.has_squawk": "False"}),
    "the values are taken with their flags": (
        [other(1 | 2 | 256 | 16, 10, 5000, b"one", squawk=7)],
        {"other.lat_dege7": "10", "other.height_cm": "500", "other.name": "one", "other.has_squawk": "True"},
    ),
    "a boolean stays as it was": (
        [other(0, squawk=7), other(0, squawk=0, kind=common.ADSB_ALTITUDE_TYPE_GEOMETRIC)],
        {"other.has_squawk": "True"},
    ),
    "a quality that means invalid": ([sonar(150, 50), sonar(160, 1)], {}),
    "any other quality": ([sonar(150, 2)], {"sonar.distance_cm": "150"}),
    "a kind of sensor that is denied": ([sonar(150, 50), sonar(160, 50, kind=4)], {}),
    "MAVLink 1 lacks the quality, which reads as 0": ([sonar(150, 1), sonar(160)], {"sonar.distance_cm": "160"}),
    "a sensor that is not turned, nor at an unknown angle": (
        [sonar(150, 50, turned=(1, 0, 0, 0))],
        {"sonar.distance_cm": "150", "sonar.w": "1.0", "sonar.z": "0.0"},
    ),
    "half a turn": (
        [sonar(150, 50, turned=(0, 0, 0, 1))],
        {"sonar.distance_cm": "150", "sonar.w": "0.0", "sonar.z": "1.0"},
    ),
    "an element that is not taken says that all are known": (
        [sonar(150, 50, turned=(0, 1, 0, 0))],
        {"sonar.distance_cm": "150", "sonar.w": "0.0", "sonar.z": "0.0"},
    ),
    "all elements together say that it is unknown": (
        [sonar(150, 50, turned=(1, 0, 0, 0)), sonar(160, 50)],
        {"sonar.distance_cm": "160"},
    ),
    "a target that is not valid": ([pad(3.0, 1), pad(0.0, 0)], {}),
    "a target in one of the frames": ([pad(3.0, 1, common.MAV_FRAME_LOCAL_FRD)], {"pad.x_mm": "3000"}),
    "a target in another frame": ([pad(3.0, 1), pad(4.0, 1, common.MAV_FRAME_BODY_NED)], {}),
    "a speed that is to be ignored": ([target(0, 2.0, 0.5), target(8, 3.0, 0.25)], {"target.yaw": "0.25"}),
    "a yaw that is to be ignored stays": (
        [target(0, 2.0, 0.5), target(1024, 3.0, 0.25)],
        {"target.yaw": "0.5", "target.north_mm_s": "3000"},
    ),
    "any of several flags denies it": (
        [target(0, 2.0, 0.5), target(512, 3.0, 0.25)],
        {"target.yaw": "0.5", "target.north_mm_s": "3000"},
    ),
}
BITES = {
    "wire[13] & 0x4 != 0x4": ("wire[13] & 0x4 == 0x4", "MANUAL_CONTROL-aux1-no-value-1-"),
    "wire[13] & 0x84 != 0x84": ("wire[13] & 0x80 != 0x80", "MANUAL_CONTROL-aux6-no-value-2-"),
    "wire[38] == 1 or wire[38] == 3": ("wire[38] == 1", "DISTANCE_SENSOR-current_distance-no-value-2-"),
    "wire[49] & 0x4 == 0x4 or wire[49] & 0x2 == 0x2": (
        "wire[49] & 0x4 == 0x4",
        "SET_POSITION_TARGET_LOCAL_NED-yaw-no-value-2-",
    ),
}
"""Faults of the firmware that the generated suite has to notice, each with the start of a case that does."""


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The folder in which the project is built, with what arrives."""
    folder = tmp_path_factory.mktemp("flagged")
    shutil.copytree(SPECS, folder / "specs")
    build(folder)
    (folder / "receive.py").write_text(SCRIPT)
    (folder / "frames.json").write_text(json.dumps([PATHS, {name: steps for name, (steps, _) in CASES.items()}]))
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_others_say_to_be_no_value_sets_none(interpreter, built):
    """Flags and numbers, all and any, in low and high bytes, of extensions, and what stays as it was."""
    command = [str(BIN / interpreter), "receive.py"]
    done = subprocess.run(command, cwd=built, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    for name, (_, known) in CASES.items():
        values = {path: value for path, value in zip(PATHS, found[name], strict=True) if value != "None"}
        assert values == {"other.has_squawk": "False"} | known, name


def test_the_generated_suite_bites(built):
    """A flag that is not looked at, or the wrong way round, is noticed by the case that is about it."""
    plain = built / "generated" / "firmware" / "receiving_plain.py"
    text = plain.read_text()
    for old, (new, noticed) in BITES.items():
        assert old in text, old
        plain.write_text(text.replace(old, new, 1))
        shutil.rmtree(plain.parent / "__pycache__", ignore_errors=True)  # of one size and second it would be taken
        done = run_suite(built, "generated/tests/test_receives.py", options=("-k", "cpython", "--tb=no"))
        assert f"[cpython-{noticed}" in done.stdout, (noticed, done.stdout[-2000:])
    plain.write_text(text)
