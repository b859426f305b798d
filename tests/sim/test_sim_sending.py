"""Messages that a scenario sends: the bytes that pymavlink makes, at their times, and the rover's reaction."""

import json
import math
import os
import re
import struct
import subprocess
from pathlib import Path
from typing import Any

import pytest
from packs import ROOT, rover
from pymavlink.dialects.v20 import common

from codegen.cli import main
from codegen.decode.scenario import decode_scenarios
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.scenario import Sending, event_data
from codegen.resolve.scenarios.scenario import resolve_scenarios
from codegen.sim.process import Runtime, find_interpreter

MOCKS = ROOT / "templates" / "mocks"
HEAD = "scenarios:\n  a:\n    doc: d\n    duration: 10 s\n    events:\n"

SCRIPT = """
import json, sys
from sim_ground import Ground
with open(sys.argv[1]) as file:
    sendings, times, start_ms = json.load(file)
class Port:
    received = 0
    home = ("127.0.0.1", 14550)
    ends = [home, None]
    def read(self):
        return None
ground, port = Ground(sendings, start_ms), Port()
ground.speak_to(Port)
found = []
for at_ms in times:
    ground.turn(at_ms)
    heard = b""
    while True:
        data = port.read()
        if not data:
            break
        heard += data
    found.append("".join("{:02x}".format(byte) for byte in heard))
print(json.dumps([found, port.received]))
"""


def resolved(tmp_path: Path, *events: str) -> tuple[list[Any], list[tuple[str, int, int]]]:
    """The events, and the findings."""
    path = tmp_path / "own.yaml"
    path.write_text(HEAD + "".join(f"      - {{{event}}}\n" for event in events))
    report = Report()
    written = decode_scenarios(str(path), DISK, report)
    scenarios = {} if written is None else resolve_scenarios(written, rover(), report)
    found = [(finding.rule.id, finding.place.line, finding.place.column) for finding in report]
    return list(scenarios["a"].events) if "a" in scenarios else [], found


@pytest.mark.parametrize("runtime", Runtime)
def test_frames_are_those_of_pymavlink(tmp_path: Path, runtime: Runtime) -> None:
    """An entry of an enum, an amount, a text, an array's element, a multiplier, no field at all; again and again."""
    events, findings = resolved(
        tmp_path,
        "at: 0 s, send: COMMAND_LONG, fields: {command: MAV_CMD_COMPONENT_ARM_DISARM, param1: 1, param7: -0.5}",
        "at: 1 s, send: PARAM_SET, fields: {param_id: BATT_LOW_VOLT, param_value: 10.25, "
        "param_type: MAV_PARAM_TYPE_REAL32}",
        "at: 2 s, send: GPS_RAW_INT, fields: {lat: -35.3632621 deg, eph: 1.2, alt: 1 km, fix_type: 3}",
        'at: 3 s, send: BATTERY_STATUS, fields: {"voltages[1]": 3.7 V, current_battery: -1}',
        "at: 4 s, send: PING",
        "at: 5 s, send: RC_CHANNELS_OVERRIDE, fields: {chan1_raw: 1600}, every: 500 ms, for: 1 s",
        "at: 7 s, send: COMMAND_INT, fields: {param1: NaN, param2: .nan, param3: -.inf, z: .inf, x: INT32_MAX, y: -1}",
        'at: 8 s, send: GPS_STATUS, fields: {"satellite_azimuth[1]": 24 deg}',
    )
    assert findings == []
    assert all(isinstance(event, Sending) for event in events)
    times = [0, 1_000, 2_010, 3_000, 4_000, 5_000, 5_400, 5_500, 6_000, 7_000, 9_000]
    interpreter = find_interpreter(runtime)
    assert interpreter is not None
    script, data = tmp_path / "script.py", tmp_path / "data.json"
    script.write_text(SCRIPT)
    environment = {**os.environ, "MICROPYPATH": str(MOCKS), "PYTHONPATH": str(MOCKS), "PYTHONDONTWRITEBYTECODE": "1"}

    def heard(start_ms: int) -> tuple[list[bytes], int]:
        data.write_text(json.dumps([[event_data(event) for event in events], times, start_ms]))
        command = [interpreter or "", str(script), str(data)]
        done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=True)
        texts, received = json.loads(done.stdout)
        return [bytes.fromhex(text) for text in texts], received

    link = common.MAVLink(None, srcSystem=255, srcComponent=190)
    one = struct.unpack("<f", struct.pack("<f", 10.25))[0]
    override = common.MAVLink_rc_channels_override_message(1, 1, 1600, *[0] * 7)
    expected: list[Any] = [
        common.MAVLink_command_long_message(1, 1, 400, 0, 1, 0, 0, 0, 0, 0, -0.5),
        common.MAVLink_param_set_message(1, 1, b"BATT_LOW_VOLT", one, 9),
        common.MAVLink_gps_raw_int_message(0, 3, -353632621, 0, 1_000_000, 120, 0, 0, 0, 0),
        common.MAVLink_battery_status_message(0, 0, 0, 0, [0, 3_700, *[0] * 8], -1, 0, 0, 0),
        common.MAVLink_ping_message(0, 0, 1, 1),
        override,
        None,
        override,
        None,
        common.MAVLink_command_int_message(
            1, 1, 0, 0, 0, 0, math.nan, math.nan, -math.inf, 0, 0x7FFFFFFF, -1, math.inf
        ),
        common.MAVLink_gps_status_message(0, *[[0] * 20] * 3, [0, 17, *[0] * 18], [0] * 20),  # in steps of 360/255 deg
    ]
    packed = []
    for message in expected:
        packed.append(b"" if message is None else bytes(message.pack(link)))
        link.seq += message is not None
    frames, received = heard(0)
    assert frames == packed
    assert received == sum(map(len, frames))
    after_restart, _ = heard(5_200)
    assert [bool(frame) for frame in after_restart] == [at_ms in (5_500, 7_000, 9_000) for at_ms in times], (
        "nothing is sent again"
    )


