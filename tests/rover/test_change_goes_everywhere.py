"""Changing one number in a YAML file changes firmware, tests, documents and explanation together, and nothing else."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(sys.executable).parent

DOCUMENT = "docs/telemetry.md"
CHANGES = [
    (
        "board.yaml",
        "reference: 3.3 V",
        "reference: 3.0 V",
        {"firmware/state.py", "tests/cases.json", "docs/telemetry.md"},
        ("battery.voltage", "* 3 V"),
    ),
    (
        "messages/battery_status.yaml",
        "battery_remaining: {state: battery.remaining, min: 0, max: 100",
        "battery_remaining: {state: battery.remaining, min: 0, max: 95",
        {"firmware/telemetry.py", "tests/cases.json", "docs/telemetry.md"},
        ("BATTERY_STATUS.battery_remaining", "0..95"),
    ),
    (
        "parameters.yaml",
        "default: 3.95",
        "default: 4.05",
        {"firmware/parameters.py", "tests/cases.json", "docs/telemetry.md"},
        ("BATT_VOLT_MULT", "4.05"),
    ),
    (
        "state.yaml",
        "invalid_after: 5",
        "invalid_after: 7",
        {"firmware/state.py", "tests/behaviour.py"},
        ("battery.voltage", "7 failed readings"),
    ),
    (
        "dialects/corrections.yaml",
        'invalid: "0"',
        'invalid: "-1"',
        {"firmware/telemetry.py", "tests/cases.json", "docs/telemetry.md"},
        ("BATTERY_STATUS.time_remaining", "= -1"),
    ),
]


PROGRAM_CHANGES = [
    ("vehicle.yaml", "rate: 400 Hz", "rate: 200 Hz", {"firmware/vehicle.py", DOCUMENT}, None),
    (
        "parameters.yaml",
        "default: 26",
        "default: 27",
        {"firmware/parameters.py", DOCUMENT},
        ("BATT_VOLT_PIN", "default      27"),
    ),
    (
        "parameters.yaml",
        "default: 3.5",
        "default: 3.6",
        {"firmware/parameters.py", DOCUMENT},
        ("BATT_LOW_VOLT", "default      10.8 V"),
    ),
    (
        "parameters.yaml",
        "unit: s\n    default: 10",
        "unit: s\n    default: 5",
        {"firmware/parameters.py", DOCUMENT},
        ("BATT_LOW_TIMER", "default      5 s"),
    ),
    (
        "parameters.yaml",
        "unit: Hz\n    default: 2",
        "unit: Hz\n    default: 4",
        {"firmware/parameters.py", DOCUMENT},
        ("BATTERY_STATUS", "4 Hz by default"),
    ),
    (
        "state.yaml",
        "warn_every: 10 s",
        "warn_every: 20 s",
        {"firmware/state.py", "tests/behaviour.py"},
        ("battery.voltage", "every 20000 ms at most"),
    ),
    (
        "state.yaml",
        "window: 4 s",
        "window: 2 s",
        {"firmware/state.py", DOCUMENT},
        ("battery.trend", "over 2 s, 20 readings"),
    ),
    ("vehicle.yaml", "chunk: 64", "chunk: 32", {"firmware/vehicle.py", DOCUMENT}, None),
    ("board.yaml", "udp: 14550", "udp: 14551", {"firmware/board.py", DOCUMENT}, None),
    (
        "vehicle.yaml",
        "call: hold, mode: 4",
        "call: hold, mode: 5",
        {"firmware/vehicle.py", DOCUMENT},
        None,
    ),
]


def body(path: Path) -> str:
    """A generated file without its header, whose hash changes with every input."""
    lines = path.read_text().splitlines()
    return "\n".join(line for line in lines if not line.startswith(("# Inputs:", "<!-- Generated", '{"generated"')))


def bodies(folder: Path) -> dict[str, str]:
    """Every generated file of a folder by its relative path."""
    paths = [path for path in folder.rglob("*") if path.is_file() and path.suffix in (".py", ".json", ".md")]
    return {path.relative_to(folder).as_posix(): body(path) for path in paths if "__pycache__" not in path.parts}


def run(folder: Path, *arguments: str) -> str:
    """Run codegen in a folder; its standard output."""
    command = [str(BIN / "codegen"), *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize(("file", "old", "new", "changed", "told"), CHANGES, ids=[change[2] for change in CHANGES])
def test_one_number(file, old, new, changed, told, tmp_path):
    """The files that state the number change, `explain` tells the new one, and the new suite is green."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    run(tmp_path, "build")
    before = bodies(tmp_path / "generated")
    path = tmp_path / "specs" / file
    assert old in path.read_text()
    path.write_text(path.read_text().replace(old, new, 1))
    run(tmp_path, "build")
    after = bodies(tmp_path / "generated")
    assert after.keys() == before.keys()
    assert {name for name in after if after[name] != before[name]} - {"manifest.json"} >= changed
    topic, words = told
    assert words in run(tmp_path, "explain", topic)
    options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-k", "not test_program"]
    command = [sys.executable, "-m", "pytest", *options, "generated/tests"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-3000:]


