"""MAVProxy and MAVSDK against the simulated examples/boat: what it says, how it is steered, and its pump."""

import shutil
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from in_process import build
from programs import BIN, Program, wait_until
from test_mavproxy import mavproxy
from test_mavsdk import STATION, Station

from codegen.sim.address import free_port

pytestmark = pytest.mark.timeout(150)

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "boat"


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The example, built."""
    folder = tmp_path_factory.mktemp("example") / "boat"
    shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("generated", "__pycache__"))
    build(folder)
    return folder


def simulated(project: Path, port: int) -> Program:
    """The boat at the pier, in real time."""
    command = [str(BIN / "codegen"), "sim", "nominal", "--duration", "forever", "--out", f"udp:127.0.0.1:{port}"]
    return Program("codegen sim", command, project)


@pytest.fixture(scope="module")
def proxy(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Program]:
    """MAVProxy connected to the boat."""
    port = free_port()
    with mavproxy(port, tmp_path_factory.mktemp("mavproxy")) as program, simulated(project, port):
        program.wait_for(r"Received \d+ parameters")
        yield program


@pytest.fixture(scope="module")
def station(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Station]:
    """MAVSDK connected to the boat."""
    port = free_port()
    kinds = ("position", "attitude_euler", "distance_sensor", "raw_gps", "flight_mode")
    command = [sys.executable, str(STATION), str(port), *kinds]
    with Program("MAVSDK", command, tmp_path_factory.mktemp("mavsdk")) as program:
        program.wait_for("=ready=")
        with simulated(project, port):
            program.wait_for("=system=")
            yield Station(program)


def test_mavsdk_sees_where_it_is_and_how_deep_that_is(station: Station) -> None:
    """Position, attitude and depth as the scenario has them: 54.3233 N, 10.1394 E, bow to the east, 4 m."""
    position = station.sees("position", r'\{"latitude_deg": 54.*\}', since=0)
    assert position["latitude_deg"] == pytest.approx(54.3233, abs=1e-7)
    assert position["longitude_deg"] == pytest.approx(10.1394, abs=1e-7)
    assert position["absolute_altitude_m"] == pytest.approx(0.4, abs=0.001)
    angles = station.sees("attitude_euler", r'\{"roll_deg": .*\}', since=0)
    assert angles["yaw_deg"] == pytest.approx(90, abs=0.001)
    assert abs(angles["roll_deg"]) <= 2.001
    depth = station.sees("distance_sensor", since=0)
    assert depth["current_distance_m"] == pytest.approx(4, abs=0.06)
    assert depth["maximum_distance_m"] == pytest.approx(50)


def test_mavproxy_sees_it(proxy: Program) -> None:
    """The same by MAVProxy's own commands: the last message of each kind."""
    proxy.wait_for("online system 1")
    for message, pattern in (
        ("GLOBAL_POSITION_INT", r"lat ?: 543233000, lon ?: 101394000"),
        ("ATTITUDE", r"yaw ?: 1\.5707"),
        ("DISTANCE_SENSOR", r"current_distance ?: (39[4-9]|40[0-6])"),
        ("WIND_COV", r"wind_y ?: [4-6]\."),
    ):
        proxy.wait_for(pattern, proxy.say(f"status {message}"))


def test_override_moves_the_rudder(proxy: Program) -> None:
    """`rc 1 1700` of a ground station that is heard: both messages say so, and 65535 gives the channel back."""
    proxy.say("rc 1 1700")
    _until(proxy, "SERVO_OUTPUT_RAW", "servo1_raw", 1700)
    _until(proxy, "RC_CHANNELS", "chan1_raw", 1700)
    proxy.say("rc 1 65535")
    _until(proxy, "SERVO_OUTPUT_RAW", "servo1_raw", 1500)


def _until(proxy: Program, message: str, field: str, value: int) -> None:
    """Ask until a field of a message that is sent twice a second has a value."""

    def arrived() -> bool:
        time.sleep(0.1)
        return int(proxy.wait_for(rf"{field} ?: (\d+)", proxy.say(f"status {message}"))[1]) == value

    wait_until(arrived, f"{message}.{field} is {value}")


def test_the_pump_tells_how_far_it_is(proxy: Program) -> None:
    """MAV_CMD_USER_1 for 2 s: IN_PROGRESS at once and each second, then ACCEPTED; what is out of range is denied."""
    position = proxy.say("long MAV_CMD_USER_1 2 0 0 0 0 0 0")
    for _ in range(2):
        proxy.wait_for(r"Got COMMAND_ACK: .*USER_1: IN_PROGRESS", position)
        position = proxy.position
    proxy.wait_for(r"Got COMMAND_ACK: .*USER_1: ACCEPTED", position)
    position = proxy.say("long MAV_CMD_USER_1 61 0 0 0 0 0 0")
    proxy.wait_for(r"Got COMMAND_ACK: .*USER_1: DENIED", position)
    proxy.wait_for("Pump: duration must be 1 to 60 s", position)


def test_it_is_armed_in_a_mode_of_its_own(proxy: Program) -> None:
    """`mode MANUAL`, `arm throttle` and `disarm`, as a person types them."""
    proxy.wait_for("Mode MANUAL", proxy.say("mode MANUAL"))
    proxy.wait_for("Armed", proxy.say("arm throttle"))
    proxy.wait_for("Disarmed", proxy.say("disarm"))


def test_mavsdk_arms_it(station: Station) -> None:
    """The arming of a library that waits for the acknowledgement."""
    station.do("action.arm")
    station.do("action.disarm")
