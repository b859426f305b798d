"""The figures on old and new battery messages in docs/rover.md are what their command prints."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.draft("battery_upstream")
def test_the_price_of_both_generations_is_the_one_in_the_document():
    """Every byte per second; the simulation goes by its own clock, so that each run finds the same."""
    shown = re.search(
        r"\$ python (benchmarks/battery_generations.py \w+)\n(.*?)```", (ROOT / "docs/rover.md").read_text(), re.S
    )
    assert shown
    command = [sys.executable, *shown[1].split()]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout == shown[2]
