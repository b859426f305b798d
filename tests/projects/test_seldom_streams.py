"""Streams below 1 Hz: nothing that a ground station asks for, nor a parameter, lets them go faster than they may."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import DAYS, suite_is_green
from in_process import build, codegen

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
STREAMS = """streams:
  PRESENCE: {doc: That it is there., rate: 1 Hz, fastest: 2.5 Hz, data_stream: MAV_DATA_STREAM_EXTRA2}
  RANGE: {doc: How deep., rate: 0.5 Hz, fastest: 0.7 Hz, data_stream: MAV_DATA_STREAM_EXTRA1}
  SELDOM: {doc: Hardly ever., rate: 0.0005 Hz, data_stream: MAV_DATA_STREAM_RC_CHANNELS, requirement: FR-601.3}
  REST: {doc: The weather., parameter: REST_RATE, data_stream: MAV_DATA_STREAM_EXTRA3, requirement: FR-601.3}
"""
PARAMETERS = """encoding: bytewise
parameters:
  REST_RATE:
    {doc: Of the rest., unit: Hz, type: real32, default: 0.1, min: 0, max: 0.3, step: 0.1, requirement: FR-601.3}
"""
ASKED = """
import json
from program_bench import new_craft

IDS = {"PRESENCE": 0, "RANGE": 132, "SELDOM": 339, "REST": 12920}
NUMBERS = {"PRESENCE": 11, "RANGE": 10, "SELDOM": 3, "REST": 12}
found = {}
for name in IDS:
    streams = new_craft().connections[0].streams
    intervals = [streams.interval_us(IDS[name])]
    for interval_us in (1, 100000, 1000000, 1000000000):
        assert streams.set_interval(IDS[name], interval_us)
        intervals.append(streams.interval_us(IDS[name]))
    for rate_hz in (1, 2, 1000, 0):
        assert streams.request(NUMBERS[name], rate_hz)
        intervals.append(streams.interval_us(IDS[name]))
    found[name] = intervals
print(json.dumps(found))
"""
ASKING = "micropython-stream or micropython-generation or micropython-station or micropython-announcement"
"""The scripts that are about streams, on the other interpreter."""


@pytest.fixture(scope="module")
def buoy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project whose streams go seldom, built: one every 2000 s, which is longer than any interval to ask for."""
    folder = tmp_path_factory.mktemp("seldom")
    shutil.copytree(HERE / "slow_readings" / "specs", folder / "specs")
    (folder / "specs" / "streams.yaml").write_text(STREAMS)
    (folder / "specs" / "parameters.yaml").write_text(PARAMETERS)
    document = folder / "specs" / "requirements" / "FR-601-pump-boat.md"
    text = document.read_text()
    for stated, said in (("goes out at 1 Hz", "tells"), (", 5 Hz by default", "")):
        assert stated in text
        text = text.replace(stated, said)
    document.write_text(text)
    build(folder)
    return folder


@pytest.mark.parametrize("interpreter", ["python", "micropython", "micropython32"])
def test_nothing_goes_faster_than_it_may(buoy: Path, tmp_path: Path, interpreter: str) -> None:
    """Intervals are those of `fastest` to the microsecond, and what is asked for every 2000 s keeps its own rate."""
    script = tmp_path / "asked.py"
    script.write_text(ASKED)
    path = os.pathsep.join(str(buoy / "generated" / part) for part in ("firmware", "mocks", "tests"))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}{os.pathsep}.frozen"}
    heap = [] if interpreter == "python" else ["-X", "heapsize=4m"]
    command = [str(BIN / interpreter), *heap, str(script)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    longest, off, never = 1000000000, -1, 2000000000
    assert json.loads(done.stdout) == {
        "PRESENCE": [1000000, 400000, 400000, 1000000, longest, 1000000, 500000, 500000, off],
        "RANGE": [2000000, *[1428572] * 3, longest, *[1428572] * 3, off],
        "SELDOM": [never] * 8 + [off],
        "REST": [10000000, *[3333334] * 3, longest, *[3333334] * 3, off],
    }


def test_its_checks_are_green(buoy: Path) -> None:
    """The generated suite asks for more than these streams may, too, and for an interval that ends beyond a turn."""
    suite_is_green(buoy, "generated/tests/test_program.py", only=f"(cpython and not ({DAYS})) or {ASKING}")


@pytest.mark.parametrize(
    ("file", "old", "new", "wanted"),
    [
        (
            "streams.yaml",
            "parameter: REST_RATE,",
            "parameter: REST_RATE, fastest: 0.2 Hz,",
            "streams.yaml:5: error bad-stream: stream REST: REST_RATE goes up to 0.3 Hz, above fastest",
        ),
        (
            "streams.yaml",
            "fastest: 0.7 Hz",
            "fastest: 0.4 Hz",
            "streams.yaml:3: error bad-stream: stream RANGE: its rate is 0.5 Hz, above fastest",
        ),
        (
            "streams.yaml",
            "rate: 0.0005 Hz,",
            "rate: 0.0005 Hz, fastest: 0.0008 Hz,",
            "streams.yaml:4: error bad-stream: stream SELDOM: 0.0008 Hz is less often than once in 1073 s",
        ),
        (
            "parameters.yaml",
            "default: 0.1, min: 0, max: 0.3, step: 0.1",
            "default: 0, min: 0, max: 0.0009, step: 0.0001",
            "streams.yaml:5: error bad-stream: stream REST: 0.0009 Hz is less often than once in 1073 s",
        ),
        (
            "vehicle.yaml",
            "{fastest: 10 Hz}",
            "{fastest: 0.0009 Hz}",
            "vehicle.yaml:4: error bad-program: 0.0009 Hz is less often than once in 1073 s",
        ),
    ],
)
def test_what_cannot_be_held_is_refused(buoy: Path, tmp_path: Path, file: str, old: str, new: str, wanted: str) -> None:
    """`fastest` below the rate or the parameter's maximum was ignored, and so was what no interval can say."""
    shutil.copytree(buoy / "specs", tmp_path / "specs")
    path = tmp_path / "specs" / file
    assert old in path.read_text()
    path.write_text(path.read_text().replace(old, new))
    done = codegen(tmp_path, "build")
    assert done.returncode == 1
    assert wanted in re.sub(r":[0-9]+: error", ": error", done.stdout), done.stdout
