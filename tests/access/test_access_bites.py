"""The generated checks of signed and listed links notice faults: each of these makes one of them fail."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "guarded"

# A module, a text in it, what takes its place, and one of the checks that then fail.
FAULTS = [
    ("access", "os.urandom(32)", "bytes(32)", "without_a_key_nobody_is_obeyed"),
    ("access", "if len(key) == 32", "if key", "without_a_key_nobody_is_obeyed"),
    ("access", "signing = load(", "signing = Signing(self._key, number)\n            load(", "nothing_counts_twice"),
    ("access", "self._accepted() != self._heard", "False", "nothing_counts_twice"),
    ("access", "passed_ms >= _HEARD_MS", "passed_ms >= 1000", "timestamps_are_kept_seldom"),
    ("access", "passed_ms >= _SENT_MS", "passed_ms >= 1000000", "timestamps_are_kept_seldom"),
    ("access", "        self._heard = self._accepted()\n", "", "timestamps_are_kept_seldom"),
    (
        "access",
        "except OSError as error:\n                self",
        "except TypeError as error:\n                self",
        "a_flash",
    ),
    ("access", "except ValueError as error", "except TypeError as error", "a_flash"),
    ("access", "signing.renew(key, timestamp)", "pass", "a_new_key_comes_over_a_cable"),
    ("access", 'os.rename(self._path + ".new", self._path)', "pass", "a_new_key_comes_over_a_cable"),
    ("key_service", "if not any(key):", "if False:", "no_key_comes_otherwise"),
    ("key_service", 'getattr(vehicle, "is_armed", False)', "False", "no_key_comes_while_armed"),
    ("listed_stations", "system in self._systems", "True", "only_listed_systems_are_heard"),
    ("listed_stations", "self.refused += 1", "pass", "only_listed_systems_are_heard"),
    ("streams", "LONGEST, signing, ", "LONGEST, None, ", "who_has_the_key_is_obeyed"),
    ("vehicle", "signing=self.access.signing(port.name)", "signing=None", "unsigned_frames_are_not_obeyed"),
    ("vehicle", 'if port.name in ("cable",):', "if True:", "no_key_comes_otherwise"),
    ("vehicle", 'if port.name in ("radio",):', "if False:", "only_listed_systems_are_heard"),
    (
        "vehicle",
        "if not self.is_armed:\n                self.access",
        "if True:\n                self.access",
        "nothing_is",
    ),
    ("signing", "elif timestamp <= last:", "elif False:", "nothing_counts_twice"),
    ("signing", "if difference:", "if False:", "unsigned_frames_are_not_obeyed"),
]


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the output of the project."""
    folder = Path(shutil.copytree(PROJECT, tmp_path_factory.mktemp("guarded") / "project"))
    assert main(["build", "--project", str(folder / "specs" / "codegen.yaml")]) == 0
    return folder / "generated"


CHOSEN = """
import json, sys
import access_checks
from program_bench import outcome

chosen = [check for check, *_ in access_checks.CHECKS if check.__name__.startswith(sys.argv[1])]
print(json.dumps({check.__name__: outcome(check) for check in chosen}))
"""


def failed(output: Path, chosen: str = "", *changed: Path) -> set[str]:
    """Return the checks that fail under CPython, of those whose names begin like that.

    Modules in the folder ``changed`` go before those of the output, which stay compiled.
    """
    path = os.pathsep.join(map(str, (*changed, *(output / name for name in ("firmware", "mocks", "tests")))))
    environment = {**os.environ, "PYTHONPATH": path}
    command = [sys.executable, "-c", CHOSEN, chosen]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=True)
    outcomes = json.loads(done.stdout)
    assert outcomes
    return {name for name, problem in outcomes.items() if problem is not None}


def test_none_fails_as_it_is(output: Path) -> None:
    """And none is left out."""
    assert failed(output) == set()


@pytest.mark.parametrize(("module", "text", "fault", "check"), FAULTS)
def test_fault_is_noticed(output: Path, tmp_path: Path, module: str, text: str, fault: str, check: str) -> None:
    """By the check that is about it."""
    right = (output / "firmware" / f"{module}.py").read_text()
    assert text in right
    (tmp_path / f"{module}.py").write_text(right.replace(text, fault, 1))
    assert failed(output, check, tmp_path)
