"""Tracebacks of what `codegen deploy` compiles: generated modules by function, the user's own by line."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.commands.build import firmware_modules
from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE, compiled
from codegen.emit.short_names import TABLE, read_table, readable
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]
OWN = """import messages
from mavlink import Link
from words import number


def broken():
    return number(0, 0, 1, "x")


def sent():
    Link(None, version=1).encode(messages.BatteryStatusV2())
"""
SCRIPT = """
import sys
import rover
try:
    rover.broken()
except TypeError as error:
    sys.print_exception(error)
from state import SystemState
try:
    SystemState().calibrate_battery("much", 7)
except Exception as error:
    sys.print_exception(error)
try:
    rover.sent()
except ValueError as error:
    sys.print_exception(error)
"""


@pytest.fixture
def board(tmp_path: Path) -> Path:
    """A folder with the rover's compiled modules, and one of its user, as they go to a board."""
    shutil.copytree(ROOT / "specs", tmp_path / "project" / "specs")
    table = tmp_path / "project" / "specs" / "codegen.yaml"
    table.write_text(table.read_text() + "machine_code: false\n")
    report = Report()
    system = read_systems(str(table), report)[0]
    assert system is not None
    assert not report.has_errors
    texts = firmware_modules(system, BYTECODE)
    folder = tmp_path / "board"
    folder.mkdir()
    for path, content in compiled({**texts, "rover.py": OWN}, BYTECODE, report, unnumbered=texts).items():
        (folder / path).write_bytes(content.encode() if isinstance(content, str) else content)
    assert not report.has_errors
    return folder


def test_tracebacks_name_functions_of_generated_modules_and_lines_of_own_ones(board: Path) -> None:
    """A failure within a generated module is found by the function, where it is private by the file beside the modules;
    one in the user's call, by the line.
    """
    command = [str(Path(sys.executable).parent / "micropython"), "-c", SCRIPT]
    done = subprocess.run(command, cwd=board, capture_output=True, text=True, check=True)
    said = done.stdout + done.stderr
    assert re.search(r'File "rover", line 7, in broken', said), said
    assert re.search(r'File "rover", line 11, in sent', said), said
    assert re.search(r'File "part_\d+", line 1, in calibrate_battery', said), said
    named = re.findall(r'^ *File "part_\d+", line 1, in \w+$', said, re.MULTILINE)
    names = read_table((board / TABLE).read_text())
    told = [re.split(r"[ |]", readable(line, names)) for line in named]
    assert any("frames_plain._write_frame" in words for words in told), said
