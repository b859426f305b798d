"""The generated suite leaves MicroPython a heap for projects of many times the size of any here."""

import json
import shutil
from pathlib import Path

import pytest
from generated_suite import scripts_of
from in_process import build

ROWS = Path(__file__).parent / "rows" / "specs"
TIMES = 32
"""So many times this project has room."""
NUMBERS = tuple(map(str, range(150)))


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with messages and lists of every type."""
    folder = tmp_path_factory.mktemp("rows")
    shutil.copytree(ROWS, folder / "specs")
    build(folder)
    return folder / "generated" / "tests"


def test_a_small_part_of_the_heap_is_enough(project: Path) -> None:
    """What is compiled grows with the specification: a MemoryError would be no fault of the firmware."""
    scripts = scripts_of(project)
    part = f"{int(scripts.HEAP.removesuffix('m')) * 1024 // TIMES}k"
    told = json.loads(scripts.run_under("micropython", "behaviour.py", heap=part))
    assert len(told) > 10
    assert set(told.values()) == {None}


def test_what_was_told_takes_no_heap(project: Path) -> None:
    """There are as many steps as there are messages, times the numbers that anything is compared with."""
    given = (*NUMBERS, "of", "limits")
    told = json.loads(scripts_of(project).run_under("micropython", "counterparts_run.py", *given, heap="384k"))
    assert len(told["limits"]) > 2000
