"""Inputs of the converter that fail: how often that is told, in which words, and that they come back.

The firmware of the rover runs on MicroPython with its mocks, in one process for all of it.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import module_folders

ROOT = Path(__file__).resolve().parents[2]

SCRIPT = """
import json
import mock_time
mock_time.install()
import machine
from mock_board import MockBoard
from state import SystemState
told = []
found = {}

def started(**settings):
    del told[:]
    mock_time.set_ticks_us(0)
    board = MockBoard(log=lambda *words: told.append(" ".join(str(word) for word in words)), **settings)
    return board, SystemState(log=lambda *words: None)

def passes(board, state, turns, each):
    for turn in range(turns):
        each(turn)
        state.update_battery(board)
        mock_time.advance_us(100000)

board, state = started()
passes(board, state, 600, lambda turn: board.fail_adc(turn % 2))
found["every second"] = list(told)

board, state = started()
board.set_adc_value(3000)
board.fail_adc(1)
state.update_battery(board)
board.delay_adc(401)
state.update_battery(board)
state.update_battery(board)
found["late behind a failure"] = list(told)

board, state = started(absent=True)
passes(board, state, 250, lambda turn: None)
machine.analog(26).absent = False
board.set_adc_value(3000)
passes(board, state, 100, lambda turn: None)
found["absent"] = list(told)
found["back"] = state.battery[0].voltage_mv

board, state = started()
found["refused"] = []
for count in (-1, 4096, 5000):
    try:
        board.set_adc_value(count)
    except ValueError as error:
        found["refused"].append(str(error))

class Broken:
    def read_battery_adc(self, instance=0):
        raise MemoryError

said = []
state = SystemState(log=lambda *words: said.append(" ".join(str(word) for word in words)))
state.update_battery(Broken())
found["without words"] = said
print(json.dumps(found))
"""


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[str]]:
    """Return the texts, by the event that they are about."""
    script = tmp_path_factory.mktemp("faults") / "faults.py"
    script.write_text(SCRIPT)
    command = [str(Path(sys.executable).with_name("micropython")), str(script)]
    path = {"MICROPYPATH": os.pathsep.join(map(str, module_folders(ROOT / "generated", "firmware", "mocks")))}
    done = subprocess.run(command, env={**os.environ, **path}, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: dict[str, list[str]] = json.loads(done.stdout)
    return found


@pytest.mark.requirement("FR-00066.4")
def test_texts_are_limited_in_rate(found):
    """300 failures in a minute are six texts, the first at once, the others with what was left out: each 10 s one."""
    assert found["every second"] == [
        "error: battery 1's ADC cannot be read",
        *["error: battery 1's ADC cannot be read (49 more)"] * 5,
    ]


@pytest.mark.requirement("NFR-00060.2")
def test_the_first_late_reading_is_told_in_any_case(found):
    """A failure just before does not hide it; a second one waits."""
    assert found["late behind a failure"] == [
        "error: battery 1's ADC cannot be read",
        "error: battery 1's ADC took too long to read, in us: 2005",
    ]


@pytest.mark.requirement("FR-00066.5")
def test_an_absent_input_is_told_in_one_text_and_set_up_again(found):
    """The input is named for an operator to look at; the text fits a STATUSTEXT, and the next try has it back."""
    absent = "warning: no ADC for battery 1 on GPIO 26"
    assert found["absent"] == [
        absent,
        f"{absent} (100 more)",
        f"{absent} (99 more)",
        "notice: battery 1 is read on GPIO 26 again (99 more)",
    ]
    assert all(len(text.partition(": ")[2]) <= 50 for text in found["absent"])
    assert found["back"] == 9549


def test_the_mock_refuses_counts_that_there_are_not(found):
    """5000 is no count of 12 bits: a test that sets it is wrong."""
    assert found["refused"] == [f"an ADC of 12 bits does not read {count}" for count in (-1, 4096, 5000)]


@pytest.mark.requirement("FR-00067.5")
def test_an_exception_without_words_is_told_by_its_name(found):
    """A MemoryError has no text."""
    assert found["without words"] == ["error: the board cannot read battery 1: MemoryError"]