BROKEN = [
    ("send: COMAND_LONG", [("scenario-send", 6, 25)]),
    ("send: COMMAND_LONG, fields: {comand: 1}", [("scenario-send", 6, 56)]),
    ("send: COMMAND_LONG, fields: {command: MAV_CMD_NONE}", [("scenario-send", 6, 57)]),
    ("send: COMMAND_LONG, fields: {confirmation: 256}", [("scenario-send", 6, 62)]),
    ("send: GPS_RAW_INT, fields: {lat: 3 V}", [("unit-mismatch", 6, 52)]),
    ("send: PARAM_SET, fields: {param_id: SEVENTEEN_LETTERS}", [("scenario-send", 6, 55)]),
    ('send: BATTERY_STATUS, fields: {"voltages[10]": 1}', [("scenario-send", 6, 66)]),
    ("send: COMMAND_INT, fields: {x: NaN}", [("scenario-send", 6, 50)]),
    ("send: COMMAND_LONG, fields: {confirmation: UINT16_MAX}", [("scenario-send", 6, 62)]),
    ("send: COMMAND_LONG, fields: {param1: none}", [("bad-amount", 6, 56)]),
    ("send: PING, for: 3 s", [("scenario-event", 6, 36)]),
    ("arm: true, every: 1 s", [("scenario-event", 6, 37)]),
    ("send: PING, every: 0 s", [("scenario-time", 6, 38)]),
]


@pytest.mark.parametrize(("event", "findings"), BROKEN)
def test_what_is_wrong_is_reported_at_its_place(tmp_path: Path, event: str, findings: list[object]) -> None:
    assert resolved(tmp_path, f"at: 1 s, {event}")[1] == findings


@pytest.mark.parametrize("runtime", Runtime)
def test_the_rover_does_what_it_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], runtime: str
) -> None:
    """It is armed by a command, its threshold is raised by a parameter, and its failsafe fires by that."""
    path = tmp_path / "own.yaml"
    path.write_text(
        HEAD.replace("10 s", "20 s")
        + "      - {at: 3 s, send: COMMAND_LONG, fields: {command: MAV_CMD_COMPONENT_ARM_DISARM, param1: 1}}\n"
        "      - {at: 4 s, send: MISSION_COUNT, fields: {count: 3}}\n"
        "      - {at: 5 s, send: PARAM_SET, fields: {param_id: BATT_LOW_VOLT, param_value: 12, param_type: 9}}\n"
        "    courses: {battery.voltage: {value: 11.5 V}}\n"
        "    expect:\n"
        "      - {at: 2.9 s, state: vehicle.armed, is: false}\n"
        "      - {at: 3.1 s, state: vehicle.armed, is: true}\n"
        "      - {at: 14 s, state: battery.failsafe, is: 0}\n"
        "      - {at: 16 s, state: battery.failsafe, is: 1}\n"
        "      - {told: battery.voltage, between: [11.49 V, 11.51 V]}\n"
    )
    monkeypatch.chdir(ROOT)
    options = ["--speed", "max", "--runtime", runtime, "--out", "udp:127.0.0.1:9", "--quiet"]
    assert main(["sim", str(path), *options]) == 0, capsys.readouterr().out
    out = capsys.readouterr().out
    assert re.search(r"\n    COMMAND_ACK +1 frames ", out)
    assert re.search(r"\n    MISSION_ACK +1 frames ", out), "what the specification does not name has its name, too"
    assert not re.search(r"\n    \d+ +\d+ frames ", out)
    assert re.search(r"\n    PARAM_VALUE +1 frames ", out)
