"""A change that a message cannot tell yet, since something else is unknown, goes out once that is known.

The message has no stream: it is sent on connection and on a change only, and nothing else would ever tell the change.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import build

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

MESSAGE = """\
message: HOME_POSITION
requirement: FR-301.1
send: while_known
on_change: nav.lat
on_connection: true
fields:
  latitude: {state: nav.lat}
  longitude: {state: nav.lon}
  altitude: {constant: 0}
  x: {constant: 0}
  y: {constant: 0}
  z: {constant: 0}
  q: {constant: 0}
  approach_x: {constant: 0}
  approach_y: {constant: 0}
  approach_z: {constant: 0}
  time_usec: {clock: boot}
"""
STATE = """
  nav:
    doc: Where it began.
    requirement: FR-301.1
    quantities:
      lat: {doc: Latitude., unit: deg, stored: degE7, min: -90, max: 90}
      lon: {doc: Longitude., unit: deg, stored: degE7, min: -180, max: 180}
"""
SCRIPT = """
from program_bench import SECOND_US, new_craft, run

craft = new_craft()
nav = craft.state.nav

def told():
    craft.port.frames = []
    run(craft, 2 * SECOND_US)
    return len([frame for frame in craft.port.frames if frame[7] | frame[8] << 8 == 242])

counts = [told()]  # on connection; what was set before is no change
nav.lat = 11
nav.lon = None
counts.append(told())
nav.lon = 5
counts.append(told())
counts.append(told())
nav.lon = 6  # nobody watches it
counts.append(told())
nav.lat = None
counts.append(told())
nav.lat = 11.5
counts.append(told())
nav.lon = None
craft.connections[0].streams.connect()  # somebody else appears
counts.append(told())
nav.lon = 7
counts.append(told())
print(counts)
"""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The boat of commanded, built with the message."""
    folder = tmp_path_factory.mktemp("withheld")
    specs = shutil.copytree(HERE / "commanded" / "specs", folder / "specs")
    (specs / "messages" / "home.yaml").write_text(MESSAGE)
    with (specs / "state.yaml").open("a") as state:
        state.write(STATE)
    build(folder)
    return folder


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_a_change_is_told_once_it_is_known(project: Path, interpreter: str) -> None:
    """Once, and at the start once in all: the values that a vehicle begins with are no change beside that."""
    (project / "told.py").write_text(SCRIPT)
    folders = os.pathsep.join(str(project / "generated" / name) for name in ("firmware", "mocks", "tests"))
    environment = os.environ | {"PYTHONPATH": folders, "MICROPYPATH": f"{folders}:.frozen"}
    command = [str(BIN / interpreter), str(project / "told.py")]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.stdout.split("\n")[0] == "[1, 0, 1, 0, 0, 0, 1, 0, 1]", done.stdout + done.stderr


def test_the_suite_of_such_a_vehicle_is_green(project: Path) -> None:
    """What it says of announced messages, of those that are withheld, and of who is heard."""
    checks = "announcement or withheld or ground_stations_are_noted or one_message_in_a_pass"
    suite_is_green(project, "generated/tests/test_program.py", only=f"micropython and ({checks})")
