"""The generated checks of sensors notice faults: what asks them, keeps and loses their values is changed in turn."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "sensors"

# A module, a text in it, what takes its place, and one of the checks that then fail.
FAULTS = [
    ("polling", "_DOWN_AFTER = const(3)", "_DOWN_AFTER = const(4)", "sonar-set_up_again"),
    ("polling", "_PAUSE_MS = const(10000)", "_PAUSE_MS = const(1000)", "sonar-few_texts"),
    ("polling", "if took_us > self._limit_us:", "if took_us >= self._limit_us:", "sonar-takes_too_long"),
    ("polling", "self._lose(self._words, self.failures)\n", "pass\n", "sonar-failures"),
    ("polling", "self.failures = 0\n        if self._is_told", "if self._is_told", "sonar-failures"),
    ("polling", "            self._is_told = True\n", "            pass\n", "sonar-failures"),
    ("polling", "time.ticks_add(now_ms, self._retry_ms)", "time.ticks_add(now_ms, 9)", "sonar-set_up_again"),
    ("polling", "self.longest_us = took_us\n", "pass\n", "imu-takes_too_long"),
    ("polling", 'return "memory is full"', 'return ""', "imu-strange_errors"),
    ("listening", "<= self._silence_ms", "<= 100 * self._silence_ms", "receiver-silence"),
    ("listening", "self._calls[self._place] = self.turn\n", "pass\n", "receiver-silence"),
    ("listening", "self._calls[self._place] = self.driver.waiting\n", "pass\n", "receiver-silence"),
    ("sources", "value // 10 + (value % 10 + 5) // 10", "value // 10", "sonar-ends"),
    ("sources", "-(value // 8 + (value % 8 + 4) // 8)", "(value // 8 + (value % 8 + 4) // 8)", "power-ends"),
    ("sources", "if 200 <= value <= 40000:", "if 200 <= value <= 40001:", "sonar-ends"),
    ("sources", "if failures >= 3:", "if failures >= 4:", "sonar-failures"),
    ("sources", "now_ms - 1073740824 &", "now_ms - 1073740823 &", "sonar-grows_old"),
    ("sources", "_LON_DEGE7 + 1] = values[4]", "_LON_DEGE7 + 1] = values[3]", "receiver-ends"),
    ("sources", "if new & 4:", "if new & 1024:", "receiver-ends"),
    ("user_source", "                self.values[at] = UNKNOWN\n", "                pass\n", "imu-what_code_gives"),
    ("user_source", "if steps is None or not", "if steps is not None and not", "sonar-what_code_gives"),
    (
        "user_source",
        "            self.values[place] = UNKNOWN\n        elif",
        "            pass\n        elif",
        "sonar-what_code_gives",
    ),
]


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = Path(shutil.copytree(PROJECT, tmp_path_factory.mktemp("bites") / "project"))
    assert main(["build", "--project", str(folder / "specs" / "codegen.yaml")]) == 0
    return folder / "generated"


def failed(output: Path, *changed: Path) -> set[str]:
    """The checks that fail, under CPython; modules in ``changed`` go before those of the output, which are compiled."""
    path = os.pathsep.join(map(str, (*changed, *(output / name for name in ("firmware", "mocks", "tests")))))
    environment = {**os.environ, "PYTHONPATH": path}
    command = [sys.executable, str(output / "tests" / "sources_behaviour.py")]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=True)
    return {name for name, problem in json.loads(done.stdout).items() if problem is not None}


def test_none_fails_as_it_is(output: Path) -> None:
    assert failed(output) == set()


@pytest.mark.parametrize(("module", "text", "fault", "check"), FAULTS, ids=[fault[1].strip()[:50] for fault in FAULTS])
def test_is_noticed(output: Path, tmp_path: Path, module: str, text: str, fault: str, check: str) -> None:
    right = (output / "firmware" / f"{module}.py").read_text()
    assert text in right
    (tmp_path / f"{module}.py").write_text(right.replace(text, fault, 1))
    assert check in failed(output, tmp_path)
