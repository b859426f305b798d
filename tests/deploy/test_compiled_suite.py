"""The generated suite of the rover passes with the modules that `codegen deploy` compiles in place of their sources."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite
from in_process import build
from rover_alone import without_programs
from whole_program import module_folders

from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE, compiled

ROOT = Path(__file__).resolve().parents[2]
MICROPYTHON = Path(sys.executable).parent / "micropython"
HOST = "x64"
FIRST = '#!/bin/sh\nMICROPYPATH="{folder}:$MICROPYPATH" exec "{micropython}" "$@"\n'
"""A MicroPython that finds the modules of a folder first."""


@pytest.mark.parametrize("architecture", [HOST, BYTECODE])
def test_the_suite_passes_with_compiled_modules(architecture: str, tmp_path: Path) -> None:
    """What the suite and the mocks name keeps its name, as what the user's code names does."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    without_programs(tmp_path / "specs")
    if architecture == BYTECODE:
        with (tmp_path / "specs" / "codegen.yaml").open("a") as settings:
            settings.write("machine_code: false\n")
    build(tmp_path)
    texts = {
        path.name: path.read_text()
        for folder in module_folders(tmp_path / "generated", "firmware")
        for path in folder.glob("*.py")
    }
    around = [
        path.read_text()
        for folder in module_folders(tmp_path / "generated", "mocks", "tests")
        for path in folder.rglob("*.py")
    ]
    report = Report()
    folder = tmp_path / "compiled"
    folder.mkdir()
    for name, content in compiled(texts, architecture, report, unnumbered=texts, beside=around).items():
        if isinstance(content, bytes):
            (folder / name).write_bytes(content)
    assert not report.has_errors
    first = tmp_path / "first"
    first.write_text(FIRST.format(folder=folder, micropython=MICROPYTHON))
    first.chmod(0o755)
    found = "import vehicle; print(vehicle.__file__)"
    path = os.pathsep.join(map(str, [*module_folders(tmp_path / "generated", "firmware", "mocks"), ".frozen"]))
    told = subprocess.check_output([first, "-c", found], env={**os.environ, "MICROPYPATH": path}, text=True)
    assert told.strip() == str(folder / "vehicle.mpy")
    files = ("test_frames.py", "test_behaviour.py", "test_program.py")
    done = run_suite(
        tmp_path / "generated" / "tests", *files, options=("-k", "micropython and not day"), micropython=first
    )
    assert done.returncode == 0, done.stdout[-3000:]
    assert " passed" in done.stdout
