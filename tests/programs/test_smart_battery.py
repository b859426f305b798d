"""The smart battery of the shipped specification does what its document says, under both interpreters."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import module_folders

ROOT = Path(__file__).resolve().parents[2]
PATHS = [*map(str, module_folders(ROOT / "generated", "firmware", "mocks", "tests", program="smart_battery"))]


def run(interpreter, folders, script, *arguments, given="", seconds=100):
    """Return the output of a script beside this file, with the generated folders on its path."""
    python = sys.executable if interpreter == "cpython" else str(Path(sys.executable).with_name("micropython"))
    path = os.pathsep.join([*folders, ".frozen"])
    done = subprocess.run(
        [python, str(Path(__file__).with_name(script)), *arguments],
        capture_output=True,
        text=True,
        input=given,
        env=os.environ | {"MICROPYPATH": path, "PYTHONPATH": path},
        timeout=seconds,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.draft("battery_upstream")
@pytest.mark.requirement(
    "FR-00074.1", "FR-00074.2", "FR-00074.3", "FR-00074.4", "FR-00074.6", "FR-00074.7", "FR-00074.9"
)
@pytest.mark.requirement("FR-00074.10")
@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_the_battery_behaves(interpreter):
    """HEARTBEAT, ids and who else uses them, rates, info, serial number, no arming, saves, measure()."""
    outcomes = json.loads(run(interpreter, PATHS, "battery_checks.py"))
    assert len(outcomes) >= 18
    assert {name: outcome for name, outcome in outcomes.items() if outcome is not None} == {}


@pytest.mark.requirement("FR-00074.5")
@pytest.mark.parametrize("choice", [0, 1], ids=["old", "new"])
def test_a_receiver_notices_that_it_was_exchanged(choice):
    """Another serial number in the info that the new one sends when it starts, in either generation."""
    packs = (("first...", 2500), ("second..", 10))
    frames = "".join(
        run("cpython", PATHS, "exchange_frames.py", chip, str(drawn_mah), str(choice)) for chip, drawn_mah in packs
    )
    seen = json.loads(run("cpython", [str(ROOT / "generated" / "receiver")], "exchange_seen.py", given=frames))
    serials = [chip.encode().hex() for chip, _ in packs]
    assert [(serial, swaps) for serial, swaps, _ in seen] == [(serials[0], 0), (serials[1], 1)]
    assert [consumed for _, _, consumed in seen] == pytest.approx([2500, 10])
