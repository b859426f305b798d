"""Other projects than the rover: each is built as it is, and its generated suite is green on both interpreters.

minimal has neither sensors nor machine code. two_batteries has what the rover does not: several instances, an
overlay's message with float fields, scaling with each rounding, parameters as sources, texts, elements answered one by
one, limits as amounts, and a converter of 10 bits. radio_rover is a whole vehicle without machine code: a radio and a
cable for links, a charge that is estimated, a system id that no parameter sets, and a failsafe with nothing optional.
float_fields has a message of floats that small whole numbers make, and one of those that take several words.
three_cameras says how many there are. texts has texts in fields of many sizes, and a list that withholds its message.
rows has arrays of every type that lists fill. wide_values has numbers of more than 30 bits and floats, in fields of
every type, sentinels that machine code cannot have as literals, and clocks that pass the sentinels of theirs; boat is a
boat with a receiver of satellites, without battery, converter or program. angles has quantities in degrees that fields
have in radians, and the other way, sent and received. own_dialect is written for a dialect of its own, in two files,
and has the last system id that there is. sensors has a sensor of every kind, and one with a driver of its own;
power_monitor has two channels of an ADC in one component, and a level. slow_readings has a thermometer that is read
less often than failsafes look, actions by severity with a failsafe that arming does not ask, constants for multipliers,
a range that is narrow and symmetric, components with the names of functions, a stream of minutes, and a HEARTBEAT that
is sent on connection and on a change, too. moored_buoy has failsafes and nothing
to arm. watched_boat has several of them on one quantity, too much and too little of it, and thresholds that no 0
switches off, beside each other; it speaks MAVLink 1. commanded has flags that no float of 32 bits carries.
"""

import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import COMMON, DAYS, suite_is_green
from in_process import build

PROJECTS = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
WHOLE = {"radio_rover", "guarded", "sensors", "own_dialect", "slow_readings", "watched_boat"}
"""Whose checks of the whole program run; the checks of others, whose modules are the same, are about what they have."""


@pytest.mark.parametrize("project", sorted(path.parent.name for path in PROJECTS.glob("*/specs")))
def test_project_builds_and_its_suite_is_green(project, tmp_path):
    """No error while building; no failed test in the output, and lint finds nothing in the firmware."""
    subprocess.run(["cp", "-r", str(PROJECTS / project / "specs"), str(tmp_path)], check=True)
    build(tmp_path)
    left_out = f"cpython or {DAYS}" if project in WHOLE else f"cpython or {COMMON}"
    suite_is_green(tmp_path, "generated/tests", only=f"not (test_program and ({left_out}))")
    lint = [
        str(BIN / "ruff"),
        "check",
        "--select",
        "E,F,W,B,PLE",
        "--line-length",
        "120",
        "--ignore",
        "E402",
    ]
    checked = subprocess.run([*lint, "generated"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout


@pytest.mark.parametrize("runtime", ["micropython", "cpython"])
def test_the_radio_rover_runs(runtime, tmp_path):
    """Its firmware is simulated on both interpreters: it drives, reports the voltage, and fires its failsafe."""
    subprocess.run(["cp", "-r", str(PROJECTS / "radio_rover" / "specs"), str(tmp_path)], check=True)
    build(tmp_path)
    out = ["--out", "udp:127.0.0.1:9"]
    command = [str(BIN / "codegen"), "sim", "nominal", "--speed", "max", "--runtime", runtime, *out]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "The failsafe fired: low at 6.8 s." in done.stdout
    assert "BATTERY_STATUS" in done.stdout
