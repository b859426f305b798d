"""Facts of instances: what is 0 for one and not for another is written for each, in whichever order they are sent."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build
from pymavlink.dialects.v20 import common

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

FACTS = {
    "framerate": ("0", "0.1", "1"),
    "rotation": ("0", "7", "256"),
    "bitrate": ("70000", "0", "4096"),
    "resolution_h": ("640", "0", "1280"),
}
"""By field what each camera has: some bytes and halves are 0 for one of them alone."""
ORDER = (0, 1, 2, 1, 0, 2, 0)
SCRIPT = f"""
import json
import mock_time
mock_time.install()
from mavlink import Link
from state import SystemState
import telemetry

state, link = SystemState(), Link(1, 1)
print(json.dumps([telemetry.encode_video_stream_information(link, state, each).hex() for each in {ORDER}]))
"""


@pytest.fixture(scope="module")
def cameras(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three cameras that differ in numbers of two and four bytes, and in a float."""
    specs = shutil.copytree(HERE / "three_cameras" / "specs", tmp_path_factory.mktemp("cameras") / "specs")
    board, table = specs / "board.yaml", specs / "messages" / "video_stream_information.yaml"
    text = board.read_text()
    for number, view in enumerate(("ahead", "astern", "down")):
        facts = ", ".join(f"{field}: {values[number]}" for field, values in FACTS.items())
        assert f"view: {view}}}" in text
        text = text.replace(f"view: {view}}}", f"view: {view}, {facts}}}")
    board.write_text(text)
    lines = table.read_text().splitlines()
    for field in FACTS:
        at = next(number for number, line in enumerate(lines) if line.startswith(f"  {field}:"))
        lines[at] = f"  {field}: {{board: camera.{field}}}"
    table.write_text("\n".join(lines) + "\n")
    build(specs.parent)
    return specs.parent / "generated"


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_each_camera_has_its_own(cameras: Path, tmp_path: Path, interpreter: str) -> None:
    """In machine code and in plain Python, after any other camera: the buffer of a link is the same for all."""
    script = tmp_path / "story.py"
    script.write_text(SCRIPT)
    path = os.pathsep.join(str(cameras / part) for part in ("firmware", "mocks"))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}{os.pathsep}.frozen"}
    done = subprocess.run(
        [str(BIN / interpreter), str(script)], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    parser = common.MAVLink(None)
    for camera, frame in zip(ORDER, json.loads(done.stdout), strict=True):
        (message,) = parser.parse_buffer(bytes.fromhex(frame))
        found = {field: getattr(message, field) for field in FACTS}
        assert found == pytest.approx({field: float(values[camera]) for field, values in FACTS.items()}), camera


def test_its_machine_code_compiles(cameras: Path) -> None:
    """A branch that writes nothing is no Python; firmware would take the plain form, and nobody would notice."""
    viper = (cameras / "firmware" / "telemetry_viper.py").read_text()
    assert "if instance == 0:" in viper
    compile(viper, "telemetry_viper.py", "exec", dont_inherit=True)
