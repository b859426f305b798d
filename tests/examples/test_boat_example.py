"""examples/boat, the second vehicle: built as a user builds it, tested, simulated and traced.

pymavlink decodes what the generated suite lets the firmware send; this file runs that suite on three interpreters.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import ALONE, COMMON, DAYS
from in_process import build

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "boat"
BIN = Path(sys.executable).parent


def run(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    """A command of the environment, in a folder."""
    return subprocess.run(
        [str(BIN / command[0]), *command[1:]],
        env=ALONE,
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        timeout=240,
    )


def copied(folder: Path) -> Path:
    """A copy of what is kept of the example, without what a build wrote."""
    return Path(shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("generated", "__pycache__")))


@pytest.fixture(scope="module")
def boat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The example, built: nothing is found."""
    folder = copied(tmp_path_factory.mktemp("example") / "boat")
    done = run(folder, "codegen", "build")
    assert (done.returncode, done.stdout) == (0, ""), done.stdout
    return folder


def test_nothing_is_found(boat: Path) -> None:
    """The example shows nobody a warning, and its requirement documents claim nothing that is not so."""
    done = run(boat, "codegen", "check")
    assert (done.returncode, done.stdout) == (0, ""), done.stdout


def test_a_board_without_machine_code_gets_none(tmp_path: Path) -> None:
    """With `machine_code: false` drivers bring their plain modules alone, and all compiles to bytecode and runs."""
    folder = copied(tmp_path / "boat")
    project = folder / "specs" / "codegen.yaml"
    project.write_text(project.read_text().replace("dialect:", "machine_code: false\ndialect:", 1))
    done = run(folder, "codegen", "build", "--mpy", "bytecode")
    assert (done.returncode, done.stdout) == (0, ""), done.stdout
    assert [*(folder / "generated" / "firmware").rglob("*_viper.py")] == []
    assert (folder / "build" / "bytecode" / "nmea_plain.mpy").exists()
    done = run(folder, "codegen", "sim", "--speed", "max", "--duration", "5", "--quiet", "--out", "udp:127.0.0.1:9")
    assert done.returncode == 0, done.stderr
    assert "GPS_RAW_INT" in done.stdout


def test_its_firmware_passes_the_linter(boat: Path) -> None:
    """The output for another vehicle is as clean as the committed one for the rover."""
    rules = ("--isolated", "--select", "E,F,W,B,PLE", "--ignore", "E402", "--line-length", "120")
    done = run(boat, "ruff", "check", *rules, "generated", "boat.py", "imu.py", "sounder.py", "vane.py")
    assert done.returncode == 0, done.stdout


@pytest.mark.long
def test_its_suite_shows_every_criterion(boat: Path) -> None:
    """The generated suite passes under CPython and MicroPython, and each criterion of the documents is shown by it.

    But for simulated days, and what shows no criterion by CPython and is about modules that every vehicle has: the same
    modules go through that in the rover's own suite.
    """
    left_out = f"{DAYS} or (test_program and cpython and ({COMMON}) and not FR-)"
    options = ("-k", f"not ({left_out})", "--junit-xml=results.xml")
    done = run(boat, "python", "-m", "pytest", *options, "generated/tests")
    assert done.returncode == 0, done.stdout[-4000:]
    traced = run(boat, "codegen", "trace", "--results", "results.xml")
    assert traced.returncode == 0, traced.stdout
    assert "4 requirement documents, 23 criteria" in traced.stdout
    assert re.search(r"^  passed +21$", traced.stdout, re.MULTILINE), traced.stdout


@pytest.mark.long
def test_it_behaves_alike_with_words_of_32_bits(tmp_path: Path) -> None:
    """An ESP32 has words of 32 bits: whole numbers of more than 30 bits are objects on its heap."""
    folder = copied(tmp_path / "boat")
    with (folder / "specs" / "codegen.yaml").open("a") as file:
        file.write("machine_code: false\n")  # what stands in for the board has none
    build(folder)
    generated = folder / "generated"
    path = os.pathsep.join(str(generated / name) for name in ("firmware", "mocks", "tests"))
    for script in ("behaviour", "sources_behaviour", "command_checks", "watched_checks"):
        done = subprocess.run(
            [str(BIN / "micropython32"), "-X", "heapsize=4m", str(generated / "tests" / f"{script}.py")],
            env={**os.environ, "MICROPYPATH": f"{path}{os.pathsep}.frozen"},
            cwd=generated / "tests",
            capture_output=True,
            text=True,
            check=False,
            timeout=120,
        )
        assert done.returncode == 0, done.stderr
        wrong = {name: why for name, why in _checked(done.stdout).items() if why and not why.startswith("left out")}
        assert wrong == {}, script


def _checked(printed: str) -> dict[str, str | None]:
    found: dict[str, str | None] = json.loads(printed)
    assert found
    return found


@pytest.mark.parametrize("scenario", ["nominal", "trip", "no_echo"])
def test_its_scenarios_come_out_as_expected(boat: Path, scenario: str) -> None:
    """Each says itself what is expected of it: positions, depths, modes, texts, and what moves rudder and motor."""
    done = run(boat, "codegen", "sim", scenario, "--speed", "max", "--quiet", "--out", "udp:127.0.0.1:9")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Expected" not in done.stdout
    assert re.search(r"gps\.lon.* told", done.stdout)


def test_a_wrong_expectation_is_found(boat: Path, tmp_path: Path) -> None:
    """A scenario that expects what is not so fails: the ones above could."""
    folder = Path(shutil.copytree(boat, tmp_path / "boat"))
    scenarios = folder / "specs" / "scenarios.yaml"
    scenarios.write_text(
        scenarios.read_text().replace("told: gps.lat, is: 54.3233 deg", "told: gps.lat, is: 54.3234 deg", 1)
    )
    done = run(folder, "codegen", "sim", "nominal", "--speed", "max", "--quiet", "--out", "udp:127.0.0.1:9")
    assert done.returncode == 1
    assert "Expected told gps.lat is 54.3234 deg" in done.stdout
