"""`codegen sim` with the firmware under MicroPython, and what it is run against."""

import re
import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from ground_link import GroundLink
from in_process import build
from programs import BIN, Program

ROOT = Path(__file__).resolve().parents[2]

SCENARIOS = """
scenarios:
  steady:
    doc: A good pack whose voltage does not change. 12 V are 3770 counts, which the firmware takes for 12.000 V.
    duration: 60 s
    courses: {battery.voltage: {value: 12 V}}
  low:
    doc: A pack below BATT_LOW_VOLT.
    duration: 60 s
    courses: {battery.voltage: {value: 10.2 V}}
  drawing:
    doc: A rover with a current sensor; a tenth of the pack's 100 mAh is drawn in 3 s, and all of it in 30 s.
    duration: 60 s
    parameters: {BATT_MONITOR: 4, BATT_CAPACITY: 100}
    courses: {battery.voltage: {value: 12 V}, battery.current: {value: 12 A}}
  failing:
    doc: The rover drives while the pack is below BATT_LOW_VOLT, then below BATT_CRT_VOLT.
    duration: 60 s
    courses: {battery.voltage: {points: [[0 s, 11 V], [5 s, 11 V], [6 s, 10.3 V], [25 s, 10.3 V], [26 s, 9.7 V]]}}
    events: [{at: 3 s, arm: true}]
"""

Start = Callable[..., Program]
"""Starts codegen sim: start(port of the ground station, scenario, options ...)."""


@pytest.fixture(scope="session")
def scenarios(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of the scenarios above."""
    path = tmp_path_factory.mktemp("scenarios") / "ground.yaml"
    path.write_text(SCENARIOS)
    return path


def starter(stack: ExitStack, scenarios: Path) -> Start:
    def start(port: int, scenario: str, *options: str, project: Path = ROOT) -> Program:
        target = ["--duration", "forever", "--out", f"udp:127.0.0.1:{port}"]
        command = [str(BIN / "codegen"), "sim", f"{scenarios}:{scenario}", *target, *options]
        return stack.enter_context(Program(f"codegen sim {scenario}", command, project))

    return start


@pytest.fixture
def start(scenarios: Path) -> Iterator[Start]:
    """Starts simulators for one test."""
    with ExitStack() as stack:
        yield starter(stack, scenarios)


@pytest.fixture(scope="module")
def start_shared(scenarios: Path) -> Iterator[Start]:
    """Starts simulators for the tests of a file."""
    with ExitStack() as stack:
        yield starter(stack, scenarios)


@pytest.fixture
def link() -> Iterator[GroundLink]:
    """pymavlink as the ground station of one test, on a port that was free."""
    with GroundLink() as opened:
        yield opened


@pytest.fixture(scope="module")
def link_shared() -> Iterator[GroundLink]:
    """pymavlink as the ground station of the tests of a file."""
    with GroundLink() as opened:
        yield opened


@pytest.fixture(scope="session")
def estimating(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with the rover's specification, but for the remaining charge, which is estimated from the voltage."""
    project = tmp_path_factory.mktemp("estimating")
    shutil.copytree(ROOT / "specs", project / "specs")
    state = project / "specs" / "state.yaml"
    written = state.read_text()
    changed = re.sub(
        r"(remaining:\n(?:.*\n)*?)( +)left_of: .*\n +after: .*\n",
        r"\1\2estimate_from: voltage\n\2curve: discharge\n",
        written,
        count=1,
    )
    assert changed != written
    state.write_text(changed)
    build(project)
    return project
