"""The smart battery of the shipped specification does what FR-00074 says, under both interpreters."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BATTERY = ROOT / "generated" / "smart_battery"
PATHS = [str(BATTERY / name) for name in ("firmware", "mocks", "tests")]


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_the_battery_behaves(interpreter):
    """HEARTBEAT, ids, rates, no arming, saves, measure()."""
    python = sys.executable if interpreter == "cpython" else str(Path(sys.executable).with_name("micropython"))
    path = os.pathsep.join([*PATHS, ".frozen"])
    done = subprocess.run(
        [python, str(Path(__file__).with_name("battery_checks.py"))],
        capture_output=True,
        text=True,
        env=os.environ | {"MICROPYPATH": path, "PYTHONPATH": path},
        timeout=100,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    outcomes = json.loads(done.stdout)
    assert len(outcomes) >= 10
    assert {name: outcome for name, outcome in outcomes.items() if outcome is not None} == {}
