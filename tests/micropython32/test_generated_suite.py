"""Generated suites pass with words of 32 bits, where a number beyond 30 bits lies on the heap.

What a firmware may allocate, and what wraps, is different there from a host of 64 bits. This MicroPython has no
machine code, so that the projects are built without. Beside the rover there are those with numbers of over 30 bits.
"""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite
from test_interpreter import MICROPYTHON32

ROOT = Path(__file__).resolve().parents[2]
LONG = ("day", "heap")  # simulated days, for which it would take minutes: 64 bits go through them
NO_NETWORK = "datagrams_over_the_loopback"  # this MicroPython has none
SCRIPTS = sorted(path.name.removesuffix("_checks.py") for path in (ROOT / "generated" / "tests").glob("*_checks.py"))
PARTS = [
    ("test_frames.py", "micropython"),
    ("test_behaviour.py", "micropython"),
    *(("test_program.py", f"micropython-{script}-") for script in SCRIPTS if script not in LONG),
]


@pytest.fixture(scope="module")
def suite(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The suite of the rover."""
    return _built(ROOT, tmp_path_factory.mktemp("rover"))


def _built(project: Path, folder: Path) -> Path:
    """The suite of a project, built without machine code."""
    shutil.copytree(project / "specs", folder / "specs")
    with (folder / "specs" / "codegen.yaml").open("a") as settings:
        settings.write("machine_code: false\n")
    subprocess.run([sys.executable, "-m", "codegen", "build"], cwd=folder, check=True, capture_output=True)
    return folder / "generated" / "tests"


@pytest.mark.parametrize(("file", "only"), PARTS, ids=[f"{file}-{only}" for file, only in PARTS])
def test_suite_passes_with_words_of_32_bits(suite: Path, file: str, only: str) -> None:
    """Frames, behaviour, and the program's checks, all but what LONG and NO_NETWORK name."""
    options = ("-k", f"{only} and not {NO_NETWORK}")
    done = run_suite(suite, file, options=options, micropython=MICROPYTHON32)
    assert done.returncode == 0, done.stdout[-3000:]


@pytest.mark.parametrize("project", ["rows", "wide_values"])
def test_wide_numbers_with_words_of_32_bits(project: str, tmp_path: Path) -> None:
    """Numbers of up to 64 bits and floats go out as they were set, and allocate nothing."""
    tests = _built(ROOT / "tests" / "projects" / project, tmp_path)
    for file in ("test_frames.py", "test_behaviour.py"):
        done = run_suite(tests, file, options=("-k", "micropython"), micropython=MICROPYTHON32)
        assert done.returncode == 0, done.stdout[-3000:]
