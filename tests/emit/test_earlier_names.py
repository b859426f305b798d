"""Values stored under a parameter's name in earlier firmware are taken over, in the unit of today."""

import json
import shutil
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import codegen
from whole_program import whole_program

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """
import json
from parameters import Parameters
taken = Parameters()
problems = taken.restore(bytes.fromhex({stored!r}))
again = Parameters()
again.restore(taken.dump())
print(json.dumps([problems, taken.batt_volt_mult, taken.batt2_volt_mult, taken.sysid_thismav, again.batt2_volt_mult]))
"""


def record(name: str, value: float) -> bytes:
    """A parameter as it is stored."""
    return bytes([len(name)]) + name.encode() + struct.pack("<f", value)


def built(folder: Path, **was: str) -> "subprocess.CompletedProcess[str]":
    """Build the rover in a folder, with earlier names of parameters."""
    shutil.copytree(ROOT / "specs", folder / "specs")
    written = folder / "specs" / "parameters.yaml"
    text = written.read_text()
    for name, names in was.items():
        assert text.count(f"  {name}:\n") == 1
        text = text.replace(f"  {name}:\n", f"  {name}:\n    was: {names}\n")
    written.write_text(text)
    return codegen(folder, "build", "--project", "specs/codegen.yaml")


@pytest.fixture(scope="module")
def firmware(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The rover's, where the multiplier was half as much and called otherwise, and SYSID_THISMAV once SYS_ID."""
    folder = tmp_path_factory.mktemp("earlier")
    done = built(folder, BATT_VOLT_MULT="{BATT_DIVIDER: 2}", SYSID_THISMAV="{SYS_ID: 1}")
    assert done.returncode == 0, done.stdout + done.stderr
    return whole_program(folder / "generated", folder / "whole") / "firmware"


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_stored_values_are_taken_over(firmware: Path, interpreter: str) -> None:
    """Of each instance, multiplied, and stored under the new name from then on; what is not acceptable is told."""
    stored = record("BATT_DIVIDER", 2.1) + record("BATT2_DIVIDER", 1.9) + record("SYS_ID", 300)
    script = SCRIPT.format(stored=stored.hex())
    command = [str(Path(sys.executable).parent / interpreter), "-c", script]
    done = subprocess.run(command, cwd=firmware, capture_output=True, text=True, check=True)
    problems, first, second, system_id, again = json.loads(done.stdout)
    assert problems == ["stored SYSID_THISMAV = 300.0 is not accepted"]
    assert (first, second, system_id, again) == (42000, 38000, 1, 38000)


def test_a_name_is_taken_over_by_one_only(tmp_path: Path) -> None:
    """A stored value belongs to one parameter."""
    done = built(tmp_path, SR0_EXTRA1="{SR0_ALL: 1}", SR0_EXTRA3="{SR0_ALL: 1}")
    assert done.returncode == 1
    assert ": error bad-parameter: SR0_ALL is also what SR0_EXTRA1 was called\n" in done.stdout
