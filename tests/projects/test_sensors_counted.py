"""The sum of a polled sensor's values is the nearest to the exact one, whatever happens in between."""

import json
import subprocess
import sys
from fractions import Fraction
from math import ceil, floor
from pathlib import Path

import pytest
from in_process import build

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
DAYS = 3
STEPS_MS = (7, 100, 100, 1900, 20000, 59999, 60000, 60001, 40000, 3)
HALF = Fraction(1, 2)


DIVIDER = "{driver: adc, gpio: 26, multiplier: 5, samples: 2, rate: 10 Hz}"
SEEN = """\
      divided: {doc: Voltage., unit: V, stored: mV, source: divider, stale_after: 1 s}
      absent: {doc: Whether no pack is there., boolean: true, follows: divided, below: 1}
      swaps: {doc: How often one was put in., counts_returns_of: absent, initial: 0, min: 0, max: 1000}
"""

# Worked out by hand: 659 mAh last 2372 s at 1 A and 1186 s at 2 A.
LAST = {
    "drawn": [659, 1, 2372, 99341],  # of 100000 mAh, whatever the parameter is now
    "just believed": [659, 1, 2372],
    "too old": [None, None, None],
    "begins anew": [659, 1, 1186],  # without the mean from before the gap, which is not counted
    "charged": [670, 1, None, 99330],  # 40 s of -1 A are 11 mAh
    "before": [669, 1, 3168],  # four failures; after 20 readings the mean is 0.757 A, 76 cA
    "lost": [None, None, None],
}


@pytest.fixture(scope="module")
def sensors(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built; its pack may be silent for a minute, which makes days short."""
    folder = tmp_path_factory.mktemp("counted")
    parts = [str(HERE / "sensors" / name) for name in ("specs", "days.py")]
    subprocess.run(["cp", "-r", *parts, str(folder)], check=True)
    state = folder / "specs" / "state.yaml"
    lines = state.read_text().splitlines()
    lines = [
        line.replace("stale_after: 1 s", "stale_after: 60 s") if "source: power." in line else line for line in lines
    ]
    state.write_text("\n".join(lines) + "\n")
    build(folder)
    return folder


@pytest.fixture(scope="module")
def exchanged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project with another voltage of its pack, which an ADC measures, so that it is seen when one is put in."""
    folder = tmp_path_factory.mktemp("exchanged")
    parts = [str(HERE / "sensors" / name) for name in ("specs", "exchanged.py")]
    subprocess.run(["cp", "-r", *parts, str(folder)], check=True)
    board, state = folder / "specs" / "board.yaml", folder / "specs" / "state.yaml"
    board.write_text(board.read_text().replace("  power:\n", f"  divider: {DIVIDER}\n  power:\n", 1))
    text = state.read_text().replace("integral_of: current}", "integral_of: current, restarts_with: swaps}")
    state.write_text(text.replace("      consumed:", f"{SEEN}      consumed:"))
    build(folder)
    return folder


def nearest(value: Fraction) -> int:
    """A half away from zero, as what sensors give is rounded."""
    return floor(value + HALF) if value >= 0 else ceil(value - HALF)


def by_fractions(days: int) -> list[list[int]]:
    """Return the expected counts: exact sums of the rounded values, each for the time since the one before.

    More than 60 s are a gap, so is a value that cannot be, and so are failures from the fifth on; of the energy every
    turn without a voltage.
    """
    charge = energy = Fraction(0)
    number, turn, passed_ms, failures = 1, 0, 0, 0
    since_ms: int | None = None
    counted: list[list[int]] = []
    while len(counted) < days:
        number = (number * 1103 + 12345) % 65536
        turn += 1
        passed_ms += 2000 if turn % 500 < 8 else STEPS_MS[number % 10]
        if turn % 500 < 6 or number % 13 == 0:
            failures += 1
            since_ms = None if failures >= 5 else since_ms
        elif number % 17:
            failures = 0
            amperes = nearest(Fraction((number * 7 % 8000 - 2000) * 10, 80))  # 2.5 uV across 2 mOhm, in cA
            volts = nearest(Fraction((9000 + number % 800) * 5, 4))
            if number % 23 == 0:
                since_ms = None
            else:
                if since_ms is not None and passed_ms - since_ms <= 60000:
                    hours = Fraction(passed_ms - since_ms, 3600000)
                    charge += amperes * 10 * hours
                    energy += 0 if number % 19 == 0 else Fraction(amperes, 100) * Fraction(volts, 1000) * hours * 36
                since_ms = passed_ms
        if passed_ms >= (len(counted) + 1) * 86400000:
            counted.append([turn, floor(charge + HALF), floor(energy + HALF)])
    return counted


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_is_counted_does_not_drift(sensors: Path, interpreter: str) -> None:
    """After every day charge and energy are the nearest to their exact sums, and a turn takes no memory.

    What is left, and how long it lasts, goes with the last value.
    """
    command = [str(BIN / interpreter), "days.py", str(DAYS)]
    done = subprocess.run(command, cwd=sensors, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    counted, allocated, last = json.loads(done.stdout)
    assert [each[:3] for each in counted] == by_fractions(DAYS)
    assert counted[0][1] > 1000
    assert [each[3] for each in counted] == [100000 - each[1] for each in counted]
    assert allocated == 0
    assert last == LAST


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_it_begins_anew_with_what_an_adc_sees(exchanged: Path, interpreter: str) -> None:
    """10 A are 1 mAh in 0.36 s: 111 in 40 s less the first turn; from 0 with the new pack, and 100 in 36 s."""
    command = [str(BIN / interpreter), "exchanged.py"]
    done = subprocess.run(command, cwd=exchanged, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == [[0, 111, 3189], [0, 112, 3188], [1, 0, 3300], [1, 100, 3200]]
