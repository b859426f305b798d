"""Generated suites pass with words of 32 bits, where a number beyond 30 bits lies on the heap.

What a firmware may allocate, and what wraps, is different there from a host of 64 bits. This MicroPython has no
machine code, so that the projects are built without. Beside the rover there are those with numbers of over 30 bits.
"""

import json
import shutil
from pathlib import Path

import pytest
from generated_suite import run_suite, scripts_of
from in_process import build
from rover_alone import without_programs
from test_interpreter import MICROPYTHON32

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = ("day", "heap", "station", "generation", "announcement", "return", "link", "network", "stop")
"""Simulated days, for which it would take minutes, and what counts nothing that 32 bits would not hold."""
NO_NETWORK = "datagrams_over_the_loopback"  # this MicroPython has none
CHECKS = scripts_of(ROOT / "generated" / "tests").files("tests/*_checks.py")
SCRIPTS = [path.name.removesuffix("_checks.py") for path in CHECKS]
PARTS = 3
"""Processes that share the scripts: each compiles the firmware, and this interpreter is slow."""


@pytest.fixture(scope="module")
def suite(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The suite of the rover."""
    folder = tmp_path_factory.mktemp("rover")
    shutil.copytree(ROOT / "specs", folder / "specs")
    without_programs(folder / "specs")
    return _built(folder)


@pytest.fixture(scope="module")
def bytewise(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The suite of a project with a bytewise parameter of every whole type."""
    folder = tmp_path_factory.mktemp("bytewise")
    shutil.copytree(ROOT / "tests" / "projects" / "guarded" / "specs", folder / "specs")
    return _built(folder)


def _built(folder: Path) -> Path:
    """The suite of a project, built without machine code."""
    with (folder / "specs" / "codegen.yaml").open("a") as settings:
        settings.write("machine_code: false\n")
    build(folder)
    return folder / "generated" / "tests"


@pytest.mark.parametrize("file", ["test_frames.py", "test_behaviour.py"])
def test_suite_passes_with_words_of_32_bits(suite: Path, file: str) -> None:
    """Frames and behaviour."""
    done = run_suite(suite, file, options=("-k", "micropython"), micropython=MICROPYTHON32)
    assert done.returncode == 0, done.stdout[-3000:]


@pytest.mark.long
@pytest.mark.parametrize("part", range(PARTS))
def test_program_passes_with_words_of_32_bits(suite: Path, part: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The program's checks, all but what NO_NETWORK names: none finds anything, as the suite's tests demand of it."""
    hold(suite, [script for script in SCRIPTS if script not in LEFT_OUT][part::PARTS], monkeypatch)


@pytest.mark.parametrize("project", ["rows", "wide_values"])
def test_wide_numbers_with_words_of_32_bits(project: str, tmp_path: Path) -> None:
    """Numbers of up to 64 bits and floats go out as they were set, and allocate nothing."""
    shutil.copytree(ROOT / "tests" / "projects" / project / "specs", tmp_path / "specs")
    tests = _built(tmp_path)
    for file in ("test_frames.py", "test_behaviour.py"):
        done = run_suite(tests, file, options=("-k", "micropython"), micropython=MICROPYTHON32)
        assert done.returncode == 0, done.stdout[-3000:]


def test_bytewise_parameters_with_words_of_32_bits(bytewise: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whole parameters as their bytes, of every type, with numbers beyond those that such a MicroPython has small."""
    hold(bytewise, ["bytewise", "parameter", "storage"], monkeypatch)


def hold(suite: Path, names: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Run the checks of scripts in one process, which compiles the firmware once: none finds anything."""
    monkeypatch.setenv("MICROPYTHON", str(MICROPYTHON32))
    scripts = scripts_of(suite)
    checks = {name: [entry.elts[0].id for entry in scripts.checks_of(f"{name}_checks.py")] for name in names}
    assert all(checks.values())
    asked = [f"{name} {check}" for name in names for check in checks[name] if check != NO_NETWORK]
    told = scripts.run_under("micropython", "checks_run.py", "9", *asked)  # a port of nobody's
    outcomes = dict(map(json.loads, told.splitlines()))
    assert list(outcomes) == asked
    assert not {check: found for check, found in outcomes.items() if found and not found.startswith("left out: ")}
