"""docs/your-own-vehicle.md: from an empty folder, word by word, to the output that it shows."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import ALONE, COMMON

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
HEAD = re.compile(r"(?:# |<!-- )([\w./-]+\.(?:yaml|py|md))(, at the end)?(?: -->)?\n")

LEFT_OUT = f"test_program and (cpython or {COMMON}) and not FR-"
"""What every project's suite has, and tests/projects/test_projects.py runs, but for what shows a criterion."""


@pytest.mark.long
def test_the_page_leads_to_what_it_shows(tmp_path: Path) -> None:
    """Its files go where their first line says; its commands succeed without a finding, and print what it prints."""
    folder, printed, shown = tmp_path, "", []
    for kind, text in BLOCK.findall((ROOT / "docs" / "your-own-vehicle.md").read_text()):
        if kind == "console":
            printed = run(text, folder)
            folder = tmp_path / "boat"
        elif kind == "text":
            shown.append((text, printed))
        else:
            put(text, folder)
    assert [printed for _, printed in shown] == [text for text, _ in shown]
    assert len(shown) == 2
    assert "Shallow water: 1." in shown[0][0]


def put(text: str, folder: Path) -> None:
    """A block goes into the file of its first line, or to the end of it."""
    head = HEAD.match(text)
    assert head is not None, text
    path = folder / head[1]
    path.parent.mkdir(exist_ok=True)
    with path.open("a" if head[2] else "w") as file:
        file.write(text[head.end() :])


def run(commands: str, folder: Path) -> str:
    """Return the output of commands. A simulation sends to nobody; LEFT_OUT is not run."""
    for old, new in (
        ("pip install pytest\n", ""),
        ("--speed max", "--speed max --out udp:127.0.0.1:9"),
        (
            "pytest generated",
            f"pytest -p no:cacheprovider -k 'not ({LEFT_OUT})' >/dev/null generated",
        ),
    ):
        commands = commands.replace(old, new)
    environment = {**ALONE, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(
        ["bash", "-ec", commands], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.replace("udp:127.0.0.1:9", "udp:127.0.0.1:14550")
