"""Sensors of board.yaml in the simulation: courses, faults and recovery reach the state and the wire."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent


@pytest.fixture(scope="module")
def sensors(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the project is built; the classes of its sensors are nowhere."""
    folder = tmp_path_factory.mktemp("sensors")
    subprocess.run(["cp", "-r", str(HERE / "sensors" / "specs"), str(folder)], check=True)
    (folder / "specs" / "scenarios.yaml").write_bytes((HERE / "sensors" / "moving" / "scenarios.yaml").read_bytes())
    build(folder)
    return folder


@pytest.mark.parametrize("runtime", ["micropython", "cpython"])
def test_what_a_sensor_gives_follows_its_course(sensors: Path, runtime: str) -> None:
    """The expectations of the scenarios hold: values, unknown while it fails, texts, recovery; and told values.

    The receiver of satellites and the monitors are read by their drivers, others have their values given.
    """
    options = ["--speed", "max", "--runtime", runtime, "--out", "udp:127.0.0.1:9", "--record", "r.json"]
    for scenario in ("sailing", "moving"):
        command = [str(BIN / "codegen"), "sim", scenario, *options]
        done = subprocess.run(command, cwd=sensors, capture_output=True, text=True, check=False, timeout=60)
        assert done.returncode == 0, done.stdout + done.stderr
    record = json.loads((sensors / "r.json").read_text())
    told = next(each["told"] for each in record["quantities"] if each["name"] == "water.depth")
    for at_ms, value in told:
        true = 20 - at_ms / 2_000
        is_held = 5_000 <= at_ms <= 6_200 or 14_000 <= at_ms <= 16_300
        assert abs(value - true) <= (1.2 if is_held else 0.1), at_ms
    assert not [at_ms for at_ms, _ in told if 6_300 < at_ms < 9_000], "without a depth there is no message"
