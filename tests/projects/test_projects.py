"""Other projects than the rover: each is built as it is, and its generated suite is green on both interpreters.

minimal has neither sensors nor machine code. two_batteries has what the rover does not: several instances, an
overlay's message with float fields, scaling with each rounding, parameters as sources, texts, elements answered one by
one, limits as amounts, and a converter of 10 bits.
"""

import subprocess
import sys
from pathlib import Path

import pytest

PROJECTS = Path(__file__).resolve().parent


@pytest.mark.parametrize("project", sorted(path.parent.name for path in PROJECTS.glob("*/specs")))
def test_project_builds_and_its_suite_is_green(project, tmp_path):
    """No error while building; no failed test in the output, and lint finds nothing in the firmware."""
    subprocess.run(["cp", "-r", str(PROJECTS / project / "specs"), str(tmp_path)], check=True)
    codegen = Path(sys.executable).with_name("codegen")
    built = subprocess.run([str(codegen), "build"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stdout
    options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist"]
    command = [sys.executable, "-m", "pytest", *options, "generated/tests"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-3000:]
    lint = [
        str(codegen.with_name("ruff")),
        "check",
        "--select",
        "E,F,W,B,PLE",
        "--line-length",
        "120",
        "--ignore",
        "E402",
    ]
    checked = subprocess.run([*lint, "generated"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout
