"""Where a compiler does not take the machine code, or a part of it, the firmware runs in plain Python."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite
from whole_program import whole_program

ROOT = Path(__file__).resolve().parents[2]
MICROPYTHON = Path(sys.executable).with_name("micropython")
FAULTS = {
    "ViperTypeError": "def lacking(a: int) -> int:\n    return a + 'x'\n",
    "NotImplementedError": "def lacking(a: int):\n    yield a\n",
    "SyntaxError": "def lacking(a: int) -> 5:\n    return a\n",
}


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """The folder of a program with firmware, mocks and tests."""
    folder = tmp_path / "program"
    whole_program(ROOT / "generated", folder)
    return folder


def break_machine_code(firmware: Path, fault: str) -> int:
    """Put a function with a fault into each module of machine code; return how many there are."""
    modules = list(firmware.glob("*_viper.py"))
    for module in modules:
        module.write_text(module.read_text() + "\n\nimport micropython\n@micropython.viper\n" + fault)
    return len(modules)


def under_micropython(program: Path, code: str) -> subprocess.CompletedProcess[str]:
    """Run code with the firmware and the mocks."""
    path = os.pathsep.join([*(str(program / part) for part in ("firmware", "mocks")), ".frozen"])
    command = [str(MICROPYTHON), "-X", "heapsize=2m", "-c", "import mock_time; mock_time.install()\n" + code]
    return subprocess.run(command, env={**os.environ, "MICROPYPATH": path}, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("kind", FAULTS)
def test_a_part_of_viper_that_is_missing_is_survived(program: Path, kind: str) -> None:
    """Every module of the program is imported, and a message is built by the plain one."""
    assert break_machine_code(program / "firmware", FAULTS[kind]) > 5
    raised = under_micropython(program, "import frames_viper")
    assert kind in raised.stdout + raised.stderr
    names = [path.stem for path in (program / "firmware").glob("*.py") if not path.stem.endswith("_viper")]
    code = "".join(f"import {name}\n" for name in sorted(names) if name != "boot")
    done = under_micropython(program, code + "print(telemetry.build_battery_status)\n")
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_generated_suite_notices_machine_code_that_does_not_compile(program: Path) -> None:
    break_machine_code(program / "firmware", FAULTS["ViperTypeError"])
    done = run_suite(program / "tests", "test_counterparts.py", options=("-k", "machine_code", "--assert=rewrite"))
    assert done.returncode == 1, done.stdout
    assert "ViperTypeError" in done.stdout
