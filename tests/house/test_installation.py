"""What the documents say about copying the firmware: the commands reach each module of a program, and nothing else."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
COPY = re.compile(r"^ *mpremote cp (.*) :$", re.MULTILINE)


@pytest.mark.parametrize(("page", "program"), [("rover.md", "."), ("smart-battery.md", "smart_battery")])
def test_what_is_copied_is_the_whole_program(built: Path, page: str, program: str) -> None:
    """mpremote stops at a folder, so that none may be among what the shell makes of the patterns."""
    text = (ROOT / "docs" / page).read_text()
    (architecture,) = set(re.findall(r"codegen build --mpy (\w+)\n", text))
    (patterns,) = COPY.findall(text)
    command = [sys.executable, "-m", "codegen", "build", "--mpy", architecture]
    subprocess.run(command, cwd=built, check=True, capture_output=True)
    copied = [path for pattern in patterns.split() for path in built.glob(pattern)]
    modules = {path.stem for path in (built / "generated" / program / "firmware").glob("*.py")}
    assert all(path.is_file() for path in copied)
    assert {path.stem for path in copied} == modules
    assert {path.parent for path in copied} == {built / "build" / architecture / program}
    assert [path.name for path in copied if path.suffix == ".py"] == ["main.py"]  # which the board starts by its name
