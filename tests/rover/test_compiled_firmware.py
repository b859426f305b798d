"""`codegen build --mpy`: the modules that a board loads do what their sources do."""

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import in_process
import pytest
from rover_alone import without_programs
from whole_program import module_folders

ROOT = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.executable).parent

# The stream takes the place of the board's UART; everything else is the compiled firmware.
SCRIPT = """
import frames, frames_plain_or_viper
from state import SystemState
from streams import open_link
import telemetry

class Wire:
    def write(self, frame):
        print(bytes(frame).hex())
        return len(frame)

state = SystemState()
state.battery[0].voltage = 12.6
state.battery[0].current = -0.01
link = open_link(Wire())
for build in (telemetry.build_heartbeat, telemetry.build_sys_status, telemetry.build_battery_status):
    link.send(build(state))
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """The rover's specification in a folder of its own, without the programs beside it."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    without_programs(tmp_path / "specs")
    return tmp_path


def codegen(folder: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    return in_process.codegen(folder, "build", *arguments)


def frames(folder: Path, modules: Sequence[Path], form: str) -> list[str]:
    """The frames that firmware makes under MicroPython; without machine code it makes them in plain Python."""
    script = folder / "script.py"
    script.write_text(SCRIPT.replace("frames_plain_or_viper", form))
    # A module of a bundle loads all of it, and so what others there import, such as asyncio.
    path = os.pathsep.join(map(str, [*modules, *module_folders(ROOT / "generated", "mocks"), ".frozen"]))
    done = subprocess.run(
        [str(TOOLS / "micropython"), str(script)],
        env=os.environ | {"MICROPYPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


@pytest.mark.parametrize(("architecture", "form"), [("x64", "frames_viper"), ("bytecode", "frames_plain")])
def test_compiled_firmware_sends_the_same_frames(project: Path, architecture: str, form: str) -> None:
    """Machine code for this host, and bytecode for every board, although the project asks for machine code."""
    done = codegen(project, "--mpy", architecture)
    assert done.returncode == 0, done.stdout
    modules = project / "build" / architecture
    assert [path.name for path in modules.glob("*.py")] == ["main.py"]  # what boards start
    sent = frames(project, [modules], form)
    assert len(sent) == 3
    assert sent == frames(project, module_folders(ROOT / "generated", "firmware"), "frames_plain")


@pytest.mark.parametrize("architecture", ["armv6m", "armv7emsp"])
def test_firmware_compiles_for_the_boards_processors(project: Path, architecture: str) -> None:
    done = codegen(project, "--mpy", architecture)
    assert done.returncode == 0, done.stdout
    compiled = {path.stem for path in (project / "build" / architecture).glob("*.mpy")}
    assert {"board", "frames_viper", "mavlink", "streams", "telemetry"} <= compiled
    assert "frames_plain" in compiled  # an interpreter of another kind takes it instead


def test_what_the_users_code_names_keeps_its_name(project: Path) -> None:
    """As in a deploy, and in the same words: its class derives from a generated one."""
    assert codegen(project, "--mpy", "bytecode").returncode == 0
    modules = project / "build" / "bytecode"
    assert not any(b"_guard" in path.read_bytes() for path in modules.glob("*.mpy"))
    (project / "rover.py").write_text("from vehicle import Vehicle\n\nclass Rover(Vehicle):\n    _guard = None\n")
    assert codegen(project, "--mpy", "bytecode").returncode == 0
    assert any(b"_guard" in path.read_bytes() for path in modules.glob("*.mpy"))
    assert "=_guard" not in (modules / "short_names.txt").read_text()


def test_machine_code_can_be_done_without(project: Path) -> None:
    """`machine_code: false` leaves neither viper nor native code; the frames stay the same."""
    with (project / "specs" / "codegen.yaml").open("a") as file:
        file.write("machine_code: false\n")
    assert codegen(project).returncode == 0
    firmware = module_folders(project / "generated", "firmware")
    written = [path for folder in firmware for path in folder.glob("*.py")]
    assert "frames_plain.py" in {path.name for path in written}
    assert not [path.name for path in written if path.name.endswith("_viper.py")]
    assert not [path.name for path in written if "micropython.native" in path.read_text()]
    assert frames(project, firmware, "frames_plain") == frames(
        project, module_folders(ROOT / "generated", "firmware"), "frames_viper"
    )
