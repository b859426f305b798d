"""A board with the sources: lines of the user's code are told, those of generated modules are not kept."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import whole_program

ROOT = Path(__file__).resolve().parents[2]
OWN = """from vehicle import Vehicle


class Rover(Vehicle):
    def control(self):
        self.parameters.set("SYSID_THISMAV", "many")
"""
SCRIPT = """
import sys
import mock_time
mock_time.install()
import micropython
micropython.opt_level(1)
import main
vehicle = main.vehicle_class()()
try:
    vehicle.control()
except Exception as error:
    sys.print_exception(error)
print("level", micropython.opt_level())
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> str:
    """What MicroPython says when control() fails in a generated module."""
    folder = tmp_path_factory.mktemp("lines")
    program = whole_program(ROOT / "generated", folder)
    (folder / "rover.py").write_text(OWN)
    path = os.pathsep.join(str(each) for each in (".frozen", folder, program / "firmware", program / "mocks"))
    done = subprocess.run(
        [str(Path(sys.executable).parent / "micropython"), "-c", SCRIPT],
        env={**os.environ, "MICROPYPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout + done.stderr


def test_a_traceback_tells_the_line_of_the_users_code(told: str) -> None:
    assert re.search(r'File ".*rover\.py", line 6, in control', told), told


def test_a_traceback_tells_the_functions_of_generated_modules(told: str) -> None:
    """But not their lines: the numbers of all of them would lie on the heap."""
    found = re.findall(r'File ".*firmware/\w+\.py", line (\d+), in \w+', told)
    assert set(found) == {"1"}, told


def test_what_is_imported_later_is_compiled_as_it_was(told: str) -> None:
    assert "level 1" in told
