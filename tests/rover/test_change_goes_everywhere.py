"""Changing one number in a YAML file changes firmware, tests, documents and explanation together, and nothing else."""

import shutil
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import codegen
from rover_alone import without_programs

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]

DOCUMENT = "docs/telemetry.md"
PAYLOADS = ("firmware/telemetry_plain.py", "firmware/telemetry_viper.py")
READINGS = ("firmware/state_plain.py", "firmware/state_viper.py")
CURRENT = ("firmware/battery_current_viper.py",)
CHANGES = [
    (
        "board.yaml",
        "pin: BATT_VOLT_PIN\n    bits: 12\n    reference: 3.3 V",
        "pin: BATT_VOLT_PIN\n    bits: 12\n    reference: 3.0 V",
        {"firmware/state.py", *READINGS, "tests/cases.json", "docs/telemetry.md"},
        ("battery.voltage", "* 3 V"),
    ),
    (
        "messages/battery_status.yaml",
        "battery_remaining: {state: battery.remaining, min: 0, max: 100",
        "battery_remaining: {state: battery.remaining, min: 0, max: 95",
        {*PAYLOADS, "tests/cases.json", "docs/telemetry.md"},
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
        "invalid_after: 5\n        stale_after: 1 s\n        requirement: FR-00069.1",
        "invalid_after: 7\n        stale_after: 1 s\n        requirement: FR-00069.1",
        {"firmware/state.py", *READINGS, "tests/behaviour.py"},
        ("battery.voltage", "7 failed readings"),
    ),
    (
        "dialects/corrections_rfc_0018.yaml",
        "corrections:\n",
        "corrections:\n"
        '  - {message: BATTERY_STATUS, field: time_remaining, set: {invalid: "-1"}, reason: r, source: s}\n',
        {"firmware/messages.py", "firmware/message_fields.py", *PAYLOADS, "tests/cases.json", "docs/telemetry.md"},
        ("BATTERY_STATUS.time_remaining", "unknown      -1"),
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
        {*READINGS, "tests/behaviour.py"},
        ("battery.voltage", "every 20000 ms at most"),
    ),
    (
        "state.yaml",
        "window: 4 s",
        "window: 2 s",
        {"firmware/state.py", "firmware/streams.py", *READINGS, *CURRENT, *PAYLOADS, DOCUMENT},
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
    done = codegen(folder, *arguments)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def apply(folder: Path, file: str, old: str, new: str) -> None:
    path = folder / "specs" / file
    assert path.read_text().count(old) == 1, f"{old!r} is not in {file} once"
    path.write_text(path.read_text().replace(old, new))


@pytest.fixture(scope="module")
def rover(tmp_path_factory):
    """The rover's specification without further programs, built, and what was generated from it."""
    folder = tmp_path_factory.mktemp("rover")
    shutil.copytree(ROOT / "specs", folder / "specs")
    without_programs(folder / "specs")
    run(folder, "build")
    return folder, bodies(folder / "generated")


@pytest.fixture
def told(capsys):
    """Return a call for the output of codegen, run in the working directory."""

    def tell(*arguments):
        code = main(list(arguments))
        out, err = capsys.readouterr()
        assert code == 0, out + err
        return out

    return tell


@pytest.mark.parametrize(
    ("file", "old", "new", "changed", "words"),
    CHANGES + PROGRAM_CHANGES,
    ids=[change[2].replace("\n    ", " ") for change in CHANGES + PROGRAM_CHANGES],
)
def test_one_number(file, old, new, changed, words, rover, told, monkeypatch):
    """The files that state the number change and no other module of the firmware, and `explain` tells the new one."""
    folder, before = rover
    path = folder / "specs" / file
    written = path.read_text()
    try:
        apply(folder, file, old, new)
        monkeypatch.chdir(folder)
        told("build")
        after = bodies(folder / "generated")
        assert after.keys() == before.keys()
        different = {name for name in after if after[name] != before[name]}
        assert different >= changed
        assert {name for name in different if name.startswith("firmware/")} == {
            name for name in changed if name.startswith("firmware/")
        }
        if words is not None:
            topic, said = words
            assert said in told("explain", topic)
    finally:
        path.write_text(written)


@pytest.mark.long
def test_all_numbers(tmp_path):
    """All of them at once: the new suite is green, the program's part under MicroPython, which has small integers."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    for file, old, new, _, _ in CHANGES + PROGRAM_CHANGES:
        apply(tmp_path, file, old, new)
    run(tmp_path, "build")
    suite_is_green(
        tmp_path,
        "generated/tests",
        only="micropython and not (day_across_the_wrap or heap_is_constant_over_a_day) or test_dialect",
    )


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
