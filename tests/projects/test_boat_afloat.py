"""The boat in the simulation: what the courses of a scenario say arrives at pymavlink over UDP, and is kept as data."""

import json
import math
import socket
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from in_process import build
from pymavlink.dialects.v20 import ardupilotmega

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent


@pytest.fixture(scope="module")
def boat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the boat is built, with a program around its telemetry."""
    folder = tmp_path_factory.mktemp("afloat")
    subprocess.run(["cp", "-r", str(HERE / "boat" / "specs"), str(folder)], check=True)
    for file in (HERE / "boat" / "afloat").iterdir():
        (folder / "specs" / file.name).write_bytes(file.read_bytes())
    build(folder)
    return folder


def sail(boat: Path, scenario: str, *options: str) -> tuple[Any, list[Any]]:
    """Return the output of the command, and the messages that were heard."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as station:
        station.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
        station.bind(("127.0.0.1", 0))
        out = f"udp:127.0.0.1:{station.getsockname()[1]}"
        command = [str(BIN / "codegen"), "sim", scenario, "--speed", "max", "--out", out, *options]
        done = subprocess.run(command, cwd=boat, capture_output=True, text=True, check=False, timeout=120)
        station.setblocking(False)
        parser, found = ardupilotmega.MAVLink(None), []
        while True:
            try:
                found += parser.parse_buffer(station.recv(2048)) or []
            except BlockingIOError:
                return done, found


@pytest.mark.parametrize("runtime", ["micropython", "cpython"])
def test_what_is_true_arrives(boat: Path, runtime: str) -> None:
    """Position and attitude follow their courses; a fault keeps one from being set until it is no longer believed."""
    record = boat / f"{runtime}.json"
    done, messages = sail(boat, "buoy", "--runtime", runtime, "--record", str(record))
    assert done.returncode == 0, done.stdout + done.stderr
    positions = [message for message in messages if message.get_type() == "GPS_RAW_INT"]
    assert len(positions) > 50
    for message in positions:
        at_s = message.time_usec / 1e6
        true = -353632621 + at_s * 1000
        # Set ten times a second; what was set last stands for 2 s while nothing sets it.
        assert -110 <= message.lat - true <= 1 or (8 <= at_s <= 10.1 and true - 2_200 <= message.lat < true)
        assert (message.lon, message.alt, message.alt_ellipsoid, message.h_acc) == (1396900000, 12500, -33250, 1750)
        assert message.eph == 120
        assert message.fix_type == (2 if at_s < 5.0 else 3) or abs(at_s - 5) < 0.12
        assert message.satellites_visible == (9 if at_s < 15.9 else 255) or abs(at_s - 16) < 0.6
    times = [message.time_usec / 1e6 for message in positions]
    assert not [at_s for at_s in times if 10.2 < at_s < 11.9], "without a latitude there is no position"
    assert [at_s for at_s in times if at_s > 12.2], "and then there is one again"
    attitudes = [message for message in messages if message.get_type() == "ATTITUDE"]
    assert len(attitudes) > 100
    for message in attitudes:
        at_s = message.time_boot_ms / 1000
        roll = math.radians(20) * (1 - abs(at_s - 10) / 10)
        assert message.roll == pytest.approx(roll, abs=math.radians(20) / 10 * 0.05)
        assert abs(message.pitch + 0.1) <= math.radians(2) + 1e-6
        assert (message.yaw, message.yawspeed) == (1.0, 0.25)
    assert len({message.pitch for message in attitudes}) > 50, "noise"
    assert "gps.lat was told at most 0.0001" in done.stdout
    kept = json.loads(record.read_text())
    units = {each["name"]: each["unit"] for each in kept["quantities"]}
    assert units["gps.lat"] == "deg"
    assert units["attitude.roll"] == "rad"
    told = next(each["told"] for each in kept["quantities"] if each["name"] == "gps.lat")
    assert [round(value * 1e7) for _, value in told if value is not None] == [message.lat for message in positions]


def test_what_is_expected_and_does_not_hold_is_told(boat: Path) -> None:
    """Each in a sentence, and the exit code is 1."""
    done, _ = sail(boat, "wrecked", "--quiet", "--record", "wrecked.csv")
    assert done.returncode == 1, done.stderr
    assert [line.strip() for line in done.stdout.splitlines() if "Expected" in line] == [
        "Expected told sounder.depth is 21 m at 2 s: it is 20 m.",
        "Expected state sounder.depth between 0 m and 10 m at the end: it is 20 m.",
        "Expected a text with 'aground': it was not said.",
    ]
    rows = [line.split(",") for line in (boat / "wrecked.csv").read_text().splitlines()]
    assert rows[0] == ["at_ms", "program", "quantity", "unit", "true", "told"]
    depths = [row for row in rows[1:] if row[2] == "sounder.depth"]
    assert {tuple(row[1:]) for row in depths} == {("boat", "sounder.depth", "m", "20.0", "20.0")}