@pytest.fixture(scope="module")
def as_it_is(tmp_path_factory):
    """The rover's specification, built: nobody changes it."""
    folder = tmp_path_factory.mktemp("rover")
    shutil.copytree(ROOT / "specs", folder / "specs")
    run(folder, "build")
    return folder


def apply(folder: Path, file: str, old: str, new: str) -> None:
    path = folder / "specs" / file
    assert path.read_text().count(old) == 1, f"{old!r} is not in {file} once"
    path.write_text(path.read_text().replace(old, new))


@pytest.mark.parametrize(
    ("file", "old", "new", "changed", "told"),
    PROGRAM_CHANGES,
    ids=[change[2].replace("\n    ", " ") for change in PROGRAM_CHANGES],
)
def test_one_number_of_the_program(file, old, new, changed, told, as_it_is, tmp_path):
    """The files that state the number change and no other module of the firmware, and `explain` tells the new one."""
    shutil.copytree(as_it_is, tmp_path, dirs_exist_ok=True)
    apply(tmp_path, file, old, new)
    run(tmp_path, "build")
    before, after = bodies(as_it_is / "generated"), bodies(tmp_path / "generated")
    assert after.keys() == before.keys()
    different = {name for name in after if after[name] != before[name]}
    assert different >= changed
    assert {name for name in different if name.startswith("firmware/")} == {
        name for name in changed if name.startswith("firmware/")
    }
    if told is not None:
        topic, words = told
        assert words in run(tmp_path, "explain", topic)


def test_all_numbers_of_the_program(tmp_path):
    """All of them at once: the new suite is green."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    for file, old, new, _, _ in PROGRAM_CHANGES:
        apply(tmp_path, file, old, new)
    run(tmp_path, "build")
    options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-k", "not day and not heap"]
    command = [sys.executable, "-m", "pytest", *options, "generated/tests"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-3000:]


def output(folder):
    """The files of the output, without the stamp that a build leaves for the next one."""
    found = (path for path in (folder / "generated").rglob("*") if path.is_file() and ".codegen" not in path.parts)
    return {path.relative_to(folder) for path in found}


def test_deleting_the_output_and_building_restores_it(tmp_path):
    """generated/ is a function of specs/: built again from nothing it is the committed one, byte for byte."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    run(tmp_path, "build")
    made = output(tmp_path)
    for path in made:
        assert (tmp_path / path).read_bytes() == (ROOT / path).read_bytes(), path
    stamps = {path: (tmp_path / path).stat().st_mtime_ns for path in made}
    run(tmp_path, "build")
    assert {path: (tmp_path / path).stat().st_mtime_ns for path in made} == stamps
    shutil.rmtree(tmp_path / "generated")
    run(tmp_path, "build")
    assert output(tmp_path) == made
    assert all((tmp_path / path).read_bytes() == (ROOT / path).read_bytes() for path in made)
