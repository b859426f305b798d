"""MAVProxy tells the simulated boat of tests/projects/commanded what to do: a pump with progress, lights, modes."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from in_process import build
from programs import BIN, Program
from test_mavproxy import mavproxy

from codegen.sim.address import free_port

pytestmark = pytest.mark.timeout(150)

SPECS = Path(__file__).resolve().parents[1] / "projects" / "commanded" / "specs"
BOARD = """board: pico_2_w
links:
  wifi: {udp: 14550, to: 255.255.255.255, credentials: wifi.json, retry: 5 s}
"""
CODE = '''
import time

from vehicle import Vehicle


class Boat(Vehicle):
    """Pumps for as long as it is told."""

    def pump(self, duration, _power):
        if duration > 30:
            return "the battery is too low for that"
        self.began_ms = time.ticks_ms()
        self.duration_ms = int(duration * 1000)

    def pump_progress(self):
        passed = time.ticks_diff(time.ticks_ms(), self.began_ms)
        return None if passed >= self.duration_ms else 100 * passed // self.duration_ms

    def set_lights(self, level, lamps):
        self.texts("lamps", lamps, "at", level)
'''


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Program]:
    """MAVProxy connected to the boat, which runs in real time."""
    project = tmp_path_factory.mktemp("commanded")
    shutil.copytree(SPECS, project / "specs")
    (project / "specs" / "board.yaml").write_text(BOARD)
    (project / "specs" / "scenarios.yaml").write_text(
        "scenarios:\n  nominal: {doc: Nothing happens., duration: 60 s}\n"
    )
    (project / "boat.py").write_text(CODE)
    build(project)
    port = free_port()
    command = [str(BIN / "codegen"), "sim", "--duration", "forever", "--out", f"udp:127.0.0.1:{port}"]
    with (
        mavproxy(port, tmp_path_factory.mktemp("mavproxy")) as program,
        Program("codegen sim", command, project),
    ):
        program.wait_for(r"Received \d+ parameters")
        yield program


def test_the_pump_tells_its_progress_and_its_end(station: Program) -> None:
    """It pumps for 2 s: IN_PROGRESS at once and each second, then ACCEPTED."""
    position = station.say("long MAV_CMD_USER_1 2 50 0 0 0 0 0")
    for _ in range(2):
        station.wait_for(r"Got COMMAND_ACK: .*USER_1: IN_PROGRESS", position)
        position = station.position
    station.wait_for(r"Got COMMAND_ACK: .*USER_1: ACCEPTED", position)


def test_a_refusal_has_its_reason(station: Program) -> None:
    """A command that the code refuses has failed, one out of range is denied; the text says why."""
    position = station.say("long MAV_CMD_USER_1 31 50 0 0 0 0 0")
    station.wait_for("Got COMMAND_ACK: .*USER_1: FAILED", position)
    station.wait_for("Pump: the battery is too low for that", position)
    position = station.say("long MAV_CMD_USER_1 61 50 0 0 0 0 0")
    station.wait_for("Got COMMAND_ACK: .*USER_1: DENIED", position)
    station.wait_for("Pump: duration must be 0 to 60 s", position)


def test_arguments_arrive(station: Program) -> None:
    """In the order of the method, whole where they are."""
    position = station.say("long MAV_CMD_USER_2 2 0 -0.25 0 0 0 0")
    station.wait_for("Got COMMAND_ACK: .*USER_2: ACCEPTED", position)
    station.wait_for("lamps 2 at -0.25", position)


def test_modes_are_changed_by_name(station: Program) -> None:
    """MAVProxy knows ArduPilot's modes of boats; it shows the one that HEARTBEAT tells."""
    for name in ("GUIDED", "MANUAL"):
        position = station.say(f"mode {name}")
        station.wait_for(f"(?m)^.*Mode {name}", position)
    position = station.say("mode STEERING")
    station.wait_for("Mode: there is no mode 3", position)
